// The torus of tiles on which a set is relaxed together: which tile is where, and where the copies of its points are.
#pragma once

#include "host/tile_construction/joint_relaxation.hpp"
#include "tiles/poisson/chain_pieces.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// The side of the torus, in tiles: it shows each tile four times on average, and has 144 tiles or more.
std::uint32_t joint_side(const PoissonTileParameters& parameters);

/// The tiles of a random torus, row after row from below, that shows every tile of the set at least once, if chance
/// allows. Every iteration has its own.
std::vector<std::uint32_t> joint_tiling(const PoissonTileParameters& parameters, std::uint32_t iteration);

/// The stored points of a set with chains in one list: corner points by colour, chains by direction and number, the
/// insides of tiles.
class StoredPoints
{
public:
    explicit StoredPoints(const ChainPieces& pieces);

    std::size_t count() const { return count_; }
    std::size_t corner(std::uint32_t color) const { return color; }
    std::size_t chain(std::size_t direction, std::size_t number) const { return chains_[direction][number]; }
    std::size_t interior(std::uint32_t tile) const { return interiors_[tile]; }

    /// The mean tile. Chains move or are held; corner points are always held.
    std::vector<WeightedPoint> mean_tile(const ChainPieces& pieces, bool chains_move) const;

    /// All copies on a torus.
    JointTorus torus(const ChainPieces& pieces, std::uint32_t side, const std::vector<std::uint32_t>& tiles) const;

private:
    std::array<std::vector<std::size_t>, chain_directions> chains_; ///< the number of the first point
    std::vector<std::size_t> interiors_;
    std::size_t count_;
};

}
