#include "host/texture/corner_texture.hpp"

#include "base/random/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace poissonlab {
namespace {

/// The radius of the disks around the middles of edges in tiles: those of neighbouring edges stay apart.
constexpr double edge_radius = 0.3;

int edge_half(int size) { return static_cast<int>(std::ceil(edge_radius * size)); }

/// The square of twice the distance of a pixel from the middle of a square.
int doubled_square(int x, int y, int size)
{
    const int dx = 2 * x + 1 - size, dy = 2 * y + 1 - size;
    return dx * dx + dy * dy;
}

bool is_within(int x, int y, int size, double radius) { return doubled_square(x, y, size) < 4 * radius * radius; }

/// The disk around the middle of an edge. The joint of its patches, across it, is covered.
std::vector<PixelRole> edge_roles(const TextureRequest& request, bool is_vertical)
{
    const int half = edge_half(request.size), size = 2 * half;
    std::vector<PixelRole> roles;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const int across = is_vertical ? y : x; // the joint of a vertical edge is horizontal
            const bool is_joint = across == half - 1 || across == half;
            const bool is_core = is_within(x, y, size, request.core_radius() / 2 * request.size);
            roles.push_back(!is_within(x, y, size, edge_radius * request.size) ? PixelRole::kept
                            : is_joint || is_core                              ? PixelRole::taken
                                                                               : PixelRole::free);
        }
    return roles;
}

/// The disk in the middle of a tile, up to the ring. Joints of the patches are covered, but for those that edges cover.
std::vector<PixelRole> interior_roles(const TextureRequest& request)
{
    const int size = request.size, half = size / 2;
    const auto is_covered = [&](int x, int y) { // by the disk around the middle of an edge
        if (request.stages == 1) return false;
        const int nearest_x = x < half ? 0 : size, nearest_y = y < half ? 0 : size;
        const double squared = 4 * edge_radius * edge_radius * size * size;
        const auto square = [](int n) { return static_cast<double>(n) * n; };
        return square(2 * x + 1 - 2 * nearest_x) + square(2 * y + 1 - size) < squared ||
               square(2 * x + 1 - size) + square(2 * y + 1 - 2 * nearest_y) < squared;
    };
    std::vector<PixelRole> roles;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const bool is_joint = x == half - 1 || x == half || y == half - 1 || y == half;
            const bool is_core = is_within(x, y, size, request.core_radius() * size);
            roles.push_back(!is_within(x, y, size, half - request.ring_pixels()) ? PixelRole::kept
                            : is_core || (is_joint && !is_covered(x, y))         ? PixelRole::taken
                                                                                 : PixelRole::free);
        }
    return roles;
}

/// The patches of all colours.
using Patches = std::vector<ExemplarWindow>;

/// Where a pixel lies in the exemplar, by its place relative to the lattice point of a patch.
SourcePixel source_around(const ExemplarWindow& patch, int dx, int dy)
{
    return {static_cast<std::uint16_t>(patch.x + patch.size / 2 + dx),
            static_cast<std::uint16_t>(patch.y + patch.size / 2 + dy)};
}

/// The two patches at an edge around its middle, before a piece covers their joint: north over south, west beside east.
SourceCanvas edge_canvas(const ExemplarWindow& first, const ExemplarWindow& second, bool is_vertical)
{
    const int half = edge_half(first.size), tile_half = first.size / 2;
    SourceCanvas canvas{2 * half, {}};
    for (int y = 0; y < canvas.size; ++y)
        for (int x = 0; x < canvas.size; ++x) {
            const int along = (is_vertical ? y : x) - half, beside = (is_vertical ? x : y) - half;
            const bool is_first = along < 0;
            const int from_corner = is_first ? along + tile_half : along - tile_half;
            canvas.sources.push_back(source_around(is_first ? first : second, is_vertical ? beside : from_corner,
                                                   is_vertical ? from_corner : beside));
        }
    return canvas;
}

/// The quarters of a tile from the patches of its corners.
SourceCanvas quartered_canvas(const Patches& patches, const CornerTile& tile)
{
    const int size = patches[0].size, half = size / 2;
    SourceCanvas canvas{size, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Color color = y < half ? (x < half ? tile.north_west : tile.north_east)
                                         : (x < half ? tile.south_west : tile.south_east);
            canvas.sources.push_back(source_around(patches[color], x < half ? x : x - size, y < half ? y : y - size));
        }
    return canvas;
}

/// The misfit of patches where they meet at the middles of edges, along so many pixels, and how far their mean colours
/// are from the exemplar's.
class PatchScore
{
public:
    PatchScore(const PngPixels& exemplar, int reach) : exemplar_(exemplar), reach_(reach)
    {
        for (int c = 0; c < exemplar.channels; ++c) means_.push_back(mean({0, 0, 0}, c));
    }

    double operator()(const Patches& patches) const
    {
        double score = 0;
        for (const ExemplarWindow& first : patches) {
            for (const ExemplarWindow& second : patches) score += joint(first, second);
            const double pixels = 4.0 * reach_ * static_cast<double>(patches.size());
            for (int c = 0; c < exemplar_.channels; ++c)
                score += pixels * std::pow(mean(first, c) - means_[static_cast<std::size_t>(c)], 2);
        }
        return score;
    }

private:
    /// Over a window, or over everything where its size is 0.
    double mean(const ExemplarWindow& window, int channel) const
    {
        const int width = window.size > 0 ? window.size : exemplar_.width;
        const int height = window.size > 0 ? window.size : exemplar_.height;
        std::int64_t sum = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) sum += exemplar_.values[exemplar_.at(window.x + x, window.y + y, channel)];
        return static_cast<double>(sum) / (static_cast<double>(width) * height);
    }

    /// Squared differences across the joint, of a vertical and a horizontal edge.
    double joint(const ExemplarWindow& first, const ExemplarWindow& second) const
    {
        const int half = first.size / 2;
        std::int64_t sum = 0;
        for (int i = half - reach_; i < half + reach_; ++i)
            for (int c = 0; c < exemplar_.channels; ++c) {
                const auto value = [&](const ExemplarWindow& window, int x, int y) {
                    return static_cast<int>(exemplar_.values[exemplar_.at(window.x + x, window.y + y, c)]);
                };
                const int north_south = value(first, i, first.size - 1) - value(second, i, 0);
                const int west_east = value(first, first.size - 1, i) - value(second, 0, i);
                sum += north_south * north_south + west_east * west_east;
            }
        return static_cast<double>(sum);
    }

    const PngPixels& exemplar_;
    int reach_;
    std::vector<double> means_;
};

bool is_marked_color(const TextureRequest& request, Color color)
{
    return request.classes() == 2 && color >= request.colors.horizontal / 2;
}

/// Where a piece over patches of these colours comes from: the exemplar of most of them, or either.
std::vector<ColumnRange> ranges_for(const PngPixels& exemplar, const TextureRequest& request,
                                    const std::vector<Color>& colors)
{
    if (request.classes() == 1) return {};
    const auto marked = std::ranges::count_if(colors, [&](Color color) { return is_marked_color(request, color); });
    const auto others = std::ssize(colors) - marked;
    std::vector<ColumnRange> ranges;
    if (others >= marked) ranges.push_back(columns_of(exemplar, request.split, false));
    if (marked >= others) ranges.push_back(columns_of(exemplar, request.split, true));
    return ranges;
}

/// The best of several sets of random patches.
Patches chosen_patches(const PngPixels& exemplar, const TextureRequest& request, int distance)
{
    const PatchScore score(exemplar, std::max(1, request.ring_pixels()));
    Patches best;
    double best_score = 0;
    for (int attempt = 0; attempt < request.attempts; ++attempt) {
        RandomWords words(stream_key(request.seed, Purpose::texture_windows, 0, static_cast<std::uint32_t>(attempt)),
                          0);
        UsedWindows used(distance);
        for (Color color = 0; color < request.colors.horizontal; ++color)
            used.add(used.draw(exemplar, columns_of(exemplar, request.split, is_marked_color(request, color)),
                               request.size, words));
        const double its_score = score(used.windows());
        if (attempt > 0 && its_score >= best_score) continue;
        best = used.windows();
        best_score = its_score;
    }
    return best;
}

/// The colours of an edge's ends: the northern and southern, or the western and eastern one.
using EdgeColors = std::pair<Color, Color>;
using EdgePieces = std::map<EdgeColors, FittedPiece>;

/// The edges of a tile: west, east (vertical ones), north, south.
std::array<EdgeColors, 4> edges_of(const CornerTile& t)
{
    return {{{t.north_west, t.south_west},
             {t.north_east, t.south_east},
             {t.north_west, t.north_east},
             {t.south_west, t.south_east}}};
}

/// Puts the taken pixels of a piece around an edge's middle into a tile, whose corner lies at (-dx, -dy) of the piece.
void overlay(SourceCanvas& tile, const FittedPiece& piece, int dx, int dy)
{
    const int size = piece.window.size;
    for (int v = std::max(0, -dy); v < std::min(size, tile.size - dy); ++v)
        for (int u = std::max(0, -dx); u < std::min(size, tile.size - dx); ++u)
            if (piece.cut.taken[static_cast<std::size_t>(v * size + u)])
                tile.at(u + dx, v + dy) = {static_cast<std::uint16_t>(piece.window.x + u),
                                           static_cast<std::uint16_t>(piece.window.y + v)};
}

/// The three stages one after another.
class CornerTexture
{
public:
    CornerTexture(const PngPixels& exemplar, const TextureRequest& request, const std::vector<TextureTile>& tiles,
                  const PieceProgress& progress)
        : exemplar_(exemplar), request_(request), tiles_(tiles), progress_(progress), used_(0)
    {
        for (const TextureTile& tile : tiles) corners_.push_back(corner_tile(tile.index, request.colors.horizontal));
    }

    TextureSources make()
    {
        std::set<EdgeColors> vertical, horizontal;
        for (const CornerTile& tile : corners_) {
            const auto [west, east, north, south] = edges_of(tile);
            vertical.insert({west, east});
            horizontal.insert({north, south});
        }
        const bool has_edges = request_.stages == 3;
        const std::size_t windows =
            request_.colors.horizontal + tiles_.size() + (has_edges ? vertical.size() + horizontal.size() : 0);
        const int distance = window_distance(exemplar_, request_.size, windows, request_.diversity, request_.split);
        used_ = UsedWindows(distance);
        patches_ = chosen_patches(exemplar_, request_, distance);
        for (const ExemplarWindow& patch : patches_) used_.add(patch);
        EdgePieces of_vertical, of_horizontal;
        if (has_edges) {
            of_vertical = fitted_edges(vertical, true);
            of_horizontal = fitted_edges(horizontal, false);
        }
        return finished(of_vertical, of_horizontal);
    }

private:
    EdgePieces fitted_edges(const std::set<EdgeColors>& edges, bool is_vertical)
    {
        std::vector<SourceCanvas> canvases;
        for (const auto& [first, second] : edges) {
            canvases.push_back(edge_canvas(patches_[first], patches_[second], is_vertical));
            canvases.back().ranges = ranges_for(exemplar_, request_, {first, second});
        }
        const auto pieces =
            fitted(canvases, edge_roles(request_, is_vertical), is_vertical ? "vertical edges" : "horizontal edges");
        EdgePieces by_colors;
        std::size_t i = 0;
        for (const EdgeColors& colors : edges) by_colors[colors] = pieces[i++];
        return by_colors;
    }

    TextureSources finished(const EdgePieces& vertical, const EdgePieces& horizontal)
    {
        std::vector<SourceCanvas> canvases;
        const int half = request_.size / 2, reach = edge_half(request_.size);
        for (const CornerTile& tile : corners_) {
            SourceCanvas& canvas = canvases.emplace_back(quartered_canvas(patches_, tile));
            canvas.ranges =
                ranges_for(exemplar_, request_, {tile.north_west, tile.north_east, tile.south_west, tile.south_east});
            if (vertical.empty()) continue;
            const auto [west, east, north, south] = edges_of(tile);
            overlay(canvas, vertical.at(west), -reach, half - reach);
            overlay(canvas, vertical.at(east), request_.size - reach, half - reach);
            overlay(canvas, horizontal.at(north), half - reach, -reach);
            overlay(canvas, horizontal.at(south), half - reach, request_.size - reach);
        }
        auto pieces = fitted(canvases, interior_roles(request_), "interiors");
        TextureSources result{{}, cost_, used_.windows(), {}, {}};
        for (std::size_t i = 0; i < canvases.size(); ++i) {
            put_piece(canvases[i], pieces[i]);
            result.sources.insert(result.sources.end(), canvases[i].sources.begin(), canvases[i].sources.end());
        }
        result.middles = std::move(pieces);
        return result;
    }

    std::vector<FittedPiece> fitted(const std::vector<SourceCanvas>& canvases, const std::vector<PixelRole>& roles,
                                    const std::string& stage)
    {
        auto pieces = fit_pieces(exemplar_, canvases, roles, request_, used_, stage, progress_);
        for (const FittedPiece& piece : pieces) cost_ += piece.cut.cost;
        return pieces;
    }

    const PngPixels& exemplar_;
    const TextureRequest& request_;
    const std::vector<TextureTile>& tiles_;
    const PieceProgress& progress_;
    std::vector<CornerTile> corners_;
    UsedWindows used_;
    Patches patches_;
    std::int64_t cost_ = 0;
};

}

TextureSources make_corner_texture(const PngPixels& exemplar, const TextureRequest& request,
                                   const std::vector<TextureTile>& tiles, const PieceProgress& progress)
{
    return CornerTexture(exemplar, request, tiles, progress).make();
}

}
