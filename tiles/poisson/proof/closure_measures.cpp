#include "tiles/poisson/proof/closure_measures.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// The sum of f(distance along an axis) squared over the axes.
template <unsigned Dimension, class Change>
double squared(const std::array<double, 3>& a, const std::array<double, 3>& b, const Change& change)
{
    double sum = 0;
    for (std::size_t k = 0; k < Dimension; ++k) {
        const double along = change(std::abs(a[k] - b[k]));
        sum += along * along;
    }
    return sum;
}

}

void EmptyBallSearch::take(std::span<const UnitPosition> points, double known)
{
    best_ = known;
    candidates_.clear();
    for (const UnitPosition& p : points)
        candidates_.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
}

double EmptyBallSearch::radius(std::span<const UnitPosition> points, double known)
{
    take(points, known);
    polygon_ = {};
    constexpr double half = tile_units / 2.0;
    if (dimension_ == 2)
        search<2>({{half, half, 0}, half}, 0, candidates_.size());
    else
        search<3>({{half, half, half}, half}, 0, candidates_.size());
    return best_;
}

double EmptyBallSearch::radius_in(std::span<const UnitPosition> polygon, std::span<const UnitPosition> points,
                                  double known)
{
    take(points, known);
    polygon_ = polygon;
    constexpr double half = tile_units / 2.0;
    search<2>({{half, half, 0}, 2 * half}, 0, candidates_.size());
    return best_;
}

double EmptyBallSearch::depth(const std::array<double, 3>& place) const
{
    double nearest = std::numeric_limits<double>::infinity(); // of the border, squared
    bool is_inside = false;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
        const UnitPosition& a = polygon_[i];
        const UnitPosition& b = polygon_[(i + 1) % polygon_.size()];
        const double ax = a[0] - place[0], ay = a[1] - place[1], x = b[0] - a[0], y = b[1] - a[1];
        const double along = std::clamp(-(ax * x + ay * y) / (x * x + y * y), 0.0, 1.0);
        nearest = std::min(nearest, (ax + along * x) * (ax + along * x) + (ay + along * y) * (ay + along * y));
        if ((a[1] > place[1]) != (b[1] > place[1]) && (ay * x > ax * y) != (b[1] > a[1])) is_inside = !is_inside;
    }
    return is_inside ? std::sqrt(nearest) : -std::sqrt(nearest);
}

/// The candidates of the square are those from `first` to `last`.
template <unsigned Dimension>
void EmptyBallSearch::search(const Square& square, std::size_t first, std::size_t last)
{
    const double inside = polygon_.empty() ? 0 : depth(square.centre);
    if (inside < -square.half * std::sqrt(2.0)) return;
    double nearest = std::numeric_limits<double>::infinity();  // from the centre, squared
    double farthest = std::numeric_limits<double>::infinity(); // any place of the square from its nearest point
    for (std::size_t i = first; i < last; ++i) {
        const auto& point = candidates_[i];
        nearest = std::min(nearest, squared<Dimension>(point, square.centre, [](double x) { return x; }));
        farthest =
            std::min(farthest, squared<Dimension>(point, square.centre, [&](double x) { return x + square.half; }));
    }
    if (inside >= 0) best_ = std::max(best_, std::sqrt(nearest));
    if (farthest <= (1 + tolerance) * best_ * ((1 + tolerance) * best_)) return;

    // Points that are farther from all of the square than any place in it from its nearest are nowhere
    // nearest.
    for (std::size_t i = first; i < last; ++i) {
        const auto point = candidates_[i];
        const auto outside = [&](double x) { return std::max(x - square.half, 0.0); };
        if (squared<Dimension>(point, square.centre, outside) <= farthest) candidates_.push_back(point);
    }
    const std::size_t end = candidates_.size();
    const double half = square.half / 2;
    for (unsigned child = 0; child < 1u << Dimension; ++child) {
        Square part{square.centre, half};
        for (std::size_t k = 0; k < Dimension; ++k) part.centre[k] += child >> k & 1 ? half : -half;
        search<Dimension>(part, last, end);
        candidates_.resize(end);
    }
    candidates_.resize(last);
}

namespace {

/// Tiles that are searched for empty circles first, each on its own: the others need only look for larger
/// ones.
constexpr std::uint32_t first_tiles = 32;

/// Points of a tile, and their squared distance.
struct MeasuredPair
{
    std::int64_t squared_distance = INT64_MAX;
    NearestPair pair;
};

/// The nearest points of a tile. Goes along x: points that are farther apart along it than the smallest distance are
/// not compared.
MeasuredPair nearest_pair(std::uint32_t tile, std::vector<UnitPosition>& points)
{
    std::ranges::sort(points, {}, [](const UnitPosition& position) { return position[0]; });
    MeasuredPair nearest;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            const std::int64_t x = points[j][0] - points[i][0];
            if (x * x >= nearest.squared_distance) break;
            const std::int64_t y = points[j][1] - points[i][1];
            const std::int64_t z = points[j][2] - points[i][2];
            const std::int64_t squared = x * x + y * y + z * z;
            if (squared < nearest.squared_distance) nearest = {squared, {tile, {points[i], points[j]}}};
        }
    }
    return nearest;
}

ClosureMeasures joined(ClosureMeasures a, const ClosureMeasures& b)
{
    if (b.squared_distance < a.squared_distance) {
        a.squared_distance = b.squared_distance;
        a.nearest = b.nearest;
    }
    a.empty_radius = std::max(a.empty_radius, b.empty_radius);
    return a;
}

ClosureMeasures measure_range(int dimension, const ClosureSource& closure_of, std::uint32_t first, std::uint32_t last,
                              double known_empty_radius)
{
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(first, last), ClosureMeasures{},
        [&](const tbb::blocked_range<std::uint32_t>& range, ClosureMeasures measures) {
            EmptyBallSearch search(dimension);
            Closure closure;
            for (std::uint32_t tile = range.begin(); tile < range.end(); ++tile) {
                closure_of(tile, closure);
                const auto [squared, pair] = nearest_pair(tile, closure.points);
                const double empty_radius = closure.border.empty()
                                                ? search.radius(closure.points, known_empty_radius)
                                                : search.radius_in(closure.border, closure.points, known_empty_radius);
                measures = joined(measures, {static_cast<std::uint64_t>(squared), pair, empty_radius});
            }
            return measures;
        },
        joined);
}

}

/// The largest radius of the first tiles does not depend on threads, and so nor does what is found with its help.
ClosureMeasures measure_closures(const PoissonTileParameters& parameters, const ClosureSource& closure_of)
{
    const std::uint32_t first = std::min(parameters.tiles, first_tiles);
    const ClosureMeasures measures = measure_range(parameters.dimension, closure_of, 0, first, 0);
    return joined(measures,
                  measure_range(parameters.dimension, closure_of, first, parameters.tiles, measures.empty_radius));
}

TileCertificate certificate_of(const PoissonTileParameters& p, const ClosureMeasures& measures,
                               std::uint64_t squared_separation)
{
    TileCertificate result;
    result.tiles = p.tiles;
    result.points_per_tile = p.points_per_tile;
    result.squared_closure_distance = measures.squared_distance;
    result.squared_separation = squared_separation;
    result.nearest = measures.nearest;
    result.squared_min_distance = std::min(result.squared_closure_distance, result.squared_separation);
    result.relative_radius = relative_radius_of(result.squared_min_distance, p);
    result.largest_empty_radius = (1 + EmptyBallSearch::tolerance) * measures.empty_radius / tile_units;
    result.largest_empty_radius_in_min_distances =
        result.largest_empty_radius * tile_units / std::sqrt(static_cast<double>(result.squared_min_distance));
    return result;
}

std::uint32_t first_tile_where(std::uint32_t tiles, const std::function<bool(std::uint32_t tile)>& holds)
{
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, tiles), tiles,
        [&](const tbb::blocked_range<std::uint32_t>& range, std::uint32_t lowest) {
            for (std::uint32_t tile = range.begin(); tile < std::min(range.end(), lowest); ++tile) {
                if (holds(tile)) return tile;
            }
            return lowest;
        },
        [](std::uint32_t a, std::uint32_t b) { return std::min(a, b); });
}

}
