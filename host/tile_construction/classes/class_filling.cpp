#include "host/tile_construction/classes/class_filling.hpp"

#include "kernels/common/tiles/class_tiles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

static_assert(whole_part == 1U << contract::class_tiles::PART_BITS);
static_assert(most_classes == contract::class_tiles::MOST_CLASSES);

/// Relaxation dart throwing is given up below this part of the distances.
constexpr double least_part = 0.2;

/// Passes of pushing; those that succeed take some tens.
constexpr std::uint32_t max_class_passes = 400;

/// Points are pushed a little farther than they have to be, for rounding to whole units brings them closer again.
constexpr double class_push_margin = 1.0005;
constexpr double class_rounding_margin = 2;

}

std::size_t point_count(const ClassedPositions& points)
{
    std::size_t count = 0;
    for (const std::vector<TilePosition>& own : points) count += own.size();
    return count;
}

std::vector<TilePosition> with_classes(const ClassedPositions& points)
{
    std::vector<TilePosition> all;
    for (std::size_t of = 0; of < points.size(); ++of)
        for (const TilePosition& point : points[of]) all.push_back({point[0], point[1], static_cast<std::int32_t>(of)});
    return all;
}

ClassedPositions by_class(std::span<const TilePosition> points, std::size_t classes)
{
    ClassedPositions own(classes);
    for (const TilePosition& point : points) own[static_cast<std::size_t>(point[2])].push_back({point[0], point[1], 0});
    return own;
}

std::uint32_t ClassFillProblem::active_points() const { return std::reduce(active.begin(), active.end()); }

ClassFillSettings class_fill_settings(const PoissonTileParameters& p)
{
    const std::size_t classes = p.classes.count();
    const ClassDistances& distances = p.classes.distances;
    ClassFillSettings settings;
    for (std::size_t i = 0; i < classes; ++i)
        for (std::size_t j = 0; j < classes; ++j) {
            const double distance = distances.at(i, j) * tile_units;
            settings.wanted.push_back(static_cast<std::uint32_t>(squared_units(distances.at(i, j))));
            settings.pushed.push_back(std::max(distance * class_push_margin, distance + class_rounding_margin));
        }
    const double factor = p.filling == TileFilling::dart_throwing ? 0 : p.factor;
    for (double part = 1; part >= least_part; part *= factor)
        settings.parts.push_back(static_cast<std::uint32_t>(std::ceil(part * part * whole_part)));
    settings.order.resize(classes);
    std::iota(settings.order.begin(), settings.order.end(), 0U);
    std::ranges::stable_sort(settings.order, std::greater{}, [&](std::uint32_t i) { return distances.at(i, i); });
    settings.attempts = p.attempts;
    settings.passes = max_class_passes;
    settings.stream = stream_key(p.seed, Purpose::class_tile_filling, 0);
    return settings;
}

}
