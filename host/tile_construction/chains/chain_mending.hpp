// Moving chains sideways, and mending what movement broke: docs/chain-tiles.md.
#pragma once

#include "tiles/poisson/chain_pieces.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

/// A chain in arbitrary positions, between corner points that stay.
struct LooseChain
{
    std::size_t direction = 0;
    std::array<UnitPosition, 2> ends{};
    std::vector<std::array<double, 2>> points;
};

/// Pushes apart points that are nearer than the minimum distance, pulls together links that are too long, and pushes
/// points back into the cones, until all of it holds in even units; nothing where that does not come about.
std::optional<Chain> mended(const LooseChain& chain, std::int64_t squared_distance);

// Moving chains so that the tiles on both sides of them can have equal moments: docs/chain-tiles.md.
//
// A tile that is filled evenly has moments that follow from its four chains: each gives the tile that owns it, and
// takes from the tile on its other side, its share. Where all chains of a direction have the same share, all tiles have
// the same moments without being any less even. The share of order 0 is the chain's balance.

/// Moves points of chains of one direction towards the mean share of all, of orders up to that of the moments. No point
/// moves farther than `longest`, in units.
void even_out(std::vector<LooseChain>& chains, const PoissonTileParameters& parameters, double longest);

/// The shares of chains: what each gives the tile that owns it beyond an even tile's part.
class ChainShares
{
public:
    explicit ChainShares(const PoissonTileParameters& parameters);

    /// The share of a chain of each monomial of the coordinates along and across it, from the middle of its edge; the
    /// unit of lengths is half a tile.
    std::vector<double> of(const LooseChain& chain) const;

    std::size_t count() const { return exponents_.size(); }

private:
    double points_per_area_;
    std::vector<std::array<unsigned, 2>> exponents_;
};

}
