// Pieces of texture: a new window of the exemplar, cut into what is there.
//
// Kwatra and others, Graphcut textures, 2003, section 4; Ng and others 2005, section 3.2.
#pragma once

#include "host/texture/texture_request.hpp"
#include "host/texture/window_choice.hpp"

#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// A square of pixels by their sources, row by row.
struct SourceCanvas
{
    int size = 0;
    std::vector<SourcePixel> sources;
    std::vector<ColumnRange> ranges{}; ///< of the exemplar, that new pieces may come from; none: all

    SourcePixel& at(int x, int y) { return sources[static_cast<std::size_t>(y * size + x)]; }
    const SourcePixel& at(int x, int y) const { return sources[static_cast<std::size_t>(y * size + x)]; }
};

/// The colours of a canvas.
PngPixels canvas_pixels(const PngPixels& exemplar, const SourceCanvas& canvas);

/// The outcome of cutting a window into a canvas.
struct FittedPiece
{
    ExemplarWindow window;
    SeamCut cut;
};

/// Puts the taken pixels of a piece into a canvas of its size.
void put_piece(SourceCanvas& canvas, const FittedPiece& piece);

/// Is told, and may throw, after each of `total` pieces of a stage.
using PieceProgress = std::function<void(const std::string& stage, std::size_t done, std::size_t total)>;

/// The sums of the cut's costs between a canvas and each window of the exemplar, as `search` says, which is not `area`:
/// those of neighbours at the border of what is kept in any case, or those near the middles of sides.
SquareSums cost_sums(const PngPixels& exemplar, const PngPixels& canvas, const std::vector<PixelRole>& roles,
                     PieceSearch search, SeamWeight weight);

/// The minimum-cost piece for each canvas, one after another: of all free windows those with the smallest masked sums
/// of squares, or costs of request.search, are cut, and the cheapest is taken. Roles are the same for all canvases.
/// Used windows grow by those chosen. If `keeps_steps`, one that is a little dearer is taken where otherwise all
/// canvases together would have smaller or larger steps between neighbours than the exemplar.
std::vector<FittedPiece> fit_pieces(const PngPixels& exemplar, const std::vector<SourceCanvas>& canvases,
                                    const std::vector<PixelRole>& roles, const TextureRequest& request,
                                    UsedWindows& used, const std::string& stage, const PieceProgress& progress,
                                    bool keeps_steps = false);

}
