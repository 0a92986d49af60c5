#include "host/texture/corner_texture.hpp"

#include "host/texture/corner_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace poissonlab {
namespace {

/// A square with round corners around (0, 0), stretched to these halves of its sides: what repeats with few colours
/// lies outside of pieces, and a disk would leave much of a tile there.
struct RoundedBox
{
    double half_width = 0, half_height = 0;

    bool holds(double x, double y) const
    {
        if (half_width <= 0 || half_height <= 0) return false;
        const double u = x / half_width, v = y / half_height;
        return u * u * u * u + v * v * v * v < 1;
    }
};

bool is_in_disk(double x, double y, double radius) { return x * x + y * y < radius * radius; }

/// Half of the length of the piece around the middle of an edge. Its ends stay out of the rings of the tiles' other
/// edges, and away from the pieces of neighbouring ones.
double edge_reach(const TextureRequest& request)
{
    return request.size / 2.0 - std::max(request.size / 8.0, static_cast<double>(request.ring_pixels()));
}

int edge_half(const TextureRequest& request) { return static_cast<int>(std::ceil(edge_reach(request))); }

/// The piece around the middle of an edge, by lengths along it and across.
RoundedBox edge_box(const TextureRequest& request) { return {edge_reach(request), request.size / 8.0}; }

/// The part that is covered in any case: 0.3 T and 0.06 T with the default core.
RoundedBox edge_core(const TextureRequest& request)
{
    const double core = request.core_radius();
    return {core / default_core * 0.8 * edge_reach(request), core / default_core * 0.06 * request.size};
}

/// The piece around the middle of an edge. The joint of its patches, across it, is covered.
std::vector<PixelRole> edge_roles(const TextureRequest& request, bool is_vertical)
{
    const int half = edge_half(request), size = 2 * half;
    const RoundedBox box = edge_box(request), core = edge_core(request);
    std::vector<PixelRole> roles;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const int row = is_vertical ? y : x; // along the edge: the joint of a vertical edge is horizontal
            const bool is_joint = row == half - 1 || row == half;
            const double along = row + 0.5 - half, across = (is_vertical ? x : y) + 0.5 - half;
            roles.push_back(!box.holds(along, across)               ? PixelRole::kept
                            : is_joint || core.holds(along, across) ? PixelRole::taken
                                                                    : PixelRole::free);
        }
    return roles;
}

/// The middle of a tile, up to the ring: with one stage the disk of the papers. Joints of the patches are covered, but
/// for those that edges cover.
std::vector<PixelRole> interior_roles(const TextureRequest& request)
{
    const int size = request.size, half = size / 2;
    const double reach = half - request.ring_pixels(), core = request.core_radius() * size;
    const bool is_disk = request.stages == 1;
    const auto is_within = [&](double x, double y, double radius) {
        return is_disk ? is_in_disk(x, y, radius) : RoundedBox{radius, radius}.holds(x, y);
    };
    const RoundedBox edge = edge_box(request);
    const auto is_covered = [&](double x, double y) { // by the piece around the middle of an edge
        return !is_disk && (edge.holds(y, half - std::abs(x)) || edge.holds(x, half - std::abs(y)));
    };
    std::vector<PixelRole> roles;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double x = column + 0.5 - half, y = row + 0.5 - half;
            const bool is_joint = std::abs(x) < 1 || std::abs(y) < 1;
            roles.push_back(!is_within(x, y, reach)                                    ? PixelRole::kept
                            : is_within(x, y, core) || (is_joint && !is_covered(x, y)) ? PixelRole::taken
                                                                                       : PixelRole::free);
        }
    return roles;
}

/// Returns the place of a pixel in the exemplar, by its place relative to the lattice point of a patch.
SourcePixel source_around(const ExemplarWindow& patch, int dx, int dy)
{
    return {static_cast<std::uint16_t>(patch.x + patch.size / 2 + dx),
            static_cast<std::uint16_t>(patch.y + patch.size / 2 + dy)};
}

/// The two patches at an edge around its middle, before a piece covers their joint: north over south, west beside east.
SourceCanvas edge_canvas(const TextureRequest& request, const ExemplarWindow& first, const ExemplarWindow& second,
                         bool is_vertical)
{
    const int half = edge_half(request), tile_half = first.size / 2;
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
            canvases.push_back(edge_canvas(request_, patches_[first], patches_[second], is_vertical));
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
        const int half = request_.size / 2, reach = edge_half(request_);
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
        TextureSources result{{}, cost_, used_.windows(), patches_.size()};
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
