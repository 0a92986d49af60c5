// Positions near a Poisson disk tile, in whole units of which a tile's side has 65,536.
#pragma once

#include <array>
#include <cstdint>

namespace poissonlab {

/// A position on a torus of tiles, or a movement. In 2D the last coordinate is 0.
using TilePosition = std::array<std::int32_t, 3>;

}
