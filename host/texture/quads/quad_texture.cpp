#include "host/texture/quads/quad_texture.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The best of so many random sets of windows is taken.
constexpr std::uint32_t attempts = 32;

/// Pieces of two edges overlap in a band, and a new piece covers a rounded square, whose half widths these are in
/// sides.
constexpr double overlap = 0.2, core = 0.28;

/// Pixels across an edge, T x T: the edge runs between the middle rows, from the left, and the tile lies above it.
struct EdgePiece
{
    int size = 0;
    std::vector<TurnedSource> sources;

    const TurnedSource& at(int x, int y) const { return sources[static_cast<std::size_t>(y * size + x)]; }

    /// Returns the piece as the tile beyond the edge sees it.
    EdgePiece turned() const
    {
        EdgePiece other = *this;
        std::ranges::reverse(other.sources);
        for (TurnedSource& source : other.sources) source.turns = static_cast<std::uint8_t>((source.turns + 2) % 4);
        return other;
    }
};

EdgePiece piece_of(const ExemplarWindow& window)
{
    EdgePiece piece{window.size, {}};
    for (int y = 0; y < window.size; ++y)
        for (int x = 0; x < window.size; ++x)
            piece.sources.push_back(
                {{static_cast<std::uint16_t>(window.x + x), static_cast<std::uint16_t>(window.y + y)}, 0});
    return piece;
}

void append_pixel(PngPixels& pixels, const PngPixels& exemplar, SourcePixel source)
{
    const auto first = exemplar.values.begin() + static_cast<std::ptrdiff_t>(exemplar.at(source.x, source.y, 0));
    pixels.values.insert(pixels.values.end(), first, first + exemplar.channels);
}

/// Draws a picture of width x height pixels of sources.
template <class Source>
PngPixels picture_of(const PngPixels& exemplar, int width, int height, const Source& source)
{
    PngPixels pixels{width, height, exemplar.channels, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) append_pixel(pixels, exemplar, source(x, y).pixel);
    return pixels;
}

/// Makes pieces of all labels from windows of the exemplar, and tiles of these pieces.
class QuadTexture
{
public:
    QuadTexture(const PngPixels& exemplar, const QuadTextureRequest& request, const PieceProgress& progress)
        : exemplar_(exemplar), request_(request), progress_(progress), size_(request.pieces.size),
          labels_(label_count(request.labels, request.colors))
    {
        for (std::uint32_t code = 0; code < labels_ * labels_ * labels_ * labels_; ++code) {
            const SideLabels sides{code / labels_ / labels_ / labels_, code / labels_ / labels_ % labels_,
                                   code / labels_ % labels_, code % labels_};
            bool is_there = least_turn(sides) == 0;
            for (std::size_t k = 0; k < 4; ++k) is_there = is_there && can_follow(sides[k], sides[(k + 1) % 4]);
            if (is_there) set_.labels.push_back(sides);
        }
        const std::size_t windows = request.colors + set_.labels.size();
        distance_ = window_distance(exemplar, size_, windows, request.pieces.diversity);
        set_.size = size_;
        set_.gutter = request.pieces.ring_pixels();
    }

    QuadTextureSet make()
    {
        std::vector<std::int64_t> costs(attempts);
        tbb::parallel_for(std::uint32_t{0}, attempts,
                          [&](std::uint32_t i) { costs[i] = joined(pieces_of(windows_of(i))).cost; });
        const auto best = static_cast<std::uint32_t>(std::ranges::min_element(costs) - costs.begin());
        UsedWindows used(distance_);
        for (const ExemplarWindow& window : windows_of(best)) used.add(window);
        const Pieces pieces = pieces_of(windows_of(best));
        const Joined cuts = joined(pieces);
        std::vector<SourceCanvas> canvases;
        for (const SideLabels& sides : set_.labels) {
            set_.tiles.push_back(quilted(pieces, cuts, sides));
            canvases.push_back(inside_of(set_.tiles.back()));
        }
        const auto middles =
            fit_pieces(exemplar_, canvases, middle_roles(), request_.pieces, used, "middles", progress_);
        for (std::size_t i = 0; i < middles.size(); ++i) put(middles[i], set_.tiles[i]);
        return std::move(set_);
    }

private:
    struct Pieces
    {
        std::vector<EdgePiece> of_labels;
        std::int64_t cost = 0;
    };
    /// Cuts between a label and the next one around a tile: 1 where the next one is shown, by depths.
    struct Joined
    {
        std::vector<SeamCut> cuts;
        std::int64_t cost = 0;
    };

    bool can_follow(std::uint32_t label, std::uint32_t next) const
    {
        return request_.labels == QuadLabels::wang || label % request_.colors == next / request_.colors;
    }

    std::vector<ExemplarWindow> windows_of(std::uint32_t attempt) const
    {
        RandomWords words(stream_key(request_.pieces.seed, Purpose::texture_windows, 0, attempt), 0);
        UsedWindows used(distance_);
        for (std::uint32_t i = 0; i < request_.colors; ++i) used.add(used.draw(exemplar_, size_, words));
        return used.windows();
    }

    Pieces pieces_of(const std::vector<ExemplarWindow>& windows) const
    {
        Pieces pieces;
        if (request_.labels == QuadLabels::wang) {
            for (const ExemplarWindow& window : windows) {
                pieces.of_labels.push_back(piece_of(window));
                pieces.of_labels.push_back(pieces.of_labels.back().turned());
            }
            return pieces;
        }
        pieces.of_labels.resize(labels_);
        for (std::uint32_t a = 0; a < request_.colors; ++a)
            for (std::uint32_t b = a; b < request_.colors; ++b) {
                pieces.of_labels[a * request_.colors + b] = piece_between(windows[a], windows[b], a == b, pieces.cost);
                pieces.of_labels[b * request_.colors + a] = pieces.of_labels[a * request_.colors + b].turned();
            }
        return pieces;
    }

    /// Makes the piece of an edge that begins at each end as the window of that end does. Where both windows are the
    /// same, the piece is the same after half a turn.
    EdgePiece piece_between(const ExemplarWindow& a, const ExemplarWindow& b, bool is_same, std::int64_t& cost) const
    {
        const EdgePiece first = piece_of(a), second = piece_of(b).turned();
        const int band = std::max(2, size_ / 4), half = size_ / 2, rows = is_same ? half : size_;
        std::vector<PixelRole> roles;
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < size_; ++x) {
                const int reach = is_same && y == half - 1 ? 0 : band;
                roles.push_back(x < half - reach    ? PixelRole::kept
                                : x >= half + reach ? PixelRole::taken
                                                    : PixelRole::free);
            }
        const auto pixels = [&](const EdgePiece& piece) {
            return picture_of(exemplar_, size_, rows, [&](int x, int y) { return piece.at(x, y); });
        };
        const SeamCut cut = minimum_cut(pixels(first), pixels(second), roles, request_.pieces.weight);
        cost += cut.cost;
        EdgePiece joined = first;
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x) {
                const bool is_taken = y < rows ? cut.taken[static_cast<std::size_t>(y * size_ + x)] != 0
                                               : !cut.taken[static_cast<std::size_t>((size_ - y) * size_ - 1 - x)];
                if (is_taken) joined.sources[static_cast<std::size_t>(y * size_ + x)] = second.at(x, y);
            }
        return joined;
    }

    /// Returns the pixel of a label that lies so far along its side, and so deep in the tile.
    TurnedSource pixel_of(const Pieces& pieces, std::uint32_t label, int along, int depth) const
    {
        return pieces.of_labels[label].at(along, size_ / 2 - 1 - depth);
    }

    Joined joined(const Pieces& pieces) const
    {
        const int half = size_ / 2, band = std::max(2, static_cast<int>(overlap * size_));
        std::vector<PixelRole> roles;
        for (int a = 0; a < half; ++a) // a is the depth at the first side, b that at the next one
            for (int b = 0; b < half; ++b) {
                const int reach = std::min(a, b) < set_.gutter ? 0 : band;
                roles.push_back(a < b - reach   ? PixelRole::kept
                                : b < a - reach ? PixelRole::taken
                                : reach == 0    ? PixelRole::kept
                                                : PixelRole::free);
            }
        Joined all{std::vector<SeamCut>(labels_ * labels_), pieces.cost};
        for (std::uint32_t label = 0; label < labels_; ++label)
            for (std::uint32_t next = 0; next < labels_; ++next) {
                if (!can_follow(label, next)) continue;
                const PngPixels kept = picture_of(
                    exemplar_, half, half, [&](int b, int a) { return pixel_of(pieces, label, size_ - 1 - b, a); });
                const PngPixels taken =
                    picture_of(exemplar_, half, half, [&](int b, int a) { return pixel_of(pieces, next, a, b); });
                SeamCut& cut = all.cuts[label * labels_ + next];
                cut = minimum_cut(kept, taken, roles, request_.pieces.weight);
                all.cost += cut.cost;
            }
        return all;
    }

    std::vector<TurnedSource> quilted(const Pieces& pieces, const Joined& cuts, const SideLabels& sides) const
    {
        const int gutter = set_.gutter, half = size_ / 2;
        std::vector<TurnedSource> tile;
        for (int y = -gutter; y < size_ + gutter; ++y)
            for (int x = -gutter; x < size_ + gutter; ++x) {
                const std::array<int, 4> depth{size_ - 1 - y, size_ - 1 - x, y, x};
                std::uint32_t side = static_cast<std::uint32_t>(std::ranges::min_element(depth) - depth.begin());
                if (depth[side] >= 0) { // the quarter between one side and the next one
                    side = x >= half ? (y >= half ? 0 : 1) : (y < half ? 2 : 3);
                    const std::uint32_t next = (side + 1) % 4;
                    const SeamCut& cut = cuts.cuts[sides[side] * labels_ + sides[next]];
                    if (cut.taken[static_cast<std::size_t>(depth[side] * half + depth[next])]) side = next;
                }
                const int along = std::clamp(depth[(side + 3) % 4], 0, size_ - 1);
                TurnedSource source = pixel_of(pieces, sides[side], along, depth[side]);
                source.turns = static_cast<std::uint8_t>((source.turns + side) % 4);
                tile.push_back(source);
            }
        return tile;
    }

    std::size_t inner(int x, int y) const
    {
        return static_cast<std::size_t>((y + set_.gutter) * (size_ + 2 * set_.gutter) + x + set_.gutter);
    }

    SourceCanvas inside_of(const std::vector<TurnedSource>& tile) const
    {
        SourceCanvas canvas{size_, {}};
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x) canvas.sources.push_back(tile[inner(x, y)].pixel);
        return canvas;
    }

    std::vector<PixelRole> middle_roles() const
    {
        std::vector<PixelRole> roles;
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x) {
                const double u = std::abs((x + 0.5) / size_ - 0.5), v = std::abs((y + 0.5) / size_ - 0.5);
                const int border = std::min({x, y, size_ - 1 - x, size_ - 1 - y});
                roles.push_back(border < set_.gutter                                        ? PixelRole::kept
                                : u * u * u * u + v * v * v * v < core * core * core * core ? PixelRole::taken
                                                                                            : PixelRole::free);
            }
        return roles;
    }

    void put(const FittedPiece& piece, std::vector<TurnedSource>& tile) const
    {
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x)
                if (piece.cut.taken[static_cast<std::size_t>(y * size_ + x)])
                    tile[inner(x, y)] = {{static_cast<std::uint16_t>(piece.window.x + x),
                                          static_cast<std::uint16_t>(piece.window.y + y)},
                                         0};
    }

    const PngPixels& exemplar_;
    const QuadTextureRequest& request_;
    const PieceProgress& progress_;
    int size_;
    std::uint32_t labels_;
    int distance_ = 0;
    QuadTextureSet set_;
};

}

std::uint32_t label_count(QuadLabels labels, std::uint32_t colors)
{
    return labels == QuadLabels::wang ? 2 * colors : colors * colors;
}

std::uint32_t opposite_label(QuadLabels labels, std::uint32_t colors, std::uint32_t label)
{
    return labels == QuadLabels::wang ? label ^ 1u : label % colors * colors + label / colors;
}

SideLabels turned_labels(const SideLabels& labels, std::uint32_t first)
{
    SideLabels turned{};
    for (std::size_t k = 0; k < 4; ++k) turned[k] = labels[(k + first) % 4];
    return turned;
}

std::uint32_t least_turn(const SideLabels& labels)
{
    std::uint32_t least = 0;
    for (std::uint32_t first = 1; first < 4; ++first)
        if (turned_labels(labels, first) < turned_labels(labels, least)) least = first;
    return least;
}

QuadTextureSet make_quad_texture(const PngPixels& exemplar, const QuadTextureRequest& request,
                                 const PieceProgress& progress)
{
    if (std::min(exemplar.width, exemplar.height) <= request.pieces.size)
        throw InputError(fmt::format("{} x {} pixels are too few for tiles of {}", exemplar.width, exemplar.height,
                                     request.pieces.size));
    return QuadTexture(exemplar, request, progress).make();
}

}
