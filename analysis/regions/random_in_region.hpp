// Independent random points in a region, evenly or following a density: what sets are held against.
#pragma once

#include "analysis/regions/framed_region.hpp"
#include "base/densities/density.hpp"
#include "base/regions/region_squares.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// A density over the box of a region, in parts of its mean over the region.
class RegionDensity
{
public:
    /// `density` has the sides of the region's box.
    RegionDensity(Density density, const FramedRegion& region);

    double at(const std::array<double, 2>& place) const { return static_cast<double>(weight(place)) / mean_; }

    /// The weight of a place, up to full_weight.
    std::uint64_t weight(const std::array<double, 2>& place) const;

    /// The intensity at each point, in points per square of the frame. Throws InputError that begins with `name` where
    /// the density is 0 at a point.
    std::vector<double> intensities(const PointSet& points, const FramedRegion& region, const std::string& name) const;

private:
    Density density_;
    RegionBox box_;
    double mean_ = 1;
};

class RandomInRegion
{
public:
    /// `density` may be null.
    RandomInRegion(const FramedRegion& region, const RegionDensity* density);

    /// Set number `realization` of so many points, in the frame. The same for the same region, always.
    PointSet points(std::size_t count, std::uint32_t realization) const;

private:
    const FramedRegion& region_;
    const RegionDensity* density_;
    RegionSquares<FixedRegion> squares_; ///< that points fall into
};

}
