// Packings as text: what `poissonlab packing` prints.
#include "tiles/packing/tile_packing.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace poissonlab {
namespace {

/// "the tile 5 at (x, y) = (1, 2)": places as they are counted, from the south-west.
std::string tile_there(const TilePacking& packing, PackingPlace place)
{
    return fmt::format("tile {} at ({}, {})", packing.at(place), place.x, place.y);
}

}

bool fits_east(TileKind kind, WangColors colors, TileIndex west, TileIndex east)
{
    if (kind == TileKind::wang) return wang_tile(west, colors).east == wang_tile(east, colors).west;
    const CornerTile w = corner_tile(west, colors.horizontal), e = corner_tile(east, colors.horizontal);
    return w.north_east == e.north_west && w.south_east == e.south_west;
}

bool fits_north(TileKind kind, WangColors colors, TileIndex south, TileIndex north)
{
    if (kind == TileKind::wang) return wang_tile(south, colors).north == wang_tile(north, colors).south;
    const CornerTile s = corner_tile(south, colors.horizontal), n = corner_tile(north, colors.horizontal);
    return s.north_east == n.south_east && s.north_west == n.south_west;
}

std::optional<std::string> packing_fault(const TilePacking& packing)
{
    const Color side = packing.side();
    std::vector<bool> is_there(packing.tiles.size());
    for (Color y = 0; y < side; ++y)
        for (Color x = 0; x < side; ++x) {
            const PackingPlace here{x, y}, east{(x + 1) % side, y}, north{x, (y + 1) % side};
            if (is_there[packing.at(here)]) return tile_there(packing, here) + " is there twice";
            is_there[packing.at(here)] = true;
            if (!fits_east(packing.kind, packing.colors, packing.at(here), packing.at(east)))
                return tile_there(packing, here) + " does not fit to its eastern neighbour " +
                       tile_there(packing, east);
            if (!fits_north(packing.kind, packing.colors, packing.at(here), packing.at(north)))
                return tile_there(packing, here) + " does not fit to its northern neighbour " +
                       tile_there(packing, north);
        }
    return std::nullopt;
}

std::vector<Color> corner_colors_of(const TilePacking& packing)
{
    std::vector<Color> corners;
    corners.reserve(packing.tiles.size());
    for (const TileIndex tile : packing.tiles) corners.push_back(corner_tile(tile, packing.colors).south_west);
    return corners;
}

TilePacking packing_of_corner_colors(Color colors, const std::vector<Color>& corners)
{
    TilePacking packing{TileKind::corner, colors, {}};
    const Color side = packing.side();
    const auto color = [&](Color x, Color y) { return corners[std::size_t{y % side} * side + x % side]; };
    for (Color y = 0; y < side; ++y)
        for (Color x = 0; x < side; ++x)
            packing.tiles.push_back(
                corner_index({color(x + 1, y + 1), color(x + 1, y), color(x, y), color(x, y + 1)}, colors));
    return packing;
}

namespace {

TileIndex tile_of_word(std::string_view word, TileIndex tiles, const SourceLocation& place)
{
    TileIndex tile = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), tile);
    if (error != std::errc() || stop != word.data() + word.size() || tile >= tiles)
        throw InputError::at(
            place, fmt::format("tile \"{}\": must be an integer from 0 to {}", printable(shortened(word)), tiles - 1));
    return tile;
}

}

TilePacking read_packing(const std::filesystem::path& file, TileKind kind, Color colors)
{
    TilePacking packing{kind, colors, {}};
    const TileIndex tiles = packing.side() * packing.side();
    const std::string text = read_whole_file(file);
    std::vector<std::vector<TileIndex>> rows;
    LineReader lines(text);
    while (lines.next()) {
        if (trimmed(lines.line()).empty()) continue;
        const SourceLocation place{file.string(), lines.number()};
        if (rows.size() == packing.side())
            throw InputError::at(place, fmt::format("a row too many: there must be {}", packing.side()));
        std::vector<TileIndex>& row = rows.emplace_back();
        WordReader words(lines.line());
        while (words.next()) row.push_back(tile_of_word(words.word(), tiles, place));
        if (row.size() != packing.side())
            throw InputError::at(place, fmt::format("a row of {} tiles: must have {}", row.size(), packing.side()));
    }
    if (rows.size() != packing.side())
        throw InputError::at({file.string()}, fmt::format("{} rows: must have {}", rows.size(), packing.side()));
    std::ranges::reverse(rows);
    for (const auto& row : rows) packing.tiles.insert(packing.tiles.end(), row.begin(), row.end());
    return packing;
}

}
