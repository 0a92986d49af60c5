// A region of the plane that is filled with the points of hats or spectres, in the region's own units.
//
// Edges of the tiles are so long that the proven minimum distance becomes the one that is asked for. The tiling's
// origin is that of the region's coordinates, unless it is shifted, so that regions beside each other, at one scale,
// are parts of one endless set.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "tiles/poisson/monotile_points_file.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace poissonlab {

/// The units of the region that an edge is long at least, so that distances that are computed from written coordinates
/// are never below `min_distance`.
double edge_for(double min_distance, const MonotilePointsFile& file, const RegionBox& box);

/// The minimum distance of points in the region's units, with edges of this length: what edge_for() is given.
double min_distance_with(double edge, const MonotilePointsFile& file, const RegionBox& box);

class MonotileRegion
{
public:
    /// `edge` in units of the region. `shift` is the place of the tiling at the origin of the region's coordinates, in
    /// steps of the file. Throws InputError, a sentence, where so many edges have no place in a window.
    MonotileRegion(const MonotilePointsFile& file, std::shared_ptr<const FixedRegion> region, double edge,
                   const std::array<std::int64_t, 2>& shift = {});

    double edge() const { return edge_; }

    /// The number of strips of the region, from south to north, each with about 10^6 points of its box or fewer.
    std::uint32_t strips() const { return strips_; }

    /// Returns the points of a strip that lie in the region, at positions in its units, of all those with a level below
    /// the density.
    std::vector<pmono_point> points(std::uint32_t strip, std::uint32_t seed, double density = 1) const;

    /// Returns those of all strips.
    std::vector<pmono_point> all_points(std::uint32_t seed, double density = 1) const;

private:
    MonotilePointsFile file_;
    std::shared_ptr<const FixedRegion> region_;
    double edge_;
    std::array<std::int64_t, 2> origin_{}; ///< of windows, in the tiling
    std::array<double, 2> from_origin_{}, low_{},
        high_{};       ///< the origin's place, and the box as seen from it, in edges
    double strip_ = 1; ///< the height of a strip
    std::uint32_t strips_ = 1;
};

}
