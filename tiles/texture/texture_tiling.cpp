#include "tiles/texture/texture_tiling.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random_words.hpp"
#include "tiles/texture/endless_texture.hpp"
#include "tiles/texture/marked_tiles.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

namespace poissonlab {
namespace {

/// The numbers of the tiles with each index, one of which a place draws.
class TileNumbers
{
public:
    TileNumbers(const TextureSet& set, std::uint64_t seed)
        : indices_(set.index_set()), key_(stream_key(seed, Purpose::texture_variants, 0)), numbers_(indices_.size())
    {
        for (std::size_t tile = 0; tile < set.tiles.size(); ++tile)
            numbers_[*indices_.position(set.tiles[tile].index)].push_back(tile);
    }

    std::size_t draw(TileIndex index, std::int64_t x, std::int64_t y) const
    {
        const std::vector<std::size_t>& numbers = numbers_[*indices_.position(index)];
        if (numbers.size() == 1) return numbers[0];
        const auto low = [](std::int64_t n) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(n)); };
        const auto words = philox({low(x), low(x >> 32), low(y), low(y >> 32)}, key_);
        return numbers[std::uint64_t{words[0]} * numbers.size() >> 32];
    }

private:
    TileSet indices_;
    StreamKey key_;
    std::vector<std::vector<std::size_t>> numbers_;
};

/// True if a tile may lie in a column and row of a window, rows from north to south.
using MayLie = std::function<bool(TileIndex index, std::uint64_t column, std::uint64_t row)>;

/// Lays tiles by scanlines, also of sets that leave no choice somewhere, which ScanlineTiling refuses.
std::vector<TileIndex> laid_indices(const TextureSet& set, const TileWindow& window, std::uint64_t seed,
                                    const MayLie& may_lie = {})
{
    const FittingTiles fitting(set.index_set());
    RandomWords words(stream_key(seed, Purpose::texture_scanlines, 0), 0);
    std::vector<TileIndex> laid, allowed;
    for (std::uint64_t row = 0; row < window.height; ++row)
        for (std::uint64_t column = 0; column < window.width; ++column) {
            const TileIndex* const here = laid.data() + laid.size();
            auto choices = fitting.choices(row == 0 ? nullptr : here - window.width, column == 0 ? nullptr : here - 1);
            if (may_lie) {
                allowed.clear();
                std::ranges::copy_if(choices, std::back_inserter(allowed),
                                     [&](TileIndex index) { return may_lie(index, column, row); });
                choices = allowed;
            }
            if (choices.empty()) throw InputError(fmt::format("no tile fits at column {}, row {}", column, row));
            laid.push_back(choices[words.below(static_cast<std::uint32_t>(choices.size()))]);
        }
    return laid;
}

/// The tiles that programs with runtime/texture_tiles.h and `texture map` show there: one hash for all of them, of
/// places and seeds modulo 2^32.
std::vector<TileIndex> hashed_indices(bool has_corners, WangColors colors, const TileWindow& window, std::uint64_t seed)
{
    const TileKind kind = has_corners ? TileKind::corner : TileKind::wang;
    const auto low = [](std::uint64_t n) { return static_cast<std::uint32_t>(n); };
    std::vector<TileIndex> tiles;
    tiles.reserve(window.width * window.height);
    for (std::uint64_t row = window.height; row-- > 0;)
        for (std::uint64_t column = 0; column < window.width; ++column)
            tiles.push_back(endless_index(kind, low(seed), colors, low(static_cast<std::uint64_t>(window.x) + column),
                                          low(static_cast<std::uint64_t>(window.y) + row)));
    return tiles;
}

/// The pixels of a row of tiles.
void copy_row_of_tiles(const TextureSet& set, const TextureWindow& window, std::size_t row_of_tiles,
                       std::span<const std::uint8_t> values, std::size_t channels, std::uint8_t* pixels)
{
    const auto size = static_cast<std::size_t>(set.size);
    const std::size_t row_bytes = size * channels;
    for (std::size_t column = 0; column < window.columns; ++column) {
        const std::size_t tile = window.tiles[row_of_tiles * window.columns + column];
        for (std::size_t row = 0; row < size; ++row)
            std::ranges::copy(values.subspan((tile * size + row) * row_bytes, row_bytes),
                              pixels + (row * window.columns + column) * row_bytes);
    }
}

void check_window(const TileWindow& window)
{
    if (window.width > most_window_tiles || window.height > most_window_tiles / window.width)
        throw InputError(fmt::format("a window of {} x {} tiles: must have at most {}", window.width, window.height,
                                     most_window_tiles));
}

void check_scanlines(const TileWindow& window)
{
    if (window.x != 0 || window.y != 0)
        throw InputError(fmt::format("a window at {} {}: must be at 0 0, since these tiles are laid in scanlines",
                                     window.x, window.y));
}

/// Throws InputError where a map of marks leaves no choice of tiles, so that they repeat: it gives the fourth mark of a
/// place as well, which otherwise is at random.
void check_choices(const TextureSet& set)
{
    std::map<std::array<Color, 6>, int> tiles; // by what is given at a place
    for (const TextureTile& tile : set.tiles) {
        const WangTile t = wang_tile(tile.index, set.colors);
        const CornerTile m = marks_of(set, tile.index);
        ++tiles[{unmarked_edge(t.north), unmarked_edge(t.west), m.north_east, m.south_east, m.south_west,
                 m.north_west}];
    }
    const WangColors colors = unmarked_colors(set.colors);
    const bool is_all = tiles.size() == std::size_t{16} * colors.horizontal * colors.vertical;
    if (!is_all || std::ranges::any_of(tiles, [](const auto& one) { return one.second < 2; }))
        throw InputError("a map of marks leaves no choice of these tiles, which are for marks at random");
}

/// The tiles whose corners have the marks of the lattice points around them.
MayLie tiles_by_marks(const TextureSet& set, const TileWindow& window, const CornerMarks& is_marked)
{
    return [&set, &window, &is_marked](TileIndex index, std::uint64_t column, std::uint64_t row) {
        const std::uint64_t south = window.height - 1 - row;
        const auto mark = [&](std::uint64_t east, std::uint64_t north) {
            return static_cast<Color>(is_marked(column + east, south + north));
        };
        return marks_of(set, index) == CornerTile{mark(1, 1), mark(1, 0), mark(0, 0), mark(0, 1)};
    };
}

/// The tiles with these indices, one of several where there are some.
TextureWindow window_of(const TextureSet& set, const TileWindow& window, std::uint64_t seed,
                        const std::vector<TileIndex>& indices)
{
    const TileNumbers numbers(set, seed);
    TextureWindow shown{window.width, window.height, {}};
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const auto column = static_cast<std::int64_t>(i % window.width),
                   row = static_cast<std::int64_t>(i / window.width);
        const auto north = static_cast<std::int64_t>(static_cast<std::uint64_t>(window.y) + window.height - 1);
        shown.tiles.push_back(numbers.draw(indices[i], window.x + column, north - row));
    }
    return shown;
}

}

TextureWindow texture_window(const TextureSet& set, const TileWindow& window, std::uint64_t seed)
{
    check_window(window);
    const bool is_hashed = set.index_set().is_complete();
    if (!is_hashed) check_scanlines(window);
    return window_of(set, window, seed,
                     is_hashed ? hashed_indices(set.has_corners(), set.colors, window, seed)
                               : laid_indices(set, window, seed));
}

CornerMarks corner_marks(PngPixels picture, std::uint64_t columns, std::uint64_t rows)
{
    return [picture = std::move(picture), columns, rows](std::uint64_t column, std::uint64_t row) {
        const auto x = static_cast<int>(column * static_cast<std::uint64_t>(picture.width - 1) / columns);
        const auto y = static_cast<int>((rows - row) * static_cast<std::uint64_t>(picture.height - 1) / rows);
        int sum = 0;
        for (int c = 0; c < picture.channels; ++c) sum += picture.values[picture.at(x, y, c)];
        return 2 * sum > 255 * picture.channels;
    };
}

TextureWindow marked_texture_window(const TextureSet& set, const TileWindow& window, std::uint64_t seed,
                                    const CornerMarks& is_marked)
{
    check_window(window);
    if (set.classes == 2 && set.kind == TextureKind::wang) {
        check_scanlines(window);
        check_choices(set);
        return window_of(set, window, seed, laid_indices(set, window, seed, tiles_by_marks(set, window, is_marked)));
    }
    if (set.classes != 2 || set.kind != TextureKind::corner || !set.is_complete())
        throw InputError("marks need Wang tiles or a complete set of corner tiles with corners that are marked or not");
    const Color colors = set.colors.horizontal, in_class = colors / 2;
    std::vector<TileIndex> indices = hashed_indices(true, {in_class, in_class}, window, seed);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::uint64_t column = i % window.width, row = window.height - 1 - i / window.width;
        CornerTile tile = corner_tile(indices[i], in_class);
        const auto mark = [&](Color& color, std::uint64_t east, std::uint64_t north) {
            if (is_marked(column + east, row + north)) color += in_class;
        };
        mark(tile.south_west, 0, 0);
        mark(tile.south_east, 1, 0);
        mark(tile.north_west, 0, 1);
        mark(tile.north_east, 1, 1);
        indices[i] = corner_index(tile, colors);
    }
    return window_of(set, window, seed, indices);
}

PngPixels texture_window_pixels(const TextureSet& set, const TextureWindow& window,
                                std::span<const std::uint8_t> values, int channels)
{
    PngPixels pixels{
        static_cast<int>(window.columns) * set.size, static_cast<int>(window.rows) * set.size, channels, {}};
    pixels.values.resize(pixels.at(0, pixels.height, 0));
    for (std::size_t row = 0; row < window.rows; ++row)
        copy_row_of_tiles(set, window, row, values, static_cast<std::size_t>(channels),
                          pixels.values.data() + pixels.at(0, static_cast<int>(row) * set.size, 0));
    return pixels;
}

void write_texture_window(const std::filesystem::path& file, const TextureSet& set, const TextureWindow& window)
{
    const auto size = static_cast<std::size_t>(set.size), channels = static_cast<std::size_t>(set.exemplar.channels);
    if (std::max(window.columns, window.rows) * size > most_window_pixels)
        throw InputError(fmt::format("a picture of {} x {} pixels: must have at most {} along a side",
                                     window.columns * size, window.rows * size, most_window_pixels));
    const std::size_t row_bytes = size * channels;
    std::vector<std::uint8_t> pixels(window.columns * size * row_bytes);
    const auto rows = [&](int first, int) {
        stop_if_interrupted();
        copy_row_of_tiles(set, window, static_cast<std::size_t>(first) / size, set.values, channels, pixels.data());
        return pixels.data();
    };
    PngLayout layout{static_cast<int>(window.columns * size), static_cast<int>(window.rows * size),
                     set.exemplar.channels};
    layout.rows_at_once = set.size;
    write_png(file, layout, rows);
}

}
