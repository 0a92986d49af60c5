// Chains as paths through points that are there: docs/chain-tiles.md.
#pragma once

#include "host/tile_construction/filling/tile_filling.hpp"
#include "tiles/poisson/chain_pieces.hpp"

#include <optional>
#include <vector>

namespace poissonlab {

/// The area, in points, that a chain leaves to the tile above it (to its left, if it goes up), less half of its
/// own points. Tiles have room for exactly their number of points where all chains of a direction have the same
/// balance.
double chain_balance(const ChainPieces& pieces, std::size_t direction, std::uint32_t lower, std::uint32_t upper,
                     std::uint32_t points_per_tile);

/// A chain that tiles may get.
struct ChainCandidate
{
    Chain chain;
    double balance = 0;
};

/// Finds chains in tori that were filled around corner points.
class ChainFinder
{
public:
    explicit ChainFinder(const PoissonTileParameters& parameters);

    /// The shortest path from corner to corner along an edge of the torus, of links that no disk fits through, through
    /// points in both cones; short links and those near the straight line, bent so that it halves the area, are
    /// preferred. `points` lie on the torus, in even units.
    std::optional<ChainCandidate> find(const ChainPieces& corners, const PlacedChain& edge,
                                       const std::vector<TilePosition>& points) const;

private:
    std::int64_t squared_distance_; ///< the minimum distance, squared
    double spacing_;                ///< units
    std::uint32_t points_per_tile_;
};

}
