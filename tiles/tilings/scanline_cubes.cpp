#include "tiles/tilings/scanline_cubes.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <fmt/format.h>

#include <vector>

namespace poissonlab {

TileSet compact_wang_cube_set(Color colors)
{
    if (colors > 16)
        throw InputError(fmt::format("colors = {}: must be at most 16 for a compact set of cubes", colors));
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
