#include "host/tile_sampling/recursive/recursive_points.hpp"

#include "base/random/random_words.hpp"
#include "tiles/tilings/even_wang_tiles.hpp"
#include "tiles/tilings/tiling.hpp"

#include <algorithm>
#include <array>

namespace poissonlab {
namespace {

/// The tilings of a torus, by its side, of which none is another one shifted: an orbit count over the solutions of the
/// tiles' parities. One tile can lie beside itself in four ways, but methods with one tile make one set.
constexpr std::array<std::size_t, 5> different_tilings{0, 1, 14, 128, 8312};

/// One of all 2^(side * side + 1) tilings of a torus, which are equally likely.
///
/// Colours of edges are the sums of bits at their ends, as the hash has them, and of one more bit for all vertical
/// edges of the first row, and one for all horizontal edges of the first column: sums around tiles stay even, and
/// closed ways around the torus may have odd ones.
RootTiles random_root_tiles(std::uint32_t side, RandomWords& words)
{
    std::vector<Color> corners(std::size_t{side} * side);
    for (Color& bit : corners) bit = words.below(2);
    const Color across_row = words.below(2), across_column = words.below(2);
    const auto corner = [&](std::uint32_t x, std::uint32_t y) { return corners[y % side * side + x % side]; };
    const auto vertical = [&](std::uint32_t x, std::uint32_t y) {
        return corner(x, y) ^ corner(x, y + 1) ^ (y == 0 ? across_row : 0);
    };
    const auto horizontal = [&](std::uint32_t x, std::uint32_t y) {
        return corner(x, y) ^ corner(x + 1, y) ^ (x == 0 ? across_column : 0);
    };
    RootTiles tiles;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            tiles.push_back(static_cast<std::uint32_t>(
                even_wang_tile({horizontal(x, y + 1), vertical(x + 1, y), horizontal(x, y), vertical(x, y)})));
    return tiles;
}

}

RootTiles hashed_root_tiles(std::uint32_t side, const StreamKey& stream)
{
    const Tiling tiling(DirectAlgorithm::wang_one_hash, {2, 2}, HashKind::xxh64,
                        std::uint64_t{stream[0]} << 32 | stream[1], {side, side, 0});
    RootTiles tiles;
    for (std::uint32_t i = 0; i < side * side; ++i)
        tiles.push_back(static_cast<std::uint32_t>(even_wang_tile(wang_tile(tiling.tile(i % side, i / side), {2, 2}))));
    return tiles;
}

RootTiles least_shifted(const RootTiles& tiles, std::uint32_t side)
{
    RootTiles least = tiles, shifted(tiles.size());
    for (std::uint32_t by = 0; by < side * side; ++by) {
        for (std::uint32_t i = 0; i < side * side; ++i)
            shifted[i] = tiles[(i / side + by / side) % side * side + (i + by) % side];
        least = std::min(least, shifted);
    }
    return least;
}

RootTiles RealizationRoots::of(std::uint32_t realization)
{
    if (side_ >= different_tilings.size())
        return hashed_root_tiles(side_, stream_key(seed_, Purpose::recursive_tilings, realization));
    while (drawn_.size() <= realization) draw_next();
    return drawn_[realization];
}

void RealizationRoots::draw_next()
{
    const auto realization = static_cast<std::uint32_t>(drawn_.size());
    const StreamKey stream = stream_key(seed_, Purpose::recursive_tilings, realization);
    RootTiles tiles = hashed_root_tiles(side_, stream);
    if (seen_.size() < different_tilings[side_]) {
        RandomWords words(stream, 1); // table 0 is the order of tiles
        while (!seen_.insert(least_shifted(tiles, side_)).second) tiles = random_root_tiles(side_, words);
    }
    drawn_.push_back(std::move(tiles));
}

}
