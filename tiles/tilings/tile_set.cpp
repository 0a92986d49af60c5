#include "tiles/tilings/tile_set.hpp"

#include "base/errors/errors.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace poissonlab {
namespace {

void check_colors(TileKind kind, Color colors)
{
    const Color most = most_colors_of(kind);
    if (colors < 2 || colors > most)
        throw InputError("colors = " + std::to_string(colors) + ": must be an integer from 2 to " +
                         std::to_string(most));
}

std::uint64_t complete_size(TileKind kind, WangColors colors)
{
    const std::uint64_t pairs = std::uint64_t{colors.horizontal} * colors.vertical;
    switch (kind) {
    case TileKind::domino:
        return pairs;
    case TileKind::wang:
    case TileKind::corner:
        return pairs * pairs;
    case TileKind::cube:
        return pairs * pairs * pairs * pairs;
    case TileKind::wang_cube:
        return pairs * pairs * pairs;
    }
    return 0;
}

}

TileSet::TileSet(TileKind kind, WangColors colors) : kind_(kind), colors_(colors)
{
    check_colors(kind, colors.horizontal);
    check_colors(kind, colors.vertical);
    if (kind != TileKind::wang && colors.horizontal != colors.vertical)
        throw std::logic_error("only Wang tiles have horizontal and vertical colours");
    size_ = complete_size(kind, colors);
}

TileSet::TileSet(TileKind kind, WangColors colors, std::vector<TileIndex> indices) : TileSet(kind, colors)
{
    std::ranges::sort(indices);
    const auto repeated = std::ranges::adjacent_find(indices);
    if (indices.empty() || indices.back() >= size_ || repeated != indices.end())
        throw std::logic_error("a tile set needs different tiles of its kind and colours");
    if (indices.size() == size_) return;
    size_ = indices.size();
    indices_ = std::move(indices);
}

TileSet TileSet::complete(TileKind kind, WangColors colors) { return TileSet(kind, colors); }

std::optional<std::uint64_t> TileSet::position(TileIndex index) const
{
    if (is_complete()) return index < size_ ? std::optional<std::uint64_t>(index) : std::nullopt;
    const auto found = std::ranges::lower_bound(indices_, index);
    if (found == indices_.end() || *found != index) return std::nullopt;
    return static_cast<std::uint64_t>(found - indices_.begin());
}

TileSet compact_wang_set(WangColors colors)
{
    check_colors(TileKind::wang, colors.horizontal);
    check_colors(TileKind::wang, colors.vertical);
    std::vector<TileIndex> indices;
    for (Color north = 0; north < colors.horizontal; ++north) {
        for (Color west = 0; west < colors.vertical; ++west) {
            for (Color k = 0; k < 2; ++k) {
                // For one number of colours, this pair is (W, N); for two, each pair of (S, E) comes once as well.
                const Color pair = west * colors.horizontal + north;
                const Color south = pair / colors.vertical, east = pair % colors.vertical;
                const WangTile tile{north, (east + k) % colors.vertical, (south + k) % colors.horizontal, west};
                indices.push_back(wang_index(tile, colors));
            }
        }
    }
    return {TileKind::wang, colors, std::move(indices)};
}

TileSet one_hash_wang_set(Color colors)
{
    check_colors(TileKind::wang, colors);
    std::vector<TileIndex> indices;
    for (Color north = 0; north < colors; ++north) {
        for (Color east = 0; east < colors; ++east) {
            for (Color west = 0; west < colors; ++west) {
                const WangTile tile{north, east, (east + west + colors - north) % colors, west};
                indices.push_back(wang_index(tile, {colors, colors}));
            }
        }
    }
    return {TileKind::wang, {colors, colors}, std::move(indices)};
}

TileSet compact_corner_set(Color colors)
{
    check_colors(TileKind::corner, colors);
    std::vector<TileIndex> indices;
    for (Color north_east = 0; north_east < colors; ++north_east) {
        for (Color south_west = 0; south_west < colors; ++south_west) {
            for (Color north_west = 0; north_west < colors; ++north_west) {
                for (Color k = 0; k < 2; ++k) {
                    const Color south_east = (north_east + south_west + north_west + k) % colors;
                    indices.push_back(corner_index({north_east, south_east, south_west, north_west}, colors));
                }
            }
        }
    }
    return {TileKind::corner, {colors, colors}, std::move(indices)};
}

WangTile equivalent_wang_tile(const CornerTile& tile, Color colors)
{
    return {tile.north_west * colors + tile.north_east, tile.south_east * colors + tile.north_east,
            tile.south_west * colors + tile.south_east, tile.south_west * colors + tile.north_west};
}

TileSet equivalent_wang_set(const TileSet& corner_tiles)
{
    if (corner_tiles.kind() != TileKind::corner) throw std::logic_error("not a set of corner tiles");
    const Color colors = corner_tiles.colors().horizontal;
    const WangColors pairs{colors * colors, colors * colors};
    check_colors(TileKind::wang, pairs.horizontal);
    std::vector<TileIndex> indices;
    indices.reserve(corner_tiles.size());
    for (std::uint64_t position = 0; position < corner_tiles.size(); ++position) {
        const CornerTile tile = corner_tile(corner_tiles.index(position), colors);
        indices.push_back(wang_index(equivalent_wang_tile(tile, colors), pairs));
    }
    return {TileKind::wang, pairs, std::move(indices)};
}

}
