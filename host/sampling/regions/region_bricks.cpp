#include "host/sampling/regions/region_bricks.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
#include <type_traits>
#include <utility>

namespace poissonlab {
namespace {

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
        link(*bricks);
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

    /// Corners in the order of their last coordinates, with their numbers.
    using Sorted = std::vector<std::pair<Corner, std::uint32_t>>;

    static bool comes_before(const Corner& a, const Corner& b)
    {
        return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    }

    /// Tells each brick of those around it: rows of three neighbours follow each other.
    void link(DartBricks& bricks) const
    {
        Sorted sorted;
        for (std::uint32_t i = 0; i < found_.size(); ++i) sorted.emplace_back(found_[i], i);
        std::ranges::sort(sorted, comes_before, &Sorted::value_type::first);
        constexpr std::size_t rows = contract::dart_throwing::BRICKS_AROUND(D) / 3;
        bricks.around.assign(3 * rows * found_.size(), contract::dart_throwing::NO_BRICK);
        for (std::size_t i = 0; i < found_.size(); ++i)
            for (std::size_t row = 0; row < rows; ++row)
                link_row(sorted, found_[i], row, &bricks.around[3 * (i * rows + row)]);
    }

    /// Corners below 0 wrap around, and are not found.
    static void link_row(const Sorted& sorted, const Corner& corner, std::size_t row, std::uint32_t* numbers)
    {
        Corner left = corner;
        for (std::size_t k = 1, digits = row; k < D; ++k, digits /= 3)
            left[k] += static_cast<std::uint32_t>(digits % 3) - 1;
        left[0] = corner[0] == 0 ? 0 : corner[0] - 1;
        auto at = std::ranges::lower_bound(sorted, left, comes_before, &Sorted::value_type::first);
        for (; at != sorted.end() && at->first[0] <= corner[0] + 1; ++at) {
            if (!std::equal(left.begin() + 1, left.end(), at->first.begin() + 1)) return;
            numbers[at->first[0] + 1 - corner[0]] = at->second;
        }
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
