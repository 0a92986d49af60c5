// Tile conditions are what each tile has to meet when all tiles are moved together: docs/chain-tiles.md.
//
// A condition is a sum over a tile's points of a function of where they are. Moments are to be the same in all tiles.
// Low waves are only to change by the same, nearly: the power of tilings between the peaks of the lattice is how the
// transforms of tiles differ, so a movement that suits the mean tile, and changes each tile in its own way, adds to it.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/poisson/tile_moments.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

class TileConditions
{
public:
    /// Positions count from the middle of the tile; the unit is half a tile, so that all numbers are of order 1.
    using Position = std::array<double, 3>;

    /// Equal moments as parameters ask for them and, for tiles with chains, waves from half a cycle to one and a half a
    /// tile.
    explicit TileConditions(const PoissonTileParameters& parameters);

    std::size_t count() const { return monomials_.size() + 2 * waves_.size(); }

    /// Finds the values that a point at a position adds to the conditions.
    void values(const Position& at, std::span<double> values) const;

    /// Finds how values() change along each axis: axis after axis, condition after condition.
    void slopes(const Position& at, std::span<double> slopes) const;

    /// Are tiles to stay as different as they are? If not, they are to become the same.
    bool stays(std::size_t condition) const { return condition >= monomials_.size(); }

    /// The softness of the condition: one over what the square of missing it costs, where that of the movement that
    /// it takes costs 1; 0: it is not missed.
    double softness(std::size_t condition) const;

private:
    /// Half cycles a tile along x and y.
    using Wave = std::array<int, 2>;
    static std::vector<Wave> low_waves();

    int dimension_;
    std::vector<Monomial> monomials_;
    std::vector<Wave> waves_; ///< two conditions each: the cosine and the sine
};

}
