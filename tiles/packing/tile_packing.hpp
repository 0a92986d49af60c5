// Tile packings: all C^4 tiles of a complete set of Wang or corner tiles on a torus of C^2 x C^2 places, so that all
// neighbours fit.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.5. Texture atlases are packings: what lies
// beside a tile in the picture has the same colours as what lies beside it in a tiling.
#pragma once

#include "tiles/tilings/tile_set.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// A place of a packing: x eastwards and y northwards, from 0 to C^2 - 1.
struct PackingPlace
{
    Color x = 0;
    Color y = 0;

    bool operator==(const PackingPlace&) const = default;
};

struct TilePacking
{
    TileKind kind = TileKind::corner; ///< or wang
    Color colors = 2;
    std::vector<TileIndex> tiles; ///< C^4 of them, rows from south to north, each from west to east

    Color side() const { return colors * colors; }
    TileIndex at(PackingPlace place) const { return tiles[std::size_t{place.y} * side() + place.x]; }
};

/// True if `east` fits beside `west`: Wang tiles share the colour of an edge, corner tiles those of two corners.
bool fits_east(TileKind kind, WangColors colors, TileIndex west, TileIndex east);
inline bool fits_east(TileKind kind, Color colors, TileIndex west, TileIndex east)
{
    return fits_east(kind, WangColors{colors, colors}, west, east);
}

/// True if `north` fits above `south`: they share colours as in fits_east().
bool fits_north(TileKind kind, WangColors colors, TileIndex south, TileIndex north);
inline bool fits_north(TileKind kind, Color colors, TileIndex south, TileIndex north)
{
    return fits_north(kind, WangColors{colors, colors}, south, north);
}

/// One line on the first mistake from the south-west: a tile that is there twice, or neighbours that do not fit.
/// Empty for a packing. The list must have C^4 tiles of the set.
std::optional<std::string> packing_fault(const TilePacking& packing);

/// The corner colours at the lattice points of a packing of corner tiles, rows from south to north: (x, y) is the lower
/// left corner of the tile there. A torus of colours is a packing exactly when its C^4 windows of 2 x 2 differ.
std::vector<Color> corner_colors_of(const TilePacking& packing);

/// The corner tiles of a torus of C^2 x C^2 corner colours, packing or not.
TilePacking packing_of_corner_colors(Color colors, const std::vector<Color>& corners);

/// Reads C^2 lines of C^2 indices, north first, as `poissonlab packing` prints them; empty lines are left out. Throws
/// InputError, with the line, for anything else. Whether it is a packing is another question: packing_fault().
TilePacking read_packing(const std::filesystem::path& file, TileKind kind, Color colors);

}
