// Texture tiles by the colours of their edges, by quilting.
//
// Cohen, Shade, Hiller, Deussen, Wang Tiles for Image and Texture Generation, 2003, section 3.2: a sample of the
// exemplar a colour of edges, centred on the edge; each quarter of a tile is cut between the samples of two edges,
// along the diagonal. The article leaves open how wide the overlap is (here an eighth of the tile on both sides of the
// diagonal unless another overlap is asked for), how samples are drawn, and when to stop: the best of some random sets,
// whose samples are then replaced one by one where that is better.
//
// With marked corners (section 3.5) two exemplars are shown, and an edge's sample follows from its marks as well:
// wang_samples.hpp.
//
// The ring: pixels near the border belong to the nearest edge, those on the diagonal to north and south.
#pragma once

#include "host/texture/corner_texture.hpp"

namespace poissonlab {

/// The sum over channels of squared differences between the pixels of two pictures at a place.
std::int64_t squared_difference(const PngPixels& a, const PngPixels& b, int x, int y);

/// A path through a band around the diagonal of a square: in row k, pixels before column k + offset belong to one
/// picture, those from there on to the other. Offsets begin and end with 0 and change by at most 1 a row.
struct DiagonalPath
{
    std::vector<int> offsets;
    std::int64_t error = 0;
};

/// The path with the smallest sum of errors, error(k, offset), with offsets up to `band` (Efros and Freeman 2001); ties
/// to the smaller offset. The first `pinned` rows have the offset 0.
DiagonalPath minimum_error_path(int rows, int band, int pinned,
                                const std::function<std::int64_t(int row, int offset)>& error);

/// The arguments and errors are those of make_corner_texture().
TextureSources make_wang_texture(const PngPixels& exemplar, const TextureRequest& request,
                                 const std::vector<TextureTile>& tiles, const PieceProgress& progress);

}
