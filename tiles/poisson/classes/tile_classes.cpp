#include "tiles/poisson/classes/tile_classes.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace poissonlab {

std::uint32_t TileClasses::all_points() const { return std::reduce(points.begin(), points.end()); }

std::uint32_t TileClasses::first_point(std::uint32_t of) const
{
    return std::reduce(points.begin(), points.begin() + of);
}

std::uint32_t TileClasses::class_of(std::uint32_t point) const
{
    std::uint32_t of = 0;
    for (; point >= points[of]; ++of) point -= points[of];
    return of;
}

double TileClasses::least_distance() const
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count(); ++i)
        for (std::size_t j = 0; j <= i; ++j) least = std::min(least, distances.at(i, j));
    return least;
}

double TileClasses::largest_distance() const
{
    double largest = 0;
    for (std::size_t i = 0; i < count(); ++i)
        for (std::size_t j = 0; j <= i; ++j) largest = std::max(largest, distances.at(i, j));
    return largest;
}

TileClasses classes_of_radius(std::vector<std::uint32_t> points, double relative_radius, int dimension)
{
    std::vector<double> distances;
    for (const std::uint32_t count : points) distances.push_back(min_distance_for(relative_radius, count, dimension));
    return {std::move(points), wei_distances(distances, dimension)};
}

void check(const TileClasses& classes, std::uint32_t points_per_tile)
{
    const std::string shown = fmt::format("[{}]", fmt::join(classes.points, ", "));
    if (classes.count() > most_classes)
        throw invalid_value({}, "class_points", shown, fmt::format("must be at most {} classes", most_classes));
    if (classes.distances.classes() != classes.count())
        throw invalid_value({}, "class_points", shown,
                            fmt::format("must be {}, one of each class", classes.distances.classes()));
    std::uint64_t sum = 0;
    for (const std::uint32_t points : classes.points) sum += points;
    if (sum != points_per_tile || std::ranges::find(classes.points, 0U) != classes.points.end())
        throw invalid_value({}, "class_points", shown,
                            fmt::format("must be 1 or more each, {} together", points_per_tile));
    for (std::size_t i = 0; i < classes.count(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            if (const double distance = classes.distances.at(i, j); !(distance > 0 && distance <= 1))
                throw invalid_value({}, "class_distances", fmt::format("{}", distance),
                                    "must be numbers above 0 and at most 1, in tiles");
}

}
