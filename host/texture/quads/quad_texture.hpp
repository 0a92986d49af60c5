// This makes texture tiles for surfaces of quads: generalised Wang tiles, and corner tiles that may be turned.
//
// Fu and Leung, Texture tiling on arbitrary topological surfaces using Wang tiles, EGSR 2005. On a surface no direction
// is that of rows: a side of a quad may meet any side of the next one. Colours are then the same for all sides, and a
// side of a tile has a label that its neighbour sees from the other end: of Wang tiles, a colour and whether the tile
// lies to the left or to the right of the edge's own direction; of corner tiles, the colours of both ends. Tiles count
// once for their four turns, so that n labels of Wang tiles give (n^4 + n^2 + 2 n) / 4 of them. The slides of the class
// notes give no construction. Here a label has a piece of the exemplar across its edge, and a tile is quilted of the
// four halves of these (Cohen and others 2003); pieces are turned by quarters, so that exemplars should look alike from
// all sides. Whatever number of quads meet in a vertex, each pair of neighbouring edges there is joined by a cut.
#pragma once

#include "host/texture/piece_fitting.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

enum class QuadLabels
{
    wang,   ///< 2 colour + 1 for the right side
    corner, ///< first end's colour times the number of colours + second end's
};
inline constexpr WordTable<QuadLabels, 2> quad_label_words{
    {{{QuadLabels::wang, "wang"}, {QuadLabels::corner, "corner"}}}};

/// A tile has these labels of its sides, counterclockwise from the lower one.
using SideLabels = std::array<std::uint32_t, 4>;

/// A pixel of a tile comes from one of the exemplar, turned by quarters counterclockwise.
struct TurnedSource
{
    SourcePixel pixel;
    std::uint8_t turns = 0; ///< 0 to 3
};

struct QuadTextureRequest
{
    QuadLabels labels = QuadLabels::wang;
    std::uint32_t colors = 2;
    TextureRequest pieces; ///< size, candidates, seed, weight
};

/// A set is complete: it has a tile for all labels that may come together.
struct QuadTextureSet
{
    int size = 0;
    int gutter = 0;                               ///< pixels beyond each side, which a neighbour has as well
    std::vector<SideLabels> labels;               ///< of each tile: the least of its four turns
    std::vector<std::vector<TurnedSource>> tiles; ///< size + 2 gutter pixels wide, row by row from the top
};

std::uint32_t label_count(QuadLabels labels, std::uint32_t colors);
/// Returns the label of an edge as the tile beyond it sees it.
std::uint32_t opposite_label(QuadLabels labels, std::uint32_t colors, std::uint32_t label);

/// Returns the labels of a tile that is turned so that the side `first` comes first.
SideLabels turned_labels(const SideLabels& labels, std::uint32_t first);
/// Returns the side that comes first in the least of the four turns of these labels.
std::uint32_t least_turn(const SideLabels& labels);

/// Makes a complete set. Throws InputError where the exemplar is too small.
QuadTextureSet make_quad_texture(const PngPixels& exemplar, const QuadTextureRequest& request,
                                 const PieceProgress& progress);

}
