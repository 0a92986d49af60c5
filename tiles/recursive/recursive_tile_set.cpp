#include "tiles/recursive/recursive_tile_set.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <utility>

namespace poissonlab {
namespace {

/// The colours of one side of a tile's cells, from west to east or from south to north.
using SideColors = std::array<Color, 4>;

std::array<SideColors, 4> outer_colors(const RecursiveTile& tile)
{
    std::array<SideColors, 4> sides; // north, east, south, west
    const auto colors = [&](std::uint32_t x, std::uint32_t y) { return wang_colors_of(tile.children[4 * y + x]); };
    for (std::uint32_t i = 0; i < 4; ++i) {
        sides[0][i] = colors(i, 3).north;
        sides[1][i] = colors(3, i).east;
        sides[2][i] = colors(i, 0).south;
        sides[3][i] = colors(0, i).west;
    }
    return sides;
}

bool children_fit_inside(const RecursiveTile& tile)
{
    const auto colors = [&](std::uint32_t x, std::uint32_t y) { return wang_colors_of(tile.children[4 * y + x]); };
    for (std::uint32_t i = 0; i < 4; ++i)
        for (std::uint32_t j = 0; j < 3; ++j)
            if (colors(j, i).east != colors(j + 1, i).west || colors(i, j).north != colors(i, j + 1).south)
                return false;
    return true;
}

/// Equal borders of tiles must be divided equally: each pair of sides with the same colours.
bool borders_fit(const RecursiveTiles& tiles)
{
    std::array<std::array<SideColors, 2>, 2> found{}; // of horizontal and vertical edges, by colour
    std::array<std::array<bool, 2>, 2> is_known{};
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        const WangTile c = wang_colors_of(i);
        const auto sides = outer_colors(tiles[i]);
        const std::array<Color, 4> own{c.north, c.east, c.south, c.west};
        for (std::size_t side = 0; side < 4; ++side) {
            const std::size_t direction = side % 2;
            if (is_known[direction][own[side]] && found[direction][own[side]] != sides[side]) return false;
            is_known[direction][own[side]] = true;
            found[direction][own[side]] = sides[side];
        }
    }
    return true;
}

bool has_every_link(const RecursiveTile& tile, std::uint32_t points_per_tile)
{
    if (tile.links.size() != std::size_t{recursive_cells} * points_per_tile) return false;
    std::vector<bool> seen(tile.links.size());
    for (const RecursiveLink link : tile.links) {
        if (link.point() >= points_per_tile) return false;
        const std::size_t number = std::size_t{link.cell()} * points_per_tile + link.point();
        if (seen[number]) return false;
        seen[number] = true;
    }
    return true;
}

void check_tile_set(std::uint32_t points_per_tile, const RecursiveTiles& tiles)
{
    if (points_per_tile < min_recursive_points || points_per_tile > max_recursive_points)
        throw InputError(fmt::format("{} points per tile: must be from {} to {}", points_per_tile, min_recursive_points,
                                     max_recursive_points));
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        for (const std::uint8_t child : tiles[i].children)
            if (child >= even_wang_tiles)
                throw InputError(fmt::format("tile {} has a smaller tile {}: must be below 8", i, child));
        if (!children_fit_inside(tiles[i]))
            throw InputError(fmt::format("the smaller tiles of tile {} do not fit beside each other", i));
        if (!has_every_link(tiles[i], points_per_tile))
            throw InputError(fmt::format("tile {} does not have each point of its smaller tiles once", i));
    }
    if (!borders_fit(tiles)) throw InputError("borders of one colour are not divided in one way");
}

}

RecursivePlaces places_of_links(const RecursiveTiles& tiles, std::uint32_t points_per_tile)
{
    RecursivePlaces places;
    for (auto& each : places) each.resize(points_per_tile);
    // Every round makes two more bits right, wherever it starts.
    for (int round = 0; round < 16; ++round) {
        const RecursivePlaces before = places;
        for (std::size_t i = 0; i < even_wang_tiles; ++i)
            for (std::uint32_t k = 0; k < points_per_tile; ++k) {
                const RecursiveLink link = tiles[i].links[k];
                places[i][k] = place_in_parent(link.cell(), before[tiles[i].children[link.cell()]][link.point()]);
            }
    }
    return places;
}

RecursiveTileSet::RecursiveTileSet(std::uint32_t points_per_tile, std::uint64_t seed, RecursiveTiles tiles)
    : points_per_tile_(points_per_tile), seed_(seed), tiles_(std::move(tiles))
{
    check_tile_set(points_per_tile_, tiles_);
    places_ = places_of_links(tiles_, points_per_tile_);
}

}
