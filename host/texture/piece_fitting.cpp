#include "host/texture/piece_fitting.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace poissonlab {
namespace {

/// The distance that windows must have to be cut both: nearer ones give nearly the same cut.
constexpr int candidates_apart = 4;

/// So many pieces have their sums in memory at a time.
constexpr std::size_t pieces_at_once = 16;

/// The sums of a piece, and the arrays that they are computed in, take so many bytes for each pixel of the exemplar:
/// large exemplars get fewer pieces at a time, which changes no piece.
constexpr std::size_t bytes_a_pixel = 32, most_bytes_at_once = std::size_t{1} << 31;

std::size_t fitted_at_once(const PngPixels& exemplar)
{
    const std::size_t pixels = static_cast<std::size_t>(exemplar.width) * static_cast<std::size_t>(exemplar.height);
    return std::clamp<std::size_t>(most_bytes_at_once / (bytes_a_pixel * pixels), 1, pieces_at_once);
}

/// Pixels that may or may not be taken decide; those that are taken in any case have no picture below.
PieceMask free_mask(const std::vector<PixelRole>& roles, int size)
{
    PieceMask mask{size, size, {}};
    for (const PixelRole role : roles) mask.counts.push_back(role == PixelRole::free);
    return mask;
}

/// A pixel and its eastern neighbour, or the one below.
struct PixelPair
{
    int x = 0;
    int y = 0;
    bool is_vertical = false;
};

/// The pairs whose costs say how well a window may fit. Near the middle of a side: within an eighth of the side.
std::vector<PixelPair> searched_pairs(const std::vector<PixelRole>& roles, int size, PieceSearch search)
{
    const auto is_near_middle = [&](int x, int y) {
        const int u = 2 * std::min(x, size - 1 - x), v = 2 * std::min(y, size - 1 - y);
        const int from_u = u + 1 - size, from_v = v + 1 - size; // twice the distances from the axes of symmetry
        return 16 * (u * u + from_v * from_v) <= size * size || 16 * (v * v + from_u * from_u) <= size * size;
    };
    std::vector<PixelPair> pairs;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (const bool is_vertical : {false, true}) {
                const int other = is_vertical ? (y + 1) * size + x : y * size + x + 1;
                if ((is_vertical ? y : x) + 1 == size) continue;
                const bool is_kept = roles[static_cast<std::size_t>(y * size + x)] == PixelRole::kept;
                const bool other_is_kept = roles[static_cast<std::size_t>(other)] == PixelRole::kept;
                if (search == PieceSearch::circle ? is_kept != other_is_kept
                                                  : is_near_middle(x, y) && !(is_kept && other_is_kept))
                    pairs.push_back({x, y, is_vertical});
            }
    return pairs;
}

/// Keeps the mean step between neighbours of all pictures of a stage near the exemplar's. Patches of corners stand out
/// little, and windows that fit best have less contrast than others, so that the set would lose edges. Only the middles
/// of tiles make up for it, as there are most of them: what recurs should not stand out.
class StepBalance
{
public:
    StepBalance(const PngPixels& exemplar, int size, bool counts)
        : natural_(counts ? sum_of_steps(exemplar) / pairs(exemplar.width, exemplar.height) * pairs(size, size) : 0)
    {}

    /// The steps of a picture beyond the natural ones, in parts of these.
    double excess(const PngPixels& picture) const { return natural_ > 0 ? sum_of_steps(picture) / natural_ - 1 : 0; }

    /// The cost of the sum of all excesses with one more, in parts of a cut's.
    double cost(double excess) const { return 12 * std::abs(sum_ + excess); }

    void add(double excess) { sum_ += excess; }

private:
    static double pairs(int width, int height) { return 2.0 * width * height - width - height; }

    static double sum_of_steps(const PngPixels& picture)
    {
        std::int64_t sum = 0;
        const auto add = [&](std::size_t first, std::size_t second) {
            for (std::size_t c = 0; c < static_cast<std::size_t>(picture.channels); ++c)
                sum += std::abs(picture.values[first + c] - picture.values[second + c]);
        };
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                if (x > 0) add(picture.at(x - 1, y, 0), picture.at(x, y, 0));
                if (y > 0) add(picture.at(x, y - 1, 0), picture.at(x, y, 0));
            }
        return static_cast<double>(sum);
    }

    double natural_; ///< the steps of as many pixels of the exemplar; 0: steps do not count
    double sum_ = 0;
};

/// A piece that may be taken.
struct CutWindow
{
    FittedPiece piece;
    double excess = 0; ///< of the steps of what it makes
};

/// Cuts a window into a canvas.
CutWindow cut_window(const PngPixels& exemplar, const PngPixels& canvas, const std::vector<PixelRole>& roles,
                     const ExemplarWindow& window, SeamWeight weight, const StepBalance& balance)
{
    PngPixels made = canvas;
    const PngPixels above = window_pixels(exemplar, window);
    CutWindow candidate{{window, minimum_cut(canvas, above, roles, weight)}, 0};
    const auto channels = static_cast<std::size_t>(canvas.channels);
    for (std::size_t i = 0; i < made.values.size(); ++i)
        if (candidate.piece.cut.taken[i / channels]) made.values[i] = above.values[i];
    candidate.excess = balance.excess(made);
    return candidate;
}

FittedPiece cheapest_piece(const PngPixels& exemplar, const PngPixels& canvas, const std::vector<PixelRole>& roles,
                           const std::vector<ExemplarWindow>& windows, SeamWeight weight, StepBalance& balance)
{
    std::vector<CutWindow> candidates(windows.size());
    tbb::parallel_for(std::size_t{0}, windows.size(), [&](std::size_t i) {
        candidates[i] = cut_window(exemplar, canvas, roles, windows[i], weight, balance);
    });
    double mean = 0;
    for (const CutWindow& candidate : candidates)
        mean += static_cast<double>(candidate.piece.cut.cost) / static_cast<double>(candidates.size());
    const auto cost = [&](const CutWindow& candidate) {
        return static_cast<double>(candidate.piece.cut.cost) + mean * balance.cost(candidate.excess);
    };
    const auto best = std::ranges::min_element(candidates, {}, cost);
    balance.add(best->excess);
    return std::move(best->piece);
}

}

SquareSums cost_sums(const PngPixels& exemplar, const PngPixels& canvas, const std::vector<PixelRole>& roles,
                     PieceSearch search, SeamWeight weight)
{
    const int size = canvas.width;
    SquareSums sums{exemplar.width - size + 1, exemplar.height - size + 1, {}};
    sums.sums.resize(static_cast<std::size_t>(sums.columns) * static_cast<std::size_t>(sums.rows));
    const std::vector<PixelPair> pairs = searched_pairs(roles, size, search);
    tbb::parallel_for(0, sums.rows, [&](int row) {
        for (int column = 0; column < sums.columns; ++column) {
            const PngPixels window = window_pixels(exemplar, {column, row, size});
            std::uint64_t& sum = sums.sums[static_cast<std::size_t>(row * sums.columns + column)];
            for (const PixelPair& pair : pairs)
                sum += static_cast<std::uint64_t>(pair_cost(canvas, window, pair.x, pair.y, pair.is_vertical, weight));
        }
    });
    return sums;
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
                                    UsedWindows& used, const std::string& stage, const PieceProgress& progress,
                                    bool keeps_steps)
{
    std::vector<FittedPiece> pieces;
    if (canvases.empty()) return pieces;
    const int size = canvases[0].size;
    const MaskedSquares squares(exemplar, free_mask(roles, size));
    StepBalance balance(exemplar, size, keeps_steps);
    const std::size_t at_once = fitted_at_once(exemplar);
    for (std::size_t first = 0; first < canvases.size(); first += at_once) {
        const std::size_t count = std::min(at_once, canvases.size() - first);
        std::vector<PngPixels> pixels(count);
        std::vector<SquareSums> sums(count);
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
            pixels[i] = canvas_pixels(exemplar, canvases[first + i]);
            sums[i] = request.search == PieceSearch::area
                          ? squares.sums(pixels[i])
                          : cost_sums(exemplar, pixels[i], roles, request.search, request.weight);
        });
        for (std::size_t i = 0; i < count; ++i) {
            const auto windows =
                used.best(sums[i], size, request.candidates, candidates_apart, canvases[first + i].ranges);
            pieces.push_back(cheapest_piece(exemplar, pixels[i], roles, windows, request.weight, balance));
            used.add(pieces.back().window);
            progress(stage, pieces.size(), canvases.size());
        }
    }
    return pieces;
}

}
