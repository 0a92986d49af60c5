#include "host/sampling/regions/region_candidates.hpp"

#include "kernels/common/optimized/sample_elimination.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint64_t most_failures = 10'000'000;

constexpr std::size_t radii = 8, directions = 16;

/// Factors go no further: a point in a corner of 22 degrees has a sixteenth of its disk inside.
constexpr double most_factor = 16;

/// The part of the weight (1 - r)^8 over a disk of radius 1 that lies within r.
double weight_within(double r) { return 1 - std::pow(1 - r, 9) * (1 + 9 * r); }

/// Radii between which equal parts of the weight lie: the middle of each part.
std::array<double, radii> radii_of_equal_weight()
{
    std::array<double, radii> result{};
    for (std::size_t i = 0; i < radii; ++i) {
        const double wanted = (static_cast<double>(i) + 0.5) / radii;
        double low = 0, high = 1;
        for (int step = 0; step < 40; ++step) {
            const double middle = (low + high) / 2;
            (weight_within(middle) < wanted ? low : high) = middle;
        }
        result[i] = low;
    }
    return result;
}

/// Tangents of half the angles of four directions in each quarter, evenly spread.
constexpr std::array<double, 4> half_tangents{0.0984914033571642, 0.303346683607342, 0.534511135950792,
                                              0.820678790828660};

/// Places in a disk of radius 1, with equal weights.
std::array<std::array<double, 2>, radii * directions> places_in_disk()
{
    std::array<std::array<double, 2>, radii * directions> places{};
    const std::array<double, radii> all = radii_of_equal_weight();
    std::size_t next = 0;
    for (const double r : all)
        for (const double t : half_tangents) {
            const double x = r * (1 - t * t) / (1 + t * t), y = r * 2 * t / (1 + t * t);
            for (const std::array<double, 2>& place : {std::array{x, y}, {-y, x}, {-x, -y}, {y, -x}})
                places[next++] = place;
        }
    return places;
}

TorusPoint<2> fixed_position(std::span<const double> point)
{
    return {static_cast<std::uint32_t>(point[0] * 0x1p32), static_cast<std::uint32_t>(point[1] * 0x1p32)};
}

/// Are all positions so near to one along the axes inside?
bool is_well_inside(const FixedRegion& region, const TorusPoint<2>& position, double reach)
{
    FixedBox box;
    for (std::size_t k = 0; k < 2; ++k) {
        const double low = position[k] - reach, high = position[k] + reach;
        if (low < 0 || high >= 0x1p31) return false;
        box.low[k] = static_cast<std::uint32_t>(low);
        box.high[k] = static_cast<std::uint32_t>(high);
    }
    return region.side_of(box) == RegionSide::inside;
}

}

std::optional<TorusPoint<2>> RegionCandidates::next()
{
    const FixedBox& box = region_.extent();
    for (std::uint64_t failures = 0; failures < most_failures; ++failures) {
        const auto words =
            philox({static_cast<std::uint32_t>(thrown_), static_cast<std::uint32_t>(thrown_ >> 32), 0, 0}, stream_);
        ++thrown_;
        TorusPoint<2> place;
        for (std::size_t k = 0; k < 2; ++k) {
            const std::uint64_t size = std::uint64_t{box.high[k]} - box.low[k] + 1;
            place[k] = box.low[k] + static_cast<std::uint32_t>(words[k] * size >> 32);
        }
        if (!region_.contains(place)) continue;
        ++found_;
        return place;
    }
    return {};
}

std::vector<TorusPoint<2>> RegionCandidates::next(std::size_t count)
{
    std::vector<TorusPoint<2>> places;
    places.reserve(count);
    while (places.size() < count) {
        const std::optional<TorusPoint<2>> place = next();
        if (!place) break;
        places.push_back(*place);
    }
    return places;
}

std::vector<std::uint32_t> boundary_factors(const FixedRegion& region, const PointSet& points,
                                            const EliminationReach& reach)
{
    return boundary_factors(region, points, [&](std::size_t) { return reach.most * 0x1p32; });
}

std::vector<std::uint32_t> boundary_factors(const FixedRegion& region, const PointSet& points,
                                            const std::function<double(std::size_t)>& radius_of)
{
    using contract::sample_elimination::FACTOR_UNITS;
    static const auto places = places_in_disk();
    std::vector<std::uint32_t> factors(points.size(), FACTOR_UNITS);
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const double radius = radius_of(i);
        const TorusPoint<2> position = fixed_position(points[i]);
        if (is_well_inside(region, position, radius)) return;
        std::size_t inside = 0;
        for (const auto& [x, y] : places) {
            const double at_x = position[0] + x * radius, at_y = position[1] + y * radius;
            if (at_x >= 0 && at_y >= 0 && at_x < 0x1p31 && at_y < 0x1p31)
                inside += region.contains({static_cast<std::uint32_t>(at_x), static_cast<std::uint32_t>(at_y)});
        }
        const double factor = std::min(most_factor, static_cast<double>(places.size()) /
                                                        static_cast<double>(std::max<std::size_t>(inside, 1)));
        factors[i] = static_cast<std::uint32_t>(factor * static_cast<double>(FACTOR_UNITS) + 0.5);
    });
    return factors;
}

}
