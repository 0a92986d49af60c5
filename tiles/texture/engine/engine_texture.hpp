// Maps of a texture set as textures of graphics cards: the packed atlas, and an array with a layer for each tile.
#pragma once

#include "base/images/gpu_texture.hpp"
#include "tiles/texture/engine/engine_map.hpp"

namespace poissonlab {

/// The place of a tile among the layers of an array: its place in the atlas, counted from the lower left as
/// runtime/texture_tiles.h does, for complete sets; otherwise its number in texture.json.
std::vector<std::size_t> tile_layers(const TextureSet& set);

/// A texture of the whole atlas, and one with a layer for each tile.
GpuTexture packed_texture(const EngineMap& map, int tile_size);
GpuTexture layered_texture(const EngineMap& map, const TextureSet& set);

/// The texels of one tile of a level.
RawPicture tile_of_level(const RawPicture& level, const AtlasLayout& layout, std::size_t tile);

}
