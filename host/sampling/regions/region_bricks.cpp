#include "host/sampling/regions/region_bricks.hpp"

#include "host/sampling/cells/cells_around.hpp"

#include <algorithm>
#include <bit>
#include <type_traits>
#include <utility>

namespace poissonlab {
namespace {

static_assert(contract::dart_throwing::NO_BRICK == no_cell_around);

/// Bricks of a region are found by halves, from the whole box on. They come in the order of these, along a curve that
/// goes from neighbours to neighbours mostly: what lies close together is close together in memory.
template <typename Region>
class BrickFinder
{
public:
    using Box = std::remove_cvref_t<decltype(std::declval<const Region&>().extent())>;
    using Corner = decltype(Box::low);
    static constexpr int D = std::tuple_size_v<Corner>;

    BrickFinder(const Region& region, const CellHierarchy& cells, std::size_t most)
        : region_(region), cells_(cells), most_(most), side_(brick_side(D))
    {}

    std::shared_ptr<const DartBricks> find()
    {
        const std::uint32_t along = cells_.cell_of(0x7fffffff) / side_ + 1;
        if (!visit({}, std::bit_ceil(along))) return nullptr;
        auto bricks = std::make_shared<DartBricks>();
        bricks->dimension = D;
        for (const Corner& corner : found_)
            for (const std::uint32_t c : corner) bricks->corners.push_back(c * side_);
        bricks->around = numbers_around(found_);
        return bricks;
    }

private:
    /// Looks at a cube of bricks. Returns false where there are too many.
    bool visit(const Corner& corner, std::uint32_t size)
    {
        Box box;
        for (std::size_t k = 0; k < D; ++k) {
            const std::uint64_t first = std::uint64_t{corner[k]} * side_, end = first + std::uint64_t{size} * side_;
            if (first >= cells_.size) return true;
            const std::uint64_t low = cells_.lower_bound(first, 0);
            const std::uint64_t high = cells_.lower_bound(std::min<std::uint64_t>(end, cells_.size), 0) - 1;
            if (low >> FixedRegion::coordinate_bits != 0) return true;
            box.low[k] = static_cast<std::uint32_t>(low);
            box.high[k] = static_cast<std::uint32_t>(high);
        }
        if (region_.side_of(box) == RegionSide::outside) return true;
        if (size == 1) {
            found_.push_back(corner);
            return found_.size() <= most_;
        }
        for (std::uint32_t child = 0; child < 1u << D; ++child) {
            Corner half = corner;
            for (std::size_t k = 0; k < D; ++k) half[k] += (child >> k & 1) * size / 2;
            if (!visit(half, size / 2)) return false;
        }
        return true;
    }

    const Region& region_;
    const CellHierarchy& cells_;
    std::size_t most_;
    std::uint32_t side_;        ///< cells of a brick along each axis
    std::vector<Corner> found_; ///< in bricks
};

}

std::shared_ptr<const DartBricks> bricks_of(const FixedRegion& region, const CellHierarchy& cells, std::size_t most)
{
    return BrickFinder(region, cells, most).find();
}

std::shared_ptr<const DartBricks> bricks_of(const FixedSpace& space, const CellHierarchy& cells, std::size_t most)
{
    return BrickFinder(space, cells, most).find();
}

}
