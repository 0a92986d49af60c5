#include "analysis/regions/region_distances.hpp"

#include "analysis/regions/plane_neighbours.hpp"
#include "base/regions/region_squares.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace poissonlab {
namespace {

constexpr double golden = 0.6180339887498949;

/// One over the plastic number, and over its square: multiples of both spread evenly over a square.
constexpr std::array<double, 2> plastic{0.7548776662466927, 0.5698402909980532};

/// Squares are made for regions of which places in their box would find less than this.
constexpr double least_share_of_box = 1.0 / 64;

/// Fewer places than this are left where F is taken to be known: J is a quotient of what is left.
constexpr double least_left = 1e-3;

}

NearestInPlane nearest_in_plane(const PointSet& points, const FramedRegion& region)
{
    const PlaneNeighbours sorted(points, region.area());
    std::vector<double> nearest(sorted.size());
    tbb::parallel_for(std::size_t{0}, nearest.size(),
                      [&](std::size_t i) { nearest[i] = sorted.nearest(sorted.place(i), i); });
    double sum = 0;
    for (const double distance : nearest) sum += distance;
    return {std::ranges::min(nearest), sum / static_cast<double>(nearest.size())};
}

RegionPlaces::RegionPlaces(const FramedRegion& region, std::size_t count, double reach)
{
    const RegionBox box = box_of(region.polygons());
    if (region.area() < least_share_of_box * box.width() * box.height())
        find_in_squares(region, count);
    else
        find_in_box(region, box, count);
    boundary_.resize(places_.size());
    tbb::parallel_for(std::size_t{0}, places_.size(),
                      [&](std::size_t i) { boundary_[i] = region.boundary().distance(places_[i], reach); });
}

void RegionPlaces::find_in_squares(const FramedRegion& region, std::size_t count)
{
    const RegionSquares<FixedRegion> squares = squares_of(region.fixed(), most_region_squares);
    const auto corners = static_cast<double>(squares.corners.size());
    const double side = std::exp2(squares.shift - FixedRegion::coordinate_bits);
    const double total = std::ceil(static_cast<double>(count) * corners * side * side / region.area());
    for (double i = 0; i < total; ++i) {
        const auto& corner = squares.corners[static_cast<std::size_t>((i + 0.5) / total * corners)];
        std::array<double, 2> place{};
        for (std::size_t k = 0; k < 2; ++k) {
            const double along = i * plastic[k];
            place[k] = corner[k] * 0x1p-31 + (along - std::floor(along)) * side;
        }
        if (region.contains(place)) places_.push_back(place);
    }
}

void RegionPlaces::find_in_box(const FramedRegion& region, const RegionBox& box, std::size_t count)
{
    const auto total =
        static_cast<std::size_t>(std::ceil(static_cast<double>(count) * box.width() * box.height() / region.area()));
    for (std::size_t i = 0; i < total; ++i) {
        const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(total);
        const double y = static_cast<double>(i) * golden;
        const std::array place{box.low[0] + x * box.width(), box.low[1] + (y - std::floor(y)) * box.height()};
        if (region.contains(place)) places_.push_back(place);
    }
}

DistanceCurves region_distances(const PointSet& points, const FramedRegion& region, const RegionPlaces& places,
                                double step, std::size_t count)
{
    const double reach = 2 * step * static_cast<double>(count);
    const PlaneNeighbours sorted(points, region.area());
    std::vector<CensoredLength> of_points(sorted.size()), of_places(places.places().size());
    tbb::parallel_for(std::size_t{0}, of_points.size(), [&](std::size_t i) {
        const auto place = sorted.place(i);
        of_points[i] = {sorted.nearest(place, i), region.boundary().distance(place, reach)};
    });
    tbb::parallel_for(std::size_t{0}, of_places.size(), [&](std::size_t i) {
        of_places[i] = {sorted.nearest(places.places()[i]), places.boundary()[i]};
    });
    DistanceCurves curves;
    curves.g = product_limit(std::move(of_points), step, count);
    curves.f = product_limit(std::move(of_places), step, count);
    for (std::size_t k = 0; k < count; ++k)
        curves.j.push_back(curves.f[k] <= 1 - least_left ? (1 - curves.g[k]) / (1 - curves.f[k])
                                                         : std::numeric_limits<double>::quiet_NaN());
    return curves;
}

std::vector<double> product_limit(std::vector<CensoredLength> lengths, double step, std::size_t count)
{
    // The ends of observations in order; of equal ones, those that end by their length come first.
    std::vector<std::pair<double, bool>> ends; // true: censored
    for (const CensoredLength& l : lengths) ends.emplace_back(std::min(l.length, l.seen), l.length > l.seen);
    std::ranges::sort(ends);
    std::vector<double> shares(count);
    double longer = 1;
    std::size_t i = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double up_to = step * static_cast<double>(k + 1);
        for (; i < ends.size() && ends[i].first <= up_to; ++i)
            if (!ends[i].second) {
                const auto left = static_cast<double>(ends.size() - i);
                longer *= (left - 1) / left;
            }
        shares[k] = 1 - longer;
    }
    return shares;
}

}
