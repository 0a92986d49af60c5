#include "host/sampling/regions/region_gaussian.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/region_shares.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

/// Gaussians are wider beside the boundary, where they have fewer points under them.
constexpr double widest_beside_boundary = 1.5;

/// Cells of the density for a mean distance, about, and their number along the square at most.
constexpr double density_cells = 16;
constexpr std::uint32_t least_density_side = 64, most_density_side = 2048;

/// A square whose cells would be wider than this part of a mean distance has listed ones instead, unless the region
/// fills so large a part of it.
constexpr double widest_cell = 1.0 / 4, well_filled = 1.0 / 4;

/// A place inside is looked for around one that is outside, in so many directions, which are offsets of 256ths, and on
/// rings that grow by a half each.
constexpr std::array<std::array<int, 2>, 16> ring_directions{{{256, 0},
                                                              {237, 98},
                                                              {181, 181},
                                                              {98, 237},
                                                              {0, 256},
                                                              {-98, 237},
                                                              {-181, 181},
                                                              {-237, 98},
                                                              {-256, 0},
                                                              {-237, -98},
                                                              {-181, -181},
                                                              {-98, -237},
                                                              {0, -256},
                                                              {98, -237},
                                                              {181, -181},
                                                              {237, -98}}};

}

std::size_t least_points_of_region_gaussian() { return least_gaussian_points(RegionGaussian::sigma, 2); }

RegionGaussian::RegionGaussian(const FixedRegion& region, std::size_t count, bool is_long, const FieldSizeCheck& check)
    : region_(region), count_(count), low_{double{1} * region.extent().low[0], double{1} * region.extent().low[1]}
{
    const FixedBox& box = region.extent();
    const double longest = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]) + 1.0;
    const double mean = std::sqrt(region.area() / static_cast<double>(count)) / region.unit();
    side_ = longest + gaussian_cut_off * sigma * widest_beside_boundary * mean;
    const double filled = static_cast<double>(count) * mean * mean / (side_ * side_);
    if (is_long || (side_ > widest_cell * mean * most_density_side && filled < well_filled)) {
        listed_.emplace(region, count, sigma, check);
        low_ = listed_->low();
        side_ = listed_->side();
        return;
    }
    const double wanted = std::clamp(density_cells * side_ / mean, 1.0, double{most_density_side});
    read_density(std::clamp(std::bit_ceil(static_cast<std::uint32_t>(wanted)), least_density_side, most_density_side));
}

GaussianFieldShape RegionGaussian::shape() const
{
    return listed_ ? listed_->shape() : gaussian_field_shape(density_, sigma, count_);
}

void RegionGaussian::read_density(std::uint32_t size)
{
    const ShareLattice cells{low_, side_ / size, size, size};
    std::vector<double> shares = region_shares(region_, cells);
    tbb::parallel_for(std::uint32_t{0}, size, [&](std::uint32_t row) {
        for (std::uint32_t column = 0; column < size; ++column)
            leave_margins(shares[std::size_t{row} * size + column], column, row, cells.side);
    });
    if (std::ranges::all_of(shares, [](double share) { return share == 0; }))
        throw InputError(fmt::format("Gaussian blue noise has a density of {0} x {0} cells around the region, and none "
                                     "of them has room for a point: too little is left by obstacles and the boundary",
                                     size));
    density_ = density_of_values(static_cast<int>(size), static_cast<int>(size), std::move(shares), "the region");
}

/// Turns what a cell has of the region into what it has of what is allowed.
void RegionGaussian::leave_margins(double& share, std::uint32_t column, std::uint32_t row, double cell) const
{
    const TorusPoint<2> low = position_of(column * cell, row * cell);
    const TorusPoint<2> end = position_of((column + 1) * cell, (row + 1) * cell);
    const RegionSide side = region_.side_of({low, {std::max(low[0], end[0] - 1), std::max(low[1], end[1] - 1)}});
    if (side == RegionSide::outside)
        share = 0;
    else if (side == RegionSide::inside)
        share = 1;
    else
        share *= part_left_by_margins(region_, {double{1} * low[0], double{1} * low[1]}, cell);
}

/// The position of a place in the square, which goes on beyond those of regions: they end at half of the torus.
TorusPoint<2> RegionGaussian::position_of(double x, double y) const
{
    return {static_cast<std::uint32_t>(std::clamp(low_[0] + x, 0.0, 0x1p32 - 1)),
            static_cast<std::uint32_t>(std::clamp(low_[1] + y, 0.0, 0x1p32 - 1))};
}

TorusPoint<2> RegionGaussian::allowed_near(const TorusPoint<2>& place, const TorusPoint<2>& start) const
{
    if (region_.contains(place)) return place;
    for (double radius = 1; radius < side_; radius *= 1.5)
        for (const auto& [dx, dy] : ring_directions) {
            const double x = place[0] + radius * dx / 256, y = place[1] + radius * dy / 256;
            if (!(x >= 0 && y >= 0 && x < 0x1p31 && y < 0x1p31)) continue;
            const TorusPoint<2> near{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)};
            if (region_.contains(near)) return near;
        }
    return start;
}

std::vector<TorusPoint<2>> RegionGaussian::descend(const std::vector<TorusPoint<2>>& start, std::size_t iterations,
                                                   const GaussianDescent& descent) const
{
    PointSet points{2, {}};
    for (const TorusPoint<2>& place : start)
        for (std::size_t k = 0; k < 2; ++k) points.coordinates.push_back((place[k] - low_[k]) / side_);
    const double step = usual_gaussian_step(sigma, 2);
    const GaussianRequest request{
        iterations, sigma, step,
        std::make_shared<const GaussianField>(listed_ ? listed_->field(step)
                                                      : gaussian_field(density_, sigma, step, start.size()))};
    const PointSet moved = descent(points, request);
    std::vector<TorusPoint<2>> places;
    for (std::size_t i = 0; i < start.size(); ++i)
        places.push_back(allowed_near(position_of(moved[i][0] * side_, moved[i][1] * side_), start[i]));
    return places;
}

}
