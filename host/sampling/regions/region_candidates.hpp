// Random points in a region, and what a region's boundary takes from the neighbourhood of points.
#pragma once

#include "base/random/random.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "base/regions/region_squares.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace poissonlab {

/// The attempt in whose place regions stand among streams: sets of the torus have none, and so share nothing with
/// theirs.
inline constexpr std::uint32_t region_attempt = 1;

/// A position of a region's grid.
template <typename Region>
using PlaceIn = PositionIn<Region>;

/// The places that darts fall into.
enum class CandidateArea
{
    box,    ///< the least one around the region
    squares ///< of RegionSquares: where regions are so long that a box would be nearly empty
};

/// Independent uniform points: darts, of which those outside the region are left out. The next one: nothing where not
/// one of ten million lies inside. Of a FixedRegion or a FixedSpace. With a least share next(count) ends as well where
/// a million darts have found less of them inside.
template <typename Region>
class RegionCandidates
{
public:
    using Place = PlaceIn<Region>;

    /// The region must outlive this.
    RegionCandidates(const Region& region, const StreamKey& stream, CandidateArea area = CandidateArea::box,
                     double least_share = 0);

    std::optional<Place> next();

    /// Finds `count` candidates, or as many as it can.
    std::vector<Place> next(std::size_t count);

    /// The part of the box around the region that darts found inside.
    double share() const { return share_of_darts() * area_part_; }

    /// The squares that darts fall into, if they do.
    const std::shared_ptr<const RegionSquares<Region>>& squares() const { return squares_; }

    /// The part of the darts that fell inside.
    double share_of_darts() const { return static_cast<double>(found_) / static_cast<double>(thrown_); }

private:
    Place dart(const std::array<std::uint32_t, 4>& words) const;

    const Region& region_;
    StreamKey stream_;
    double least_share_;
    std::shared_ptr<const RegionSquares<Region>> squares_; ///< null: darts fall into the box
    double area_part_ = 1;                                 ///< of what darts fall into, of the box
    std::uint64_t thrown_ = 0, found_ = 0;
};

/// The factors of the weights of each point in sample elimination, in FACTOR_UNITS. They make points beside the
/// boundary as crowded as if the set went on beyond it: one over the part of the weight of a disk around the point
/// that lies inside, by 128 places in it.
std::vector<std::uint32_t> boundary_factors(const FixedRegion& region, const PointSet& points,
                                            const EliminationReach& reach);

/// The factors of points whose disks of weights have a radius of their own each, in positions.
std::vector<std::uint32_t> boundary_factors(const FixedRegion& region, const PointSet& points,
                                            const std::function<double(std::size_t)>& radius_of);

/// The factors of points in space, by 256 places in a ball.
std::vector<std::uint32_t> boundary_factors(const FixedSpace& space, const PointSet& points,
                                            const EliminationReach& reach);

}
