// Packings as text: what `poissonlab packing` prints.
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "tiles/packing/tile_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace poissonlab {
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
