// Tiles whose corners are marked or not: what belongs to marked corners shows a second exemplar.
//
// Cohen, Shade, Hiller, Deussen, Wang Tiles for Image and Texture Generation, 2003, sections 3.4 and 3.5. Corner tiles
// have marks in the classes of their colours, the second half of which is that of marked corners. Wang tiles have them
// in the colours of their edges: an edge of colour c whose western (southern) corner has the mark a, 0 or 1, and whose
// eastern (northern) one has b counts as colour 4 c + 2 a + b. Tiles that fit by such colours agree on their marks, and
// everything that holds for Wang tiles holds for them.
#pragma once

#include "tiles/texture/texture_set.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <vector>

namespace poissonlab {

/// The colour of an edge with the marks of its ends.
constexpr Color marked_edge(Color color, Color first_mark, Color last_mark)
{
    return 4 * color + 2 * first_mark + last_mark;
}

/// The colour of such an edge without its marks.
constexpr Color unmarked_edge(Color edge) { return edge / 4; }

/// The number of colours of edges with marks, and without them.
constexpr WangColors marked_colors(WangColors colors) { return {4 * colors.horizontal, 4 * colors.vertical}; }
constexpr WangColors unmarked_colors(WangColors colors) { return {colors.horizontal / 4, colors.vertical / 4}; }

/// The Wang tile with these edges and marks of its corners, which are 0 or 1.
WangTile marked_wang_tile(const WangTile& edges, const CornerTile& marks);

/// Wang tiles over edges with marks: each of `edges` with all sixteen marks of its corners (Cohen's 128 of 8 tiles), as
/// a map of marks needs them.
std::vector<TextureTile> marked_wang_tiles(const std::vector<TextureTile>& edges, WangColors colors);

/// The half of them that is enough where marks are at random (Cohen's 64 of 8 tiles): of the two tiles for a northern
/// and a western edge, the first has no mark in the south-east, the second has. `edges` are a compact set, whose first
/// tile for a pair is the one with the eastern colour of the northern one.
std::vector<TextureTile> randomly_marked_wang_tiles(const std::vector<TextureTile>& edges, WangColors colors);

/// The marks of the corners of a tile of a set with two classes, 0 or 1.
CornerTile marks_of(const TextureSet& set, TileIndex index);

/// True if two tiles of a set with two classes differ in their marks at most.
bool differ_in_marks_alone(const TextureSet& set, TileIndex a, TileIndex b);

/// False where two edges of a Wang tile say different things about the mark of their corner.
bool agrees_on_marks(const WangTile& tile);

}
