#include "tiles/poisson/proof/tile_certificate.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/proof/chain_certificate.hpp"
#include "tiles/poisson/proof/closure_measures.hpp"
#include "tiles/poisson/proof/piece_extents.hpp"
#include "tiles/poisson/proof/shared_pieces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

TileCertificate certify_strips(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    const SharedPieces pieces(set);
    const ClosureMeasures measures =
        measure_closures(p, [&](std::uint32_t tile, Closure& closure) { pieces.closure(tile, closure.points); });
    const std::vector<Extents> extents = piece_extents(set, pieces);
    TileCertificate result = certificate_of(p, measures, squared_separation(extents, extents, p.dimension));
    result.regions = region_counts(set);
    result.classes = certify_classes(set);
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
