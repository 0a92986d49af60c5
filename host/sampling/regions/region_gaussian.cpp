#include "host/sampling/regions/region_gaussian.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

/// Gaussians are as wide as a mean distance, and wider beside the boundary, where they have fewer points under them.
constexpr double sigma_in_region = 1, widest_beside_boundary = 1.5;

/// Cells of the density for a mean distance, about, and their number along the square at most.
constexpr double density_cells = 16;
constexpr std::uint32_t least_density_side = 64, most_density_side = 2048;

constexpr std::uint32_t places_a_side = 4; ///< of a crossed cell, by which one knows how much of it is inside

/// Around a place that is outside: so many directions, as offsets of 256ths, and rings that grow by a half each.
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

std::size_t least_points_of_region_gaussian() { return least_gaussian_points(sigma_in_region, 2); }

RegionGaussian::RegionGaussian(const FixedRegion& region, std::size_t count) : region_(region)
{
    const FixedBox& box = region.extent();
    const double longest = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]) + 1.0;
    const double mean = std::sqrt(region.area() / static_cast<double>(count)) / region.unit();
    side_ = longest + gaussian_cut_off * sigma_in_region * widest_beside_boundary * mean;
    const double wanted = std::clamp(density_cells * side_ / mean, 1.0, double{most_density_side});
    read_density(std::clamp(std::bit_ceil(static_cast<std::uint32_t>(wanted)), least_density_side, most_density_side));
}

void RegionGaussian::read_density(std::uint32_t size)
{
    density_ = {static_cast<int>(size), static_cast<int>(size), std::vector<std::uint64_t>(std::size_t{size} * size)};
    tbb::parallel_for(std::uint32_t{0}, size, [&](std::uint32_t row) {
        for (std::uint32_t column = 0; column < size; ++column)
            density_.weights[std::size_t{row} * size + column] = weight_of(column, row, size);
    });
    // Thin regions may have no cell to themselves.
    const std::uint64_t most = std::ranges::max(density_.weights);
    if (most > 0 && most < full_weight)
        for (std::uint64_t& weight : density_.weights) weight = weight * (full_weight / most);
}

std::uint64_t RegionGaussian::weight_of(std::uint32_t column, std::uint32_t row, std::uint32_t size) const
{
    const double cell = side_ / size;
    const TorusPoint<2> low = position_of(column * cell, row * cell);
    const TorusPoint<2> end = position_of((column + 1) * cell, (row + 1) * cell);
    const RegionSide side = region_.side_of({low, {std::max(low[0], end[0] - 1), std::max(low[1], end[1] - 1)}});
    if (side != RegionSide::crossed) return side == RegionSide::inside ? full_weight : 0;
    std::uint64_t inside = 0;
    for (std::uint32_t y = 0; y < places_a_side; ++y)
        for (std::uint32_t x = 0; x < places_a_side; ++x)
            inside += region_.contains(
                position_of((column + (x + 0.5) / places_a_side) * cell, (row + (y + 0.5) / places_a_side) * cell));
    return inside * (full_weight / (places_a_side * places_a_side));
}

/// The position of a place in the square, which goes on beyond those of regions: they end at half of the torus.
TorusPoint<2> RegionGaussian::position_of(double x, double y) const
{
    const FixedBox& box = region_.extent();
    return {static_cast<std::uint32_t>(std::min(box.low[0] + x, 0x1p32 - 1)),
            static_cast<std::uint32_t>(std::min(box.low[1] + y, 0x1p32 - 1))};
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
    const FixedBox& box = region_.extent();
    PointSet points{2, {}};
    for (const TorusPoint<2>& place : start)
        for (std::size_t k = 0; k < 2; ++k) points.coordinates.push_back((double{1} * place[k] - box.low[k]) / side_);
    const double step = usual_gaussian_step(sigma_in_region, 2);
    const GaussianRequest request{
        iterations, sigma_in_region, step,
        std::make_shared<const GaussianField>(gaussian_field(density_, sigma_in_region, step, start.size()))};
    const PointSet moved = descent(points, request);
    std::vector<TorusPoint<2>> places;
    for (std::size_t i = 0; i < start.size(); ++i)
        places.push_back(allowed_near(position_of(moved[i][0] * side_, moved[i][1] * side_), start[i]));
    return places;
}

}
