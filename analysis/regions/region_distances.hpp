// Nearest distances in a region: of points from other points (G), and of places from points (F), by the product-limit
// estimator, which counts a distance as long as it is seen, up to that from the boundary.
//
// G(r) is the share of points with a neighbour no farther than r, F(r) that of the region's places with a point no
// farther; both are 1 - exp(-lambda pi r^2) of random points. J(r) = (1 - G(r)) / (1 - F(r)) is 1 for these, larger
// where points keep apart, less where they cluster (van Lieshout, Baddeley, A nonparametric measure of spatial
// interaction in point patterns, Statistica Neerlandica 50(3), 1996).
//
// The distribution function of lengths of which some are known to be at least so long only: the product-limit estimator
// (Kaplan, Meier, Nonparametric estimation from incomplete observations, Journal of the American Statistical
// Association 53, 1958). Distances of points in a region are such lengths: beyond the boundary there may have been a
// nearer one (Baddeley, Gill, Kaplan-Meier estimators of distance distributions for spatial point processes, Annals of
// Statistics 25(1), 1997).
#pragma once

#include "analysis/regions/framed_region.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// The least and the mean distance of points from their nearest ones, of two points or more, wherever the boundary is.
struct NearestInPlane
{
    double least = 0;
    double mean = 0;
};
NearestInPlane nearest_in_plane(const PointSet& points, const FramedRegion& region);

/// Places of a region in a Kronecker sequence, and how far each is from the boundary, or `reach` if that is less.
class RegionPlaces
{
public:
    /// About `count` of them in the region.
    RegionPlaces(const FramedRegion& region, std::size_t count, double reach);

    const std::vector<std::array<double, 2>>& places() const { return places_; }
    const std::vector<double>& boundary() const { return boundary_; }

private:
    /// Kronecker sequences in the region's box and, where that would be nearly empty, in squares that cover it.
    void find_in_box(const FramedRegion& region, const RegionBox& box, std::size_t count);
    void find_in_squares(const FramedRegion& region, std::size_t count);

    std::vector<std::array<double, 2>> places_;
    std::vector<double> boundary_;
};

/// Curves at step, 2 step, ...
struct DistanceCurves
{
    std::vector<double> g;
    std::vector<double> f;
    std::vector<double> j; ///< not a number where F is 1
};

DistanceCurves region_distances(const PointSet& points, const FramedRegion& region, const RegionPlaces& places,
                                double step, std::size_t count);

/// A length, and the length up to which it can be seen.
struct CensoredLength
{
    double length = 0;
    double seen = 0;
};

/// The share of lengths up to `step`, 2 `step`, ..., `count` of these. Beyond the last length that is seen it stays as
/// it is.
std::vector<double> product_limit(std::vector<CensoredLength> lengths, double step, std::size_t count);

}
