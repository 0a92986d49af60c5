#include "tiles/poisson/tile_certificate.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/chain_certificate.hpp"
#include "tiles/poisson/closure_measures.hpp"
#include "tiles/poisson/shared_pieces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The smallest and largest coordinates of points, relative to the base of their cell.
struct Extents
{
    UnitPosition low{INT32_MAX, INT32_MAX, INT32_MAX};
    UnitPosition high{INT32_MIN, INT32_MIN, INT32_MIN};

    bool are_empty() const { return low[0] > high[0]; }

    void include(const Extents& other)
    {
        if (other.are_empty()) return;
        include(other.low);
        include(other.high);
    }

    void include(const UnitPosition& position)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], position[k]);
            high[k] = std::max(high[k], position[k]);
        }
    }
};

/// The extents of the interiors of all tiles.
Extents interior_extents(const PoissonTileSet& set, const TileRegions& regions)
{
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, set.parameters.tiles), Extents{},
        [&](const tbb::blocked_range<std::uint32_t>& range, Extents extents) {
            for (std::uint32_t tile = range.begin(); tile < range.end(); ++tile) {
                const std::span<const std::uint16_t> points = set.tile(tile);
                for (std::size_t i = 0; i < points.size(); i += dimension) {
                    const auto point = points.subspan(i, dimension);
                    if (regions.cell_of(point).axes == all_axes(set.parameters.dimension))
                        extents.include(UnitPosition{point[0], point[1], dimension == 3 ? point[2] : 0});
                }
            }
            return extents;
        },
        [](Extents a, const Extents& b) {
            a.include(b);
            return a;
        });
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

TileCertificate certify_strips(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    const SharedPieces pieces(set);
    const ClosureMeasures measures =
        measure_closures(p, [&](std::uint32_t tile, Closure& closure) { pieces.closure(tile, closure.points); });
    const Extents interior = interior_extents(set, pieces.regions());
    TileCertificate result =
        certificate_of(p, measures, squared_separation(extents_of(set, pieces, interior), p.dimension));
    result.regions = region_counts(set);
    return result;
}

}

TileCertificate certify(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    check(p);
    const std::size_t coordinates = std::size_t{p.tiles} * p.points_per_tile * static_cast<std::size_t>(p.dimension);
    if (set.points.size() != coordinates)
        throw InputError(fmt::format("{} coordinates: must be {}", set.points.size(), coordinates));
    const std::size_t chains = p.border == TileBorder::chain ? std::size_t{2} * p.colors * p.colors : 0;
    if (set.chain_lengths.size() != chains)
        throw InputError(fmt::format("{} lengths of chains: must be {}", set.chain_lengths.size(), chains));
    check_ranks(set);
    TileCertificate result = p.border == TileBorder::chain ? certify_chains(set) : certify_strips(set);
    result.moments = tile_moments(set);
    return result;
}

std::string described(const NearestPair& pair, int dimension)
{
    const auto place = [&](const UnitPosition& at) {
        return fmt::format("({})", fmt::join(at.begin(), at.begin() + dimension, ", "));
    };
    return fmt::format("the points at {} and {} of tile {}", place(pair.points[0]), place(pair.points[1]), pair.tile);
}

void check_promises(const PoissonTileParameters& parameters, std::uint64_t stored_squared_distance,
                    const TileCertificate& certificate)
{
    const std::uint64_t proven = certificate.squared_min_distance;
    std::string nearest; // where they are two points that are seen to be that near
    if (proven == certificate.squared_closure_distance)
        nearest = fmt::format(": see {}", described(certificate.nearest, parameters.dimension));
    if (stored_squared_distance > proven)
        throw InputError(
            fmt::format("guarantees a squared minimum distance of {}: must be at most {}, which is proven{}",
                        stored_squared_distance, proven, nearest));
    if (proven < asked_squared_distance(parameters))
        throw InputError(fmt::format("relative_radius = {}: must be at most {:.6f}, which is proven{}",
                                     parameters.relative_radius, std::floor(certificate.relative_radius * 1e6) / 1e6,
                                     nearest));
    check_moments(parameters, certificate.moments);
}

}
