// The largest tiles of recursive Wang tiles: a torus of few of them has few tilings, and realizations should be
// different ones.
#pragma once

#include "base/random/random.hpp"

#include <cstdint>
#include <set>
#include <vector>

namespace poissonlab {

/// Even Wang tiles on a torus of side x side, row by row from the lower left.
using RootTiles = std::vector<std::uint32_t>;

/// The tiles of a torus by the direct algorithm with one hash function.
RootTiles hashed_root_tiles(std::uint32_t side, const StreamKey& stream);

/// The first, in the order of their tiles, of all tilings that are this one shifted on its torus.
RootTiles least_shifted(const RootTiles& tiles, std::uint32_t side);

/// The tilings of realizations. Each is hashed; on a torus of 2 x 2 to 4 x 4 tiles, one that an earlier realization
/// has, maybe shifted, is drawn again from all tilings, until it is another one. When all have been drawn, 14 of
/// 2 x 2 tiles, 128 of 3 x 3, or 8,312 of 4 x 4, they are repeated.
class RealizationRoots
{
public:
    RealizationRoots(std::uint32_t side, std::uint64_t seed) : side_(side), seed_(seed) {}

    /// The tiling of realization 0, 1, ...: it does not depend on which ones were asked for before.
    RootTiles of(std::uint32_t realization);

private:
    void draw_next();

    std::uint32_t side_;
    std::uint64_t seed_;
    std::vector<RootTiles> drawn_; ///< of the first realizations, on a small torus
    std::set<RootTiles> seen_;     ///< least_shifted() ones of these
};

}
