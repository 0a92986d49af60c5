// Normals of a texture set's heights, without seams in any tiling.
//
// They are of the finished tiles: where two windows of the exemplar meet, the step of the heights is in the normals as
// well, which copies of a normal map would not have. Across a border lies a texel that the shared colours decide, in a
// tiling and in the atlas: differences of neighbours in a packed atlas are those of every tiling.
#pragma once

#include "tiles/texture/engine/engine_map.hpp"

namespace poissonlab {

/// Normals of heights from 0 to 1, which are `relief` texels high: (-dh/dx, -dh/dy, 1) at length 1, x going east and y
/// north, by central differences; at the corner texels of Wang tiles, which are those of horizontal edges, the
/// difference along x is within the tile. 16 bits a channel. Throws InputError for sets whose tiles are in no packing,
/// those without a ring, and maps of several channels.
EngineMap height_normals(const EngineMap& heights, const TextureSet& set, double relief);

}
