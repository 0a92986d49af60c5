// Maps of a texture set as engines take them: colours, companions, and normals of heights, at all levels, each level of
// a tile made of the tile's own texels. Levels of a whole atlas would mix tiles that are no neighbours in a tiling.
#pragma once

#include "base/images/raw_picture.hpp"
#include "tiles/texture/texture_set.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The meaning of a map's numbers, which decides how they are averaged.
enum class MapMeaning
{
    colors,     ///< integers are sRGB: means are of light
    numbers,    ///< heights, roughness: means are of themselves
    directions, ///< normals, of length 1: so are their means; 0 to 1 is -1 to 1
};

/// One map of all tiles, which lie as in the atlas: numbers, rows from north to south, channels side by side. Light,
/// integers, float32 and components from -1 to 1 are all held as double.
struct EngineMap
{
    std::string name; ///< empty: atlas.png
    MapMeaning meaning = MapMeaning::numbers;
    SampleType type = SampleType::byte; ///< of files
    int width = 0, height = 0, channels = 1;
    std::vector<double> values;
};

/// The map of atlas.png.
EngineMap color_map(const TextureSet& set);

/// The map of atlas.png, and those of companions, whose atlases are read from the set's folder. `heights` is a
/// companion of which a map NAME-normals follows, where `relief` texels are from a height of 0 to one of 1; empty:
/// none. Throws InputError for files that do not fit, for more than 4 channels, and as height_normals() does.
std::vector<EngineMap> engine_maps(const std::filesystem::path& folder, const TextureSet& set,
                                   const std::string& heights = {}, double relief = 1);

/// Levels that a tile of so many texels has: it is halved while it is even.
int tile_levels(int size);

/// The next level: means of 2 x 2 texels. Sides of tiles must be even.
EngineMap halved(const EngineMap& map);

/// A level as a picture: as many channels as the map has.
RawPicture encoded_level(const EngineMap& map);

}
