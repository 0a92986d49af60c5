#include "host/texture/joint/set_cover.hpp"

#include <utility>

namespace poissonlab {
namespace {

/// An edge for each pair of corners: vertical and horizontal ones have the same numbers.
std::uint32_t edge_of(Color first, Color second, Color colors) { return first * colors + second; }

TileParts corner_parts(const CornerTile& t, Color colors)
{
    return {{t.north_west, t.north_east, t.south_west, t.south_east},
            edge_of(t.north_west, t.south_west, colors),
            edge_of(t.north_east, t.south_east, colors),
            edge_of(t.north_west, t.north_east, colors),
            edge_of(t.south_west, t.south_east, colors)};
}

}

SetParts set_parts(const TextureRequest& request, const std::vector<TextureTile>& tiles)
{
    SetParts parts;
    if (!request.has_corners()) {
        parts.corners = 1;
        parts.vertical.resize(request.colors.vertical);
        parts.horizontal.resize(request.colors.horizontal);
        for (const TextureTile& tile : tiles) {
            const WangTile t = wang_tile(tile.index, request.colors);
            parts.tiles.push_back({{}, t.west, t.east, t.north, t.south});
        }
        return parts;
    }
    const Color colors = request.colors.horizontal;
    parts.corners = colors;
    for (Color first = 0; first < colors; ++first)
        for (Color second = 0; second < colors; ++second) parts.vertical.push_back({first, second});
    parts.horizontal = parts.vertical;
    for (const TextureTile& tile : tiles) parts.tiles.push_back(corner_parts(corner_tile(tile.index, colors), colors));
    return parts;
}

SetCover::SetCover(SetParts parts, int size, int ring) : parts_(std::move(parts)), size_(size), ring_(ring)
{
    const auto width = static_cast<std::size_t>(2 * ring), length = static_cast<std::size_t>(size - 2 * ring);
    first_vertical_ = parts_.corners * width * width;
    first_horizontal_ = first_vertical_ + parts_.vertical.size() * width * length;
    first_own_ = first_horizontal_ + parts_.horizontal.size() * width * length;
    pixels_ = first_own_ + parts_.tiles.size() * length * length;
}

std::size_t SetCover::corner_pixel(std::size_t corner, int x, int y) const
{
    const auto width = static_cast<std::size_t>(2 * ring_);
    return (corner * width + static_cast<std::size_t>(y)) * width + static_cast<std::size_t>(x);
}

std::size_t SetCover::pixel(std::size_t tile, int x, int y) const
{
    const TileParts& parts = parts_.tiles[tile];
    const auto width = static_cast<std::size_t>(2 * ring_), length = static_cast<std::size_t>(size_ - 2 * ring_);
    const bool is_west = x < ring_, is_east = x >= size_ - ring_, is_north = y < ring_, is_south = y >= size_ - ring_;
    const int across_x = is_west ? x + ring_ : x - size_ + ring_, across_y = is_north ? y + ring_ : y - size_ + ring_;
    if ((is_west || is_east) && (is_north || is_south))
        return corner_pixel(parts.corners[(is_south ? 2u : 0u) + (is_east ? 1u : 0u)], across_x, across_y);
    const auto along_x = static_cast<std::size_t>(x - ring_), along_y = static_cast<std::size_t>(y - ring_);
    if (is_west || is_east)
        return first_vertical_ + ((is_west ? parts.west : parts.east) * length + along_y) * width +
               static_cast<std::size_t>(across_x);
    if (is_north || is_south)
        return first_horizontal_ +
               ((is_north ? parts.north : parts.south) * width + static_cast<std::size_t>(across_y)) * length + along_x;
    return first_own_ + (tile * length + along_y) * length + along_x;
}

std::vector<Site> sites_of(const SetCover& cover)
{
    const SetParts& parts = cover.parts();
    const int size = cover.size(), half = size / 2;
    std::vector<Site> sites;
    const auto add = [&](Site::Kind kind, std::size_t count) {
        const std::size_t first = sites.size();
        for (std::size_t i = 0; i < count; ++i) sites.push_back({kind, static_cast<std::uint32_t>(i), {}});
        return first;
    };
    const std::size_t corners = add(Site::Kind::corner, parts.corners),
                      vertical = add(Site::Kind::vertical_edge, parts.vertical.size()),
                      horizontal = add(Site::Kind::horizontal_edge, parts.horizontal.size()),
                      tiles = add(Site::Kind::tile, parts.tiles.size());
    for (std::size_t i = 0; i < parts.tiles.size(); ++i) {
        const TileParts& t = parts.tiles[i];
        for (std::size_t k = 0; k < 4; ++k)
            sites[corners + t.corners[k]].tiles.push_back({i, k % 2 == 0 ? 0 : -size, k / 2 == 0 ? 0 : -size});
        sites[vertical + t.west].tiles.push_back({i, 0, -half});
        sites[vertical + t.east].tiles.push_back({i, -size, -half});
        sites[horizontal + t.north].tiles.push_back({i, -half, 0});
        sites[horizontal + t.south].tiles.push_back({i, -half, -size});
        sites[tiles + i].tiles.push_back({i, -half, -half});
    }
    return sites;
}

}
