#include "tiles/poisson/tile_certificate.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/empty_ball_bound.hpp"
#include "tiles/poisson/shared_pieces.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// Tiles that are searched for empty circles first, each on its own: the others need only look for larger
/// ones.
constexpr std::uint32_t first_tiles = 32;

/// The smallest and largest coordinates of points, relative to the base of their cell.
struct Extents
{
    UnitPosition low{INT32_MAX, INT32_MAX, INT32_MAX};
    UnitPosition high{INT32_MIN, INT32_MIN, INT32_MIN};

    bool are_empty() const { return low[0] > high[0]; }

    void include(const UnitPosition& position)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], position[k]);
            high[k] = std::max(high[k], position[k]);
        }
    }
};

/// The measures of one tile, or those of several joined.
struct Measures
{
    std::uint64_t squared_distance = UINT64_MAX;
    double empty_radius = 0;
    Extents interior;

    void join(const Measures& other)
    {
        squared_distance = std::min(squared_distance, other.squared_distance);
        empty_radius = std::max(empty_radius, other.empty_radius);
        if (!other.interior.are_empty()) {
            interior.include(other.interior.low);
            interior.include(other.interior.high);
        }
    }
};

/// Goes along x: points that are farther apart along it than the smallest distance are not compared.
std::uint64_t squared_min_distance(std::vector<UnitPosition>& points)
{
    std::ranges::sort(points, {}, [](const UnitPosition& position) { return position[0]; });
    std::int64_t smallest = INT64_MAX;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            const std::int64_t x = points[j][0] - points[i][0];
            if (x * x >= smallest) break;
            const std::int64_t y = points[j][1] - points[i][1];
            const std::int64_t z = points[j][2] - points[i][2];
            smallest = std::min(smallest, x * x + y * y + z * z);
        }
    }
    return static_cast<std::uint64_t>(smallest);
}

/// Measures tiles, one after the other.
class TileMeasurement
{
public:
    TileMeasurement(const PoissonTileSet& set, const SharedPieces& pieces)
        : set_(set), pieces_(pieces), search_(set.parameters.dimension)
    {}

    Measures measure(std::uint32_t tile, double known_empty_radius)
    {
        Measures measures;
        measures.interior = interior_of(tile);
        pieces_.closure(tile, closure_);
        measures.squared_distance = squared_min_distance(closure_);
        measures.empty_radius = search_.radius(closure_, known_empty_radius);
        return measures;
    }

private:
    Extents interior_of(std::uint32_t tile) const
    {
        const auto dimension = static_cast<std::size_t>(set_.parameters.dimension);
        const std::span<const std::uint16_t> points = set_.tile(tile);
        Extents extents;
        for (std::size_t i = 0; i < points.size(); i += dimension) {
            const auto point = points.subspan(i, dimension);
            if (pieces_.regions().cell_of(point).axes == all_axes(set_.parameters.dimension))
                extents.include({point[0], point[1], dimension == 3 ? point[2] : 0});
        }
        return extents;
    }

    const PoissonTileSet& set_;
    const SharedPieces& pieces_;
    EmptyBallSearch search_;
    std::vector<UnitPosition> closure_;
};

Measures measure_tiles(const PoissonTileSet& set, const SharedPieces& pieces, std::uint32_t first, std::uint32_t last,
                       double known_empty_radius)
{
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(first, last), Measures{},
        [&](const tbb::blocked_range<std::uint32_t>& range, Measures measures) {
            TileMeasurement measurement(set, pieces);
            for (std::uint32_t tile = range.begin(); tile < range.end(); ++tile)
                measures.join(measurement.measure(tile, known_empty_radius));
            return measures;
        },
        [](Measures a, const Measures& b) {
            a.join(b);
            return a;
        });
}

/// The largest radius of the first tiles does not depend on threads, and so nor does what is found with its
/// help.
Measures measure_all(const PoissonTileSet& set, const SharedPieces& pieces)
{
    const std::uint32_t first = std::min(set.parameters.tiles, first_tiles);
    Measures measures = measure_tiles(set, pieces, 0, first, 0);
    measures.join(measure_tiles(set, pieces, first, set.parameters.tiles, measures.empty_radius));
    return measures;
}

/// The extents of pieces by axes, the interior last.
std::vector<Extents> extents_of(const PoissonTileSet& set, const SharedPieces& pieces, const Extents& interior)
{
    std::vector<Extents> extents(all_axes(set.parameters.dimension));
    for (std::uint8_t axes = 0; axes < extents.size(); ++axes) {
        for (std::uint32_t variant = 0; variant < piece_count(set.parameters, axes); ++variant)
            for (const UnitPosition& position : pieces.piece(axes, variant)) extents[axes].include(position);
    }
    extents.push_back(interior);
    return extents;
}

/// The lower bound for points of cells that have no tile in common; see the proof in the header.
std::uint64_t squared_separation(const std::vector<Extents>& extents, int dimension)
{
    std::int64_t smallest = 2 * tile_units; // where no cell has a point, places two above
    for (const Extents& lower : extents) {
        for (std::size_t axes = 0; axes < extents.size(); ++axes) {
            const Extents& upper = extents[axes];
            if (lower.are_empty() || upper.are_empty()) continue;
            for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
                const int places = axes >> k & 1 ? 1 : 2;
                smallest = std::min<std::int64_t>(smallest, places * tile_units + upper.low[k] - lower.high[k]);
            }
        }
    }
    return static_cast<std::uint64_t>(std::max<std::int64_t>(smallest, 0) * std::max<std::int64_t>(smallest, 0));
}

}

TileCertificate certify(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    check(p);
    const std::size_t coordinates = std::size_t{p.tiles} * p.points_per_tile * static_cast<std::size_t>(p.dimension);
    if (set.points.size() != coordinates)
        throw InputError(fmt::format("{} coordinates: must be {}", set.points.size(), coordinates));
    const SharedPieces pieces(set);
    const Measures measures = measure_all(set, pieces);
    TileCertificate result{p.tiles, p.points_per_tile};
    result.squared_closure_distance = measures.squared_distance;
    result.squared_separation = squared_separation(extents_of(set, pieces, measures.interior), p.dimension);
    result.squared_min_distance = std::min(result.squared_closure_distance, result.squared_separation);
    result.relative_radius = relative_radius_of(result.squared_min_distance, p);
    result.regions = region_counts(set);
    result.largest_empty_radius = (1 + EmptyBallSearch::tolerance) * measures.empty_radius / tile_units;
    result.largest_empty_radius_in_min_distances =
        result.largest_empty_radius * tile_units / std::sqrt(static_cast<double>(result.squared_min_distance));
    return result;
}

}
