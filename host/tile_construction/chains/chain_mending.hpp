// Moving chains sideways, and mending what movement broke: docs/chain-tiles.md.
#pragma once

#include "tiles/poisson/chain_pieces.hpp"

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

}
