// Giving all tiles of a set the same moments, whatever their borders are: the last step of a construction.
#pragma once

#include "host/tile_construction/moments/moment_targets.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// The operations on tiles that constructions of different borders offer to the evening of moments.
struct EvenableTiles
{
    using Tiles = std::vector<std::uint32_t>;

    /// Returns the set as it is.
    std::function<PoissonTileSet()> set;

    /// Pushes the points of tiles apart and towards the moments. Returns those that do not get there, in order.
    std::function<Tiles(const MomentTargets& targets, const Tiles& tiles)> settle;

    /// Throws the points of tiles anew, then does what settle() does; rounds have their own random numbers.
    std::function<Tiles(const MomentTargets& targets, const Tiles& tiles, std::uint32_t round)> settle_anew;

    /// Makes the moments of a tile exact; false where that cannot be done. Called from several threads.
    std::function<bool(const MomentTargets& targets, std::uint32_t tile)> make_exact;

    /// Replaces what tiles share with others, for tiles that cannot have the moments; false: it has nothing else.
    std::function<bool(const Tiles& tiles)> give_way;

    std::uint32_t rounds = 1; ///< of throwing points anew

    std::vector<std::vector<UnitPosition>>& insides; ///< their points that no other tile has

    /// Moves insides by a step of nulling; empty: they are not nulled after moments are equal.
    std::function<void()> null_peaks;
};

/// Brings all tiles to the mean of their moments. Throws InputError where some cannot have them: with the order that
/// they can have. `progress`: told how many of how many tiles are done.
void make_moments_equal(const PoissonTileParameters& parameters, const EvenableTiles& tiles,
                        const std::function<void(std::size_t done, std::size_t total)>& progress);

}
