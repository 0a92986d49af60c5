#include "tiles/texture/texture_tiling.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random_words.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

#include <algorithm>

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

/// Lays tiles by scanlines, also of sets that leave no choice somewhere, which ScanlineTiling refuses.
std::vector<TileIndex> laid_indices(const TextureSet& set, const TileWindow& window, std::uint64_t seed)
{
    const FittingTiles fitting(set.index_set());
    RandomWords words(stream_key(seed, Purpose::texture_scanlines, 0), 0);
    std::vector<TileIndex> laid;
    for (std::uint64_t row = 0; row < window.height; ++row)
        for (std::uint64_t column = 0; column < window.width; ++column) {
            const TileIndex* const here = laid.data() + laid.size();
            const auto choices =
                fitting.choices(row == 0 ? nullptr : here - window.width, column == 0 ? nullptr : here - 1);
            if (choices.empty()) throw InputError(fmt::format("no tile fits at column {}, row {}", column, row));
            laid.push_back(choices[words.below(static_cast<std::uint32_t>(choices.size()))]);
        }
    return laid;
}

std::vector<TileIndex> hashed_indices(const TextureSet& set, const TileWindow& window, std::uint64_t seed)
{
    const Tiling tiling(set.has_corners() ? DirectAlgorithm::corner : DirectAlgorithm::wang_edge_hash, set.colors,
                        HashKind::long_period, seed);
    std::vector<TileIndex> tiles;
    tiling.stream(window, [&](std::int64_t, std::int64_t, std::span<const TileIndex> row) {
        tiles.insert(tiles.end(), row.begin(), row.end());
    });
    return tiles;
}

}

TextureWindow texture_window(const TextureSet& set, const TileWindow& window, std::uint64_t seed)
{
    if (window.width > most_window_tiles || window.height > most_window_tiles / window.width)
        throw InputError(fmt::format("a window of {} x {} tiles: must have at most {}", window.width, window.height,
                                     most_window_tiles));
    const bool is_hashed = set.index_set().is_complete();
    if (!is_hashed && (window.x != 0 || window.y != 0))
        throw InputError(fmt::format("a window at {} {}: must be at 0 0, since these tiles are laid in scanlines",
                                     window.x, window.y));
    const std::vector<TileIndex> indices =
        is_hashed ? hashed_indices(set, window, seed) : laid_indices(set, window, seed);
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
        const std::size_t row_of_tiles = static_cast<std::size_t>(first) / size;
        for (std::size_t column = 0; column < window.columns; ++column) {
            const auto values = set.values_of(window.tiles[row_of_tiles * window.columns + column]);
            for (std::size_t row = 0; row < size; ++row)
                std::ranges::copy(values.subspan(row * row_bytes, row_bytes),
                                  pixels.begin() +
                                      static_cast<std::ptrdiff_t>((row * window.columns + column) * row_bytes));
        }
        return pixels.data();
    };
    PngLayout layout{static_cast<int>(window.columns * size), static_cast<int>(window.rows * size),
                     set.exemplar.channels};
    layout.rows_at_once = set.size;
    write_png(file, layout, rows);
}

}
