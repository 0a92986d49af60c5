#include "tiles/tilings/scanline_tiling.hpp"

#include "base/errors/errors.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace poissonlab {
namespace {

/// The colours of a tile that its neighbours to the north and west share: north, west; or NE, SW, NW.
struct SharedColors
{
    std::array<Color, 3> colors{};
    std::array<Color, 3> bases{}; ///< how many colours each can have; 1: there is none
};

SharedColors shared_colors(TileKind kind, WangColors c, TileIndex index)
{
    if (kind == TileKind::wang) {
        const WangTile tile = wang_tile(index, c);
        return {{tile.north, tile.west, 0}, {c.horizontal, c.vertical, 1}};
    }
    const CornerTile tile = corner_tile(index, c.horizontal);
    return {{tile.north_east, tile.south_west, tile.north_west}, {c.horizontal, c.horizontal, c.horizontal}};
}

/// A number for the colours, of which those that are not known are one more than the largest.
std::size_t pattern_number(const SharedColors& shared, const std::array<bool, 3>& is_known)
{
    std::size_t number = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (shared.bases[i] == 1) continue;
        number = number * (shared.bases[i] + 1) + (is_known[i] ? shared.colors[i] : shared.bases[i]);
    }
    return number;
}

/// Says which shared colours are known, with or without a neighbour to the north and one to the west.
std::array<bool, 3> known_colors(TileKind kind, bool has_north, bool has_west)
{
    if (kind == TileKind::wang) return {has_north, has_west, false};
    return {has_north, has_west, has_north || has_west};
}

}

FittingTiles::FittingTiles(const TileSet& tiles) : kind_(tiles.kind()), colors_(tiles.colors())
{
    if (kind_ != TileKind::wang && kind_ != TileKind::corner)
        throw std::logic_error("scanlines are of Wang or corner tiles");
    const Color colors = std::max(colors_.horizontal, colors_.vertical);
    if (colors > max_scanline_colors)
        throw InputError("colors = " + std::to_string(colors) + ": must be at most " +
                         std::to_string(max_scanline_colors) + " for a tiling by scanlines");

    // Counts, starts, tiles in their places.
    const auto for_each_pattern = [&](const auto& use) {
        for (std::uint64_t position = 0; position < tiles.size(); ++position) {
            const TileIndex index = tiles.index(position);
            const SharedColors shared = shared_colors(kind_, colors_, index);
            for (const bool has_north : {false, true}) {
                for (const bool has_west : {false, true})
                    use(pattern_number(shared, known_colors(kind_, has_north, has_west)), index);
            }
        }
    };
    const SharedColors bases = shared_colors(kind_, colors_, 0);
    begins_.assign(pattern_number(bases, {false, false, false}) + 2, 0);
    for_each_pattern([&](std::size_t pattern, TileIndex) { ++begins_[pattern + 1]; });
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    tiles_.resize(begins_.back());
    std::vector<std::uint32_t> next = begins_;
    for_each_pattern([&](std::size_t pattern, TileIndex index) { tiles_[next[pattern]++] = index; });
}

std::size_t FittingTiles::pattern(const TileIndex* north, const TileIndex* west) const
{
    SharedColors shared = shared_colors(kind_, colors_, 0);
    if (kind_ == TileKind::wang) {
        if (north != nullptr) shared.colors[0] = wang_tile(*north, colors_).south;
        if (west != nullptr) shared.colors[1] = wang_tile(*west, colors_).east;
    } else {
        const Color c = colors_.horizontal;
        if (west != nullptr) {
            shared.colors[1] = corner_tile(*west, c).south_east;
            shared.colors[2] = corner_tile(*west, c).north_east;
        }
        if (north != nullptr) {
            shared.colors[0] = corner_tile(*north, c).south_east;
            shared.colors[2] = corner_tile(*north, c).south_west;
        }
    }
    return pattern_number(shared, known_colors(kind_, north != nullptr, west != nullptr));
}

std::span<const TileIndex> FittingTiles::choices(const TileIndex* north, const TileIndex* west) const
{
    const std::size_t p = pattern(north, west);
    return {tiles_.data() + begins_[p], begins_[p + 1] - begins_[p]};
}

std::size_t FittingTiles::fewest_choices() const
{
    // Every pattern that a tiling can have, from the sides of all tiles. Tiles beside each other that agree
    // with a third at the corner are as many as pairs of tiles, but only their colours count.
    std::size_t fewest = tiles_.size();
    const Color c = colors_.horizontal;
    const Color thirds = kind_ == TileKind::wang ? 1 : c;
    for (Color a = 0; a <= c; ++a) {
        for (Color b = 0; b <= (kind_ == TileKind::wang ? colors_.vertical : c); ++b) {
            for (Color corner = 0; corner < thirds; ++corner) {
                SharedColors shared = shared_colors(kind_, colors_, 0);
                shared.colors = {a, b, corner};
                const bool has_north = a < c;
                const bool has_west = b < shared.bases[1];
                const std::size_t p = pattern_number(shared, known_colors(kind_, has_north, has_west));
                fewest = std::min<std::size_t>(fewest, begins_[p + 1] - begins_[p]);
            }
        }
    }
    return fewest;
}

ScanlineTiling::ScanlineTiling(const TileSet& tiles, std::uint64_t width, std::uint64_t seed)
    : fitting_(tiles), key_(stream_key(seed, Purpose::scanline_tiling, 0))
{
    if (width > max_scanline_width)
        throw InputError("tiling by scanlines: width = " + std::to_string(width) + ": must be at most " +
                         std::to_string(max_scanline_width));
    if (fitting_.fewest_choices() < 2)
        throw InputError("tiling by scanlines: at some places fewer than two tiles of the set fit");
    row_.resize(width);
}

std::span<const TileIndex> ScanlineTiling::next_row()
{
    std::array<std::uint32_t, 4> words{};
    for (std::size_t x = 0; x < row_.size(); ++x) {
        if (x % 4 == 0) {
            const std::uint64_t block = x / 4;
            words = philox({static_cast<std::uint32_t>(block), static_cast<std::uint32_t>(block >> 32),
                            static_cast<std::uint32_t>(rows_), static_cast<std::uint32_t>(rows_ >> 32)},
                           key_);
        }
        const auto choices = fitting_.choices(rows_ > 0 ? &row_[x] : nullptr, x > 0 ? &row_[x - 1] : nullptr);
        // Each choice has the same number of words, or one less of 2^32.
        row_[x] = choices[std::uint64_t{words[x % 4]} * choices.size() >> 32];
    }
    ++rows_;
    return row_;
}

void ScanlineTiling::stream(std::uint64_t height, const TileSink& sink)
{
    for (std::uint64_t row = 0; row < height; ++row) sink(0, static_cast<std::int64_t>(height - 1 - row), next_row());
}

TileSet compact_wang_cube_set(Color colors)
{
    if (colors > 16)
        throw invalid_value({}, "colors", fmt::format("{}", colors), "must be at most 16 for a compact set of cubes");
    const TileSet all = TileSet::complete(TileKind::wang_cube, colors);
    std::vector<TileIndex> indices;
    for (std::uint64_t i = 0; i < all.size(); ++i) {
        const WangCube cube = wang_cube(all.index(i), colors);
        if ((cube.north + cube.east + cube.south + cube.west + cube.top + cube.bottom) % colors == 0)
            indices.push_back(all.index(i));
    }
    return {TileKind::wang_cube, {colors, colors}, std::move(indices)};
}

void stream_scanline_cubes(Color colors, bool is_compact, std::uint64_t seed, std::uint64_t width, std::uint64_t height,
                           std::uint64_t depth, const CubeSink& sink)
{
    // The sets are checked where they are made; here cubes follow from their rule.
    constexpr std::uint64_t largest_layer = std::uint64_t{1} << 26;
    if (width > largest_layer || height > largest_layer || width * height > largest_layer)
        throw InputError(
            fmt::format("a layer of {} x {} cubes by scanlines: must have at most {}", width, height, largest_layer));
    const StreamKey key = stream_key(seed, Purpose::scanline_tiling, 0);
    std::vector<Color> tops(width * height), souths(width);
    std::vector<TileIndex> row(width);
    for (std::uint64_t z = 0; z < depth; ++z)
        for (std::uint64_t y = height; y-- > 0;) {
            Color east = 0;
            for (std::uint64_t x = 0; x < width; ++x) {
                const auto colors_of_block = [&](std::uint32_t block) {
                    auto words =
                        philox({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                static_cast<std::uint32_t>(z), block | static_cast<std::uint32_t>(z >> 32) << 1},
                               key);
                    for (std::uint32_t& word : words)
                        word = static_cast<std::uint32_t>(std::uint64_t{word} * colors >> 32);
                    return words;
                };
                const auto free = colors_of_block(0), border = colors_of_block(1);
                WangCube cube;
                cube.north = y + 1 < height ? souths[x] : border[0];
                cube.west = x > 0 ? east : border[1];
                cube.bottom = z > 0 ? tops[y * width + x] : border[2];
                cube.south = free[0];
                cube.east = free[1];
                const Color sum = cube.north + cube.west + cube.bottom + cube.south + cube.east;
                cube.top = is_compact ? (colors - sum % colors) % colors : free[2];
                souths[x] = cube.south;
                east = cube.east;
                tops[y * width + x] = cube.top;
                row[x] = wang_cube_index(cube, colors);
            }
            sink(0, static_cast<std::int64_t>(y), static_cast<std::int64_t>(z), row);
        }
}

}
