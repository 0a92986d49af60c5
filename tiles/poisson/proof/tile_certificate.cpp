#include "tiles/poisson/proof/tile_certificate.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/chain_geometry.hpp"
#include "tiles/poisson/chain_pieces.hpp"
#include "tiles/poisson/proof/closure_measures.hpp"
#include "tiles/poisson/proof/shared_pieces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

// A proof of the minimum distance of every tiling of a tile set whose borders are chains: docs/chain-tiles.md, theorem.
//
// Looked at, in whole numbers: that all tiles hold the same shared pieces; all distances among the points of a tile
// and its border; the length of every link; that every border is a simple polygon with the tile's own points inside;
// and that chains keep to their cones and near their edges, so that those without a common tile stay apart.

/// The points of a tile and of its border.
void find_chain_closure(const ChainPieces& pieces, std::uint32_t tile, Closure& closure)
{
    closure.border = border_polygon(pieces, tile);
    closure.points = closure.border;
    closure.points.insert(closure.points.end(), pieces.interiors[tile].begin(), pieces.interiors[tile].end());
}

/// The fault of a tile's border or its inside; empty: there is none.
std::string fault_of_tile(const ChainPieces& pieces, std::uint32_t tile)
{
    const std::vector<UnitPosition> polygon = border_polygon(pieces, tile);
    if (!is_simple(polygon)) return "its border must not cross itself";
    for (const UnitPosition& point : pieces.interiors[tile])
        if (!is_strictly_inside(polygon, point))
            return fmt::format("its point at ({}, {}) must be inside of its border", point[0], point[1]);
    return {};
}

void check_tiles(const ChainPieces& pieces, std::uint32_t tiles)
{
    const std::uint32_t wrong =
        first_tile_where(tiles, [&](std::uint32_t tile) { return !fault_of_tile(pieces, tile).empty(); });
    if (wrong < tiles) throw InputError(fmt::format("tile {}: {}", wrong, fault_of_tile(pieces, wrong)));
}

template <class Visit>
void for_each_chain(const ChainPieces& pieces, const Visit& visit)
{
    for (std::size_t direction = 0; direction < chain_directions; ++direction)
        for (std::uint32_t lower = 0; lower < pieces.colors; ++lower)
            for (std::uint32_t upper = 0; upper < pieces.colors; ++upper) visit(direction, lower, upper);
}

/// The fault of the first chain that does not keep this distance; empty: all do.
std::string fault_of_chains(const ChainPieces& pieces, std::int64_t squared_distance)
{
    constexpr std::array names{"to the right", "upwards"};
    std::string first;
    for_each_chain(pieces, [&](std::size_t direction, std::uint32_t lower, std::uint32_t upper) {
        if (!first.empty()) return;
        if (const auto fault = fault_of_chain(pieces, direction, lower, upper, squared_distance))
            first = fmt::format("chain {} from colour {} to {}: {}", names[direction], lower, upper, *fault);
    });
    return first;
}

void check_chains(const ChainPieces& pieces, std::int64_t squared_distance)
{
    if (const std::string fault = fault_of_chains(pieces, squared_distance); !fault.empty()) throw InputError(fault);
}

/// Names the chain that does not keep the distance that was asked for. Chains that keep it may have links too long for
/// a smaller distance: then the points that are so near are named, as chains are innocent of that.
void check_what_was_asked(const ChainPieces& pieces, const ClosureMeasures& measures, std::int64_t measured,
                          std::int64_t asked)
{
    const bool are_too_near = measured < asked && measured == static_cast<std::int64_t>(measures.squared_distance);
    check_chains(pieces, are_too_near ? asked : std::min(measured, asked));
    if (!are_too_near || fault_of_chains(pieces, measured).empty()) return;
    throw InputError(fmt::format("{} are {:.1f} units apart: must be at least {:.1f}, the distance of the set's "
                                 "relative radius",
                                 described(measures.nearest, 2),
                                 std::sqrt(static_cast<double>(measures.squared_distance)),
                                 std::sqrt(static_cast<double>(asked))));
}

std::int64_t clearance(const ChainPieces& pieces)
{
    std::int64_t least = INT64_MAX;
    for_each_chain(pieces, [&](std::size_t direction, std::uint32_t lower, std::uint32_t upper) {
        least = std::min(least, squared_clearance(pieces, direction, lower, upper));
    });
    return least;
}

/// The largest distance of shared points from their lattice point or edge.
struct Wander
{
    std::int64_t corner = 0;                             ///< along either axis
    std::array<std::int64_t, chain_directions> across{}; ///< the chain's direction
    std::int64_t before = 0, beyond = 0;                 ///< the ends, along the chain's direction
};

Wander wander_of(const ChainPieces& pieces)
{
    Wander wander;
    for (const UnitPosition& corner : pieces.corners)
        for (std::size_t k = 0; k < 2; ++k) wander.corner = std::max<std::int64_t>(wander.corner, std::abs(corner[k]));
    for (std::size_t direction = 0; direction < chain_directions; ++direction)
        for (const Chain& chain : pieces.chains[direction])
            for (const UnitPosition& point : chain) {
                std::int64_t& across = wander.across[direction];
                across = std::max<std::int64_t>(across, std::abs(point[1 - direction]));
                wander.before = std::max<std::int64_t>(wander.before, -point[direction]);
                wander.beyond = std::max<std::int64_t>(wander.beyond, point[direction] - tile_units);
            }
    return wander;
}

/// A lower bound of the distance of points of chains and corners that have no tile in common. Those at opposite sides
/// of a corner are apart by their cones; of all others, one axis keeps them apart: two corners are two tiles apart,
/// a corner and a chain at least one; chains in the same direction one, and so are a chain that goes along the axis
/// and one across it, but for what they wander.
std::int64_t separation(const ChainPieces& pieces)
{
    const Wander w = wander_of(pieces);
    const std::int64_t end = std::max(w.before, w.beyond);
    const std::int64_t across = *std::ranges::max_element(w.across);
    std::int64_t smallest = 2 * tile_units - 2 * w.corner;             // two corners
    smallest = std::min(smallest, tile_units - w.corner - end);        // a corner beyond a chain's end
    smallest = std::min(smallest, 2 * tile_units - w.corner - across); // a corner two rows off a chain
    smallest = std::min(smallest, tile_units - 2 * end);               // chains of a row, an edge between them
    smallest = std::min(smallest, 2 * tile_units - 2 * across);        // chains two rows off each other
    smallest = std::min(smallest, tile_units - across - end);          // a chain and one across it, beyond its end
    return std::max<std::int64_t>(smallest, 0);
}

/// The points of a tile's corner, of its own two chains, and inside; how many are expected nobody says.
std::array<RegionCounts, 4> chain_counts(const ChainPieces& pieces, const PoissonTileParameters& p)
{
    std::array<RegionCounts, 4> result{};
    for (std::size_t k = 0; k < 3; ++k) result[k].min = UINT32_MAX;
    for (std::uint32_t tile = 0; tile < p.tiles; ++tile) {
        const auto inside = static_cast<std::uint32_t>(pieces.interiors[tile].size());
        const std::array<std::uint32_t, 3> counts{1, p.points_per_tile - 1 - inside, inside};
        for (std::size_t k = 0; k < 3; ++k) {
            result[k].min = std::min(result[k].min, counts[k]);
            result[k].max = std::max(result[k].max, counts[k]);
            result[k].mean += counts[k];
        }
    }
    for (std::size_t k = 0; k < 3; ++k) result[k].mean /= p.tiles;
    return result;
}

/// Certifies a set with chains, as certify() does sets with strips. Throws InputError, a sentence that names the tile
/// or the chain, where the theorem does not hold.
TileCertificate certify_chains(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    const ChainPieces pieces = chain_pieces_of(set);
    check_tiles(pieces, p.tiles);
    const ClosureMeasures measures =
        measure_closures(p, [&](std::uint32_t tile, Closure& closure) { find_chain_closure(pieces, tile, closure); });
    const std::int64_t apart = separation(pieces);
    const auto measured = std::min(static_cast<std::int64_t>(measures.squared_distance), apart * apart);
    check_what_was_asked(pieces, measures, measured, static_cast<std::int64_t>(asked_squared_distance(p)));
    const auto kept = static_cast<std::uint64_t>(std::min(apart * apart, clearance(pieces)));
    TileCertificate result = certificate_of(p, measures, kept);
    check_chains(pieces, static_cast<std::int64_t>(result.squared_min_distance));
    result.regions = chain_counts(pieces, p);
    return result;
}

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
    result.class_moments = class_moments(set);
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
    PoissonTileParameters own = parameters; // those of a class
    for (std::size_t of = 0; of < certificate.class_moments.size(); ++of) {
        own.points_per_tile = parameters.classes.points[of];
        check_moments(own, certificate.class_moments[of], fmt::format("class {} in ", of));
    }
}

}
