#include "host/sampling/regions/region_bridson.hpp"

#include "base/programs/interrupt.hpp"
#include "host/sampling/classics/torus_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

namespace poissonlab {
namespace {

/// The last word of Philox' counter says what random words are for.
constexpr std::uint32_t choice_use = 1, dart_use = 2; // 0: of candidates

/// The part of the torus that a region has.
double share_of_torus(const FixedRegion& region) { return region.area() / std::pow(region.unit() * 0x1p32, 2); }
double share_of_torus(const FixedSpace& space) { return space.volume() / std::pow(space.unit() * 0x1p32, 3); }

/// A grid with about as many cells as the torus has room for points or, where that would be more than some for each
/// point of the region, a folded one.
template <typename Region>
TorusGrid grid_for(const Region& region, double min_distance)
{
    constexpr int dimension = std::tuple_size_v<PlaceIn<Region>>;
    constexpr double most_cells = 0x1p26, few_cells = 0x1p18, most_cells_a_point = 16;
    const double torus_points = std::pow(min_distance, -dimension);
    const double points = torus_points * share_of_torus(region);
    if (torus_points <= std::min(most_cells, std::max(few_cells, most_cells_a_point * points)))
        return {static_cast<std::size_t>(torus_points), dimension};
    return {static_cast<std::size_t>(points), dimension, static_cast<std::uint64_t>(std::ceil(min_distance * 0x1p32))};
}

template <typename Region>
class BridsonInRegion
{
public:
    BridsonInRegion(const Region& region, const RegionBridsonRequest& request)
        : region_(region), request_(request), candidates_(region, request.stream, request.area),
          distance_(static_cast<std::uint64_t>(std::ceil(request.min_distance * 0x1p32))),
          grid_(grid_for(region, request.min_distance))
    {}

    PointSet run()
    {
        for (std::uint32_t turn = 0;; ++turn) {
            if (active_.empty() && !begin_anew()) return grid_.point_set();
            if (turn % 4096 == 0) stop_if_interrupted();
            const std::uint64_t random = philox({turn, 0, 0, choice_use}, request_.stream)[0];
            const std::size_t chosen = static_cast<std::size_t>(random * active_.size() >> 32);
            if (throws_well(grid_[active_[chosen]], turn)) continue;
            active_[chosen] = active_.back();
            active_.pop_back();
        }
    }

private:
    static constexpr int D = std::tuple_size_v<PlaceIn<Region>>;

    bool has_room(const TorusPosition& dart) const { return !grid_.is_near(dart, distance_); }

    void add(const TorusPosition& dart)
    {
        active_.push_back(static_cast<std::uint32_t>(grid_.size()));
        grid_.add(dart);
    }

    /// A first point, or one of a part of the region that points do not reach.
    bool begin_anew()
    {
        for (std::uint32_t failures = 0; failures < request_.starts; ++failures) {
            const std::optional<TorusPoint<D>> start = candidates_.next();
            if (!start) return false;
            TorusPosition dart{};
            std::ranges::copy(*start, dart.begin());
            if (!has_room(dart)) continue;
            add(dart);
            return true;
        }
        return false;
    }

    /// A place in the ring (the shell) of one to two distances around a point: the first of uniform ones in the square
    /// (the cube) around that. There is none where it is so far away that it would come around the torus.
    std::optional<TorusPosition> dart_around(const TorusPosition& around, std::uint32_t turn, std::uint32_t& word) const
    {
        __extension__ using Wide = unsigned __int128;
        const Wide least = Wide{distance_} * distance_;
        for (;; ++word) {
            const auto words = philox({turn, word, 0, dart_use}, request_.stream);
            TorusPosition dart = around;
            Wide squared = 0;
            bool is_far = false;
            for (std::size_t k = 0; k < D; ++k) {
                const std::int64_t offset =
                    static_cast<std::int64_t>(distance_ * words[k] >> 30) - static_cast<std::int64_t>(2 * distance_);
                squared += static_cast<Wide>(offset) * static_cast<Wide>(offset);
                is_far |= std::abs(offset) >= std::int64_t{1} << 31;
                dart[k] = around[k] + static_cast<std::uint32_t>(offset);
            }
            if (squared < least || squared >= 4 * least) continue;
            ++word;
            if (is_far) return {};
            return dart;
        }
    }

    /// Adds the first dart around a point that is allowed and not too near to any.
    bool throws_well(TorusPosition around, std::uint32_t turn)
    {
        grid_.ask_around(around, 3 * distance_);
        std::uint32_t word = 0;
        for (std::uint32_t attempt = 0; attempt < request_.attempts; ++attempt) {
            const std::optional<TorusPosition> dart = dart_around(around, turn, word);
            if (!dart) continue;
            TorusPoint<D> place;
            std::copy_n(dart->begin(), D, place.begin());
            if (!region_.contains(place) || !has_room(*dart)) continue;
            add(*dart);
            return true;
        }
        return false;
    }

    const Region& region_;
    const RegionBridsonRequest& request_;
    RegionCandidates<Region> candidates_;
    std::uint64_t distance_; ///< in units of 2^-32
    TorusGrid grid_;
    std::vector<std::uint32_t> active_; ///< points around which darts still fall
};

}

PointSet throw_bridson_darts(const FixedRegion& region, const RegionBridsonRequest& request)
{
    return BridsonInRegion(region, request).run();
}

PointSet throw_bridson_darts(const FixedSpace& space, const RegionBridsonRequest& request)
{
    return BridsonInRegion(space, request).run();
}

}
