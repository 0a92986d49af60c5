#include "tiles/aperiodic/corner_constructions.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace poissonlab {
namespace {

/// Calls `add(north_west, north_east, south_west, south_east)` with the places of tiles that fit in a square.
template <class Add>
void for_each_square(const WangList& wang, const Add& add)
{
    const TilesByColor find(wang);
    for (ListPlace north_west = 0; north_west < wang.tiles.size(); ++north_west) {
        stop_if_interrupted();
        const WangTile& first = wang.tiles[north_west];
        for (const ListPlace north_east : find.with_west(first.east))
            for (const ListPlace south_west : find.with_north(first.south)) {
                const Color north = wang.tiles[north_east].south;
                const Color west = wang.tiles[south_west].east;
                for (const ListPlace south_east : find.with_north_and_west(north, west))
                    add(north_west, north_east, south_west, south_east);
            }
    }
}

/// Calls `add(west, east)` with tiles that fit side by side.
template <class Add>
void for_each_row_of_two(const WangList& wang, const Add& add)
{
    const TilesByColor find(wang);
    for (const WangTile& west : wang.tiles)
        for (const ListPlace east : find.with_west(west.east)) add(west, wang.tiles[east]);
}

/// Sorts tiles and leaves one of each.
void remove_repetitions(std::vector<CornerTile>& tiles)
{
    std::ranges::sort(tiles, {}, [](const CornerTile& t) {
        return std::tuple(t.north_west, t.south_west, t.north_east, t.south_east);
    });
    const auto rest = std::ranges::unique(tiles);
    tiles.erase(rest.begin(), rest.end());
}

ConstructedCorners diagonal(const WangList& wang)
{
    ConstructedCorners made{{{}, static_cast<Color>(wang.tiles.size())}};
    for_each_square(wang, [&](ListPlace nw, ListPlace ne, ListPlace sw, ListPlace se) {
        made.list.tiles.push_back({ne, se, sw, nw});
    });
    remove_repetitions(made.list.tiles); // there are none: this orders them
    made.patterns = made.list.tiles.size();
    return made;
}

ConstructedCorners horizontal(const WangList& wang)
{
    ConstructedCorners made;
    std::vector<CornerTile> tiles;
    for_each_row_of_two(wang, [&](const WangTile& west, const WangTile& east) {
        tiles.push_back({east.north, east.south, west.south, west.north});
    });
    made.patterns = tiles.size();
    remove_repetitions(tiles);
    made.list = renumbered(std::move(tiles));
    return made;
}

/// Tiles one above the other are tiles side by side of the transposed set.
ConstructedCorners vertical(const WangList& wang)
{
    ConstructedCorners made = horizontal(transposed(wang));
    for (CornerTile& tile : made.list.tiles) std::swap(tile.north_east, tile.south_west);
    remove_repetitions(made.list.tiles);
    return made;
}

/// A turned lattice: the colours of horizontal edges come before those of vertical ones. White tiles have a horizontal
/// one at the north-east and black ones a vertical one, and so on around: that alone makes the checkerboard which D.
/// lays over the tiles.
ConstructedCorners rotation(const WangList& wang)
{
    const Color first_vertical = wang.colors.horizontal;
    std::vector<CornerTile> white, black;
    for (const WangTile& t : wang.tiles)
        white.push_back({t.north, first_vertical + t.east, t.south, first_vertical + t.west});
    for_each_square(wang, [&](ListPlace nw, ListPlace ne, ListPlace sw, ListPlace) {
        const auto& tiles = wang.tiles;
        black.push_back(
            {first_vertical + tiles[nw].east, tiles[ne].south, first_vertical + tiles[sw].east, tiles[nw].south});
    });
    ConstructedCorners made;
    remove_repetitions(white);
    remove_repetitions(black);
    made.white = white.size();
    made.black = black.size();
    made.patterns = made.white + made.black;
    white.insert(white.end(), black.begin(), black.end());
    made.list = renumbered(std::move(white));
    return made;
}

/// Colours: horizontal edges, vertical edges, tiles, and the star of D. figure 8.13. Corners in the middle of a tile
/// tell which tile it is, so that colours of horizontal and vertical edges may be the same.
ConstructedCorners subdivision(const WangList& wang)
{
    const Color first_tile = color_count(wang);
    const Color star = first_tile + static_cast<Color>(wang.tiles.size());
    ConstructedCorners made;
    for (ListPlace i = 0; i < wang.tiles.size(); ++i) {
        const WangTile& t = wang.tiles[i];
        const Color middle = first_tile + i;
        made.list.tiles.push_back({star, t.east, middle, t.north});
        made.list.tiles.push_back({t.east, star, t.south, middle});
        made.list.tiles.push_back({t.north, middle, t.west, star});
        made.list.tiles.push_back({middle, t.south, star, t.west});
    }
    made.list.colors = star + 1;
    made.patterns = made.list.tiles.size();
    return made;
}

}

ConstructedCorners construct_corners(const WangList& wang, CornerConstruction construction)
{
    switch (construction) {
    case CornerConstruction::diagonal:
        return diagonal(wang);
    case CornerConstruction::horizontal:
        return horizontal(wang);
    case CornerConstruction::vertical:
        return vertical(wang);
    case CornerConstruction::rotation:
        return rotation(wang);
    case CornerConstruction::subdivision:
        return subdivision(wang);
    }
    return {};
}

std::vector<ConstructionStep> repeat_construction(const WangList& wang, CornerConstruction construction,
                                                  std::size_t repetitions)
{
    std::vector<ConstructionStep> steps;
    while (steps.size() < repetitions && (steps.empty() || !steps.back().corners.is_ambiguous())) {
        const WangList& before = steps.empty() ? wang : steps.back().wang;
        if (before.tiles.size() > max_repeated_tiles)
            throw InputError(fmt::format("repetition {}: {} tiles are too many to go on from (at most {})",
                                         steps.size() + 1, before.tiles.size(), max_repeated_tiles));
        ConstructedCorners corners = construct_corners(before, construction);
        WangList next = wang_list_of(corners.list);
        steps.push_back({std::move(corners), std::move(next)});
    }
    return steps;
}

}
