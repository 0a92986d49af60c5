#include "host/texture/piece_fitting.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// The distance that windows must have to be cut both: nearer ones give nearly the same cut.
constexpr int candidates_apart = 4;

/// So many pieces have their sums in memory at a time.
constexpr std::size_t pieces_at_once = 16;

/// Pixels that may or may not be taken decide; those that are taken in any case have no picture below.
PieceMask free_mask(const std::vector<PixelRole>& roles, int size)
{
    PieceMask mask{size, size, {}};
    for (const PixelRole role : roles) mask.counts.push_back(role == PixelRole::free);
    return mask;
}

FittedPiece cheapest_piece(const PngPixels& exemplar, const PngPixels& canvas, const std::vector<PixelRole>& roles,
                           const std::vector<ExemplarWindow>& windows, SeamWeight weight)
{
    std::vector<FittedPiece> pieces(windows.size());
    tbb::parallel_for(std::size_t{0}, windows.size(), [&](std::size_t i) {
        pieces[i] = {windows[i], minimum_cut(canvas, window_pixels(exemplar, windows[i]), roles, weight)};
    });
    return *std::ranges::min_element(pieces, {}, [](const FittedPiece& piece) { return piece.cut.cost; });
}

}

PngPixels canvas_pixels(const PngPixels& exemplar, const SourceCanvas& canvas)
{
    PngPixels pixels{canvas.size, canvas.size, exemplar.channels, {}};
    for (const SourcePixel source : canvas.sources) {
        const auto first = exemplar.values.begin() + static_cast<std::ptrdiff_t>(exemplar.at(source.x, source.y, 0));
        pixels.values.insert(pixels.values.end(), first, first + exemplar.channels);
    }
    return pixels;
}

void put_piece(SourceCanvas& canvas, const FittedPiece& piece)
{
    for (int y = 0; y < canvas.size; ++y)
        for (int x = 0; x < canvas.size; ++x)
            if (piece.cut.taken[static_cast<std::size_t>(y * canvas.size + x)])
                canvas.at(x, y) = {static_cast<std::uint16_t>(piece.window.x + x),
                                   static_cast<std::uint16_t>(piece.window.y + y)};
}

std::vector<FittedPiece> fit_pieces(const PngPixels& exemplar, const std::vector<SourceCanvas>& canvases,
                                    const std::vector<PixelRole>& roles, const TextureRequest& request,
                                    UsedWindows& used, const std::string& stage, const PieceProgress& progress)
{
    std::vector<FittedPiece> pieces;
    if (canvases.empty()) return pieces;
    const int size = canvases[0].size;
    const MaskedSquares squares(exemplar, free_mask(roles, size));
    for (std::size_t first = 0; first < canvases.size(); first += pieces_at_once) {
        const std::size_t count = std::min(pieces_at_once, canvases.size() - first);
        std::vector<PngPixels> pixels(count);
        std::vector<SquareSums> sums(count);
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
            pixels[i] = canvas_pixels(exemplar, canvases[first + i]);
            sums[i] = squares.sums(pixels[i]);
        });
        for (std::size_t i = 0; i < count; ++i) {
            const auto windows =
                used.best(sums[i], size, request.candidates, candidates_apart, canvases[first + i].ranges);
            pieces.push_back(cheapest_piece(exemplar, pixels[i], roles, windows, request.weight));
            used.add(pieces.back().window);
            progress(stage, pieces.size(), canvases.size());
        }
    }
    return pieces;
}

}
