// Gaussian blue noise in a region of the plane.
//
// Ahmed, Ren, Wonka, Gaussian blue noise, 2022: see host/sampling/optimized/gaussian_field.hpp. The density that points
// follow is the region itself, in a square that is wider than the region by what Gaussians reach: it pulls points that
// the boundary would have no neighbours to push back, so that none crowd beside it, and points do not move to where
// there is none of it. The density knows the boundary to a part of a mean distance; points that lie outside in the end
// are moved to the nearest allowed place of those that are looked at.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/regions/region_field.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace poissonlab {

/// The fewest points that Gaussians do not reach around the torus of.
std::size_t least_points_of_region_gaussian();

/// The reference or the kernel, which descends.
using GaussianDescent = std::function<PointSet(const PointSet&, const GaussianRequest&)>;

/// A region's density for so many points, in a square of the region's grid.
class RegionGaussian
{
public:
    static constexpr double sigma = 1; ///< of Gaussians, in mean distances

    /// `count` is least_points_of_region_gaussian() or more; `is_long`: a square around the region is much too large.
    /// `check` is asked where cells are listed. Throws InputError where the square's cells are too large to know what
    /// margins leave of the region.
    RegionGaussian(const FixedRegion& region, std::size_t count, bool is_long = false,
                   const FieldSizeCheck& check = {});

    /// The sizes of the field for these points.
    GaussianFieldShape shape() const;

    /// The points after so many steps, all of them allowed. `start` has `count` points, in the region.
    std::vector<TorusPoint<2>> descend(const std::vector<TorusPoint<2>>& start, std::size_t iterations,
                                       const GaussianDescent& descent) const;

private:
    void read_density(std::uint32_t size);
    void leave_margins(double& share, std::uint32_t column, std::uint32_t row, double cell) const;
    TorusPoint<2> position_of(double x, double y) const;
    TorusPoint<2> allowed_near(const TorusPoint<2>& place, const TorusPoint<2>& start) const;

    const FixedRegion& region_;
    std::size_t count_;
    std::array<double, 2> low_; ///< of the square, in positions
    double side_ = 1;
    Density density_;
    std::optional<RegionField> listed_; ///< instead of the density
};

}
