// runtime/texture_tiles.h, as C++ and as OpenCL C, against the packing and an endless texture that is put together.
#include "runtime/texture_tiles.h"

#include "host/device/device.hpp"
#include "host/device/kernel_source.hpp"
#include "runtime/poisson_tiles.h"
#include "tests/tiles/texture/quartered_set.hpp"
#include "tiles/packing/closed_packing.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

TEST(TextureTilesHeader, KnowsThePlaceOfEveryTile)
{
    for (Color colors = 2; colors <= 16; ++colors)
        for (TileIndex index = 0; index < colors * colors * colors * colors; ++index) {
            const CornerTile t = corner_tile(index, colors);
            const PackingPlace expected = place_of_tile(TileKind::corner, index, colors);
            const auto place = colors % 2 == 1 ? ttiles_odd_place : ttiles_even_place;
            ASSERT_EQ(place(colors, t.north_east, t.south_east, t.south_west, t.north_west),
                      expected.y * colors * colors + expected.x)
                << colors << " " << index;
        }
}

TEST(TextureTilesHeader, KnowsThePlaceOfEveryWangTile)
{
    for (Color colors = 2; colors <= 12; ++colors)
        for (Color first = 0; first < colors; ++first)
            for (Color second = 0; second < colors; ++second)
                ASSERT_EQ(ttiles_domino_place(first, second), wei_place(first, second)) << first << " " << second;
    // A tile has the edges of the lattice points around it.
    for (std::uint32_t x = 0; x < 50; ++x) {
        const std::uint32_t y = 3 * x, colors = 2 + x % 5;
        const WangTile tile{ttiles_edge_color(9, colors, x, y + 1, 0), ttiles_edge_color(9, colors, x + 1, y, 1),
                            ttiles_edge_color(9, colors, x, y, 0), ttiles_edge_color(9, colors, x, y, 1)};
        const PackingPlace expected = place_of_tile(TileKind::wang, wang_index(tile, {colors, colors}), colors);
        EXPECT_EQ(ttiles_wang_place(9, colors, x, y), expected.y * colors * colors + expected.x);
    }
}

/// A point set and a texture with the same seed are over the same tiling.
TEST(TextureTilesHeader, HasTheColorsOfPoissonDiskTiles)
{
    std::mt19937 random(2);
    const auto word = [&] { return static_cast<std::uint32_t>(random()); };
    for (int i = 0; i < 1000; ++i) {
        const std::uint32_t seed = word(), x = word(), y = word();
        EXPECT_EQ(ttiles_color(seed, 5, x, y), ptiles_hash(seed, x, y, 0) % 5);
        for (const std::uint32_t is_vertical : {0u, 1u})
            EXPECT_EQ(ttiles_edge_color(seed, 5, x, y, is_vertical), ptiles_hash(seed, x, y, is_vertical) % 5);
    }
}

/// All tiles of a kind, without pixels.
TextureSet tiles_without_pixels(TextureKind kind, Color colors)
{
    TextureSet set;
    set.kind = kind;
    set.colors = {colors, colors};
    for (TileIndex index = 0; index < colors * colors * colors * colors; ++index) set.tiles.push_back({index, 0});
    return set;
}

/// Returns the place in the atlas of a tile of a window, as the header counts.
std::uint32_t place_in_atlas(const TextureSet& set, const TextureWindow& window, std::size_t column, std::size_t north)
{
    const AtlasLayout layout = atlas_layout(set);
    const auto [x, y] = layout.places[window.tiles[(window.rows - 1 - north) * window.columns + column]];
    return static_cast<std::uint32_t>((layout.rows - 1 - y) * layout.columns + x);
}

/// `texture tile` and tables [[texture]] lay the tiles that the header says, also left of 0 and around 2^32.
TEST(TextureTilesHeader, LaysTheTilesOfTilings)
{
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang})
        for (const Color colors : {2u, 3u, 5u}) {
            const TextureSet set = tiles_without_pixels(kind, colors);
            const auto place = kind == TextureKind::wang ? ttiles_wang_place : ttiles_place;
            for (const std::int64_t west : {-6ll, (1ll << 32) - 5}) {
                const TextureWindow window = texture_window(set, {west, 7 - west, 12, 9}, 2147483653u);
                for (std::uint32_t column = 0; column < 12; ++column)
                    for (std::uint32_t north = 0; north < 9; ++north)
                        ASSERT_EQ(place_in_atlas(set, window, column, north),
                                  place(2147483653u, colors, static_cast<std::uint32_t>(west) + column,
                                        static_cast<std::uint32_t>(7 - west) + north))
                            << texture_kinds[kind] << " " << colors << " " << column << " " << north;
            }
        }
}

/// Corners with a map of marks have colours that a program can count as well: the hash of half of them, and the mark.
TEST(TextureTilesHeader, LaysTheTilesOfMarkedCorners)
{
    TextureSet set = tiles_without_pixels(TextureKind::corner, 6);
    set.classes = 2;
    const auto is_marked = [](std::uint64_t column, std::uint64_t row) { return (column * 5 + row * 3) % 7 < 3; };
    const TextureWindow window = marked_texture_window(set, {-4, 9, 11, 8}, 5, is_marked);
    const auto color = [&](std::uint32_t column, std::uint32_t north) {
        return ttiles_color(5, 3, column - 4u, north + 9u) + (is_marked(column, north) ? 3u : 0u);
    };
    for (std::uint32_t x = 0; x < 11; ++x)
        for (std::uint32_t y = 0; y < 8; ++y)
            ASSERT_EQ(place_in_atlas(set, window, x, y),
                      ttiles_corner_place(6, color(x + 1, y + 1), color(x + 1, y), color(x, y), color(x, y + 1)));
}

/// Every texel shows the patch of the nearest lattice point, in tiles of quarters: neighbours are contiguous but where
/// patches meet.
TEST(TextureTilesHeader, FindsTheTexelsOfAnEndlessTexture)
{
    constexpr int size = 8;
    for (const std::vector<std::pair<int, int>>& patches :
         {std::vector<std::pair<int, int>>{{0, 0}, {8, 0}}, {{0, 0}, {8, 0}, {16, 0}}}) {
        PngPixels exemplar{24, 8, 1, {}};
        for (int i = 0; i < 24 * 8; ++i) exemplar.values.push_back(static_cast<std::uint8_t>(i));
        const TextureSet set = test::quartered_set(exemplar, size, patches);
        const PngPixels atlas = atlas_of(set);
        const auto colors = static_cast<std::uint32_t>(patches.size());
        for (int y = -20; y < 20; ++y)
            for (int x = -20; x < 20; ++x)
                for (std::uint32_t row = 0; row < size; ++row)
                    for (std::uint32_t column = 0; column < size; ++column) {
                        const auto tile_x = static_cast<std::uint32_t>(x), tile_y = static_cast<std::uint32_t>(y);
                        const std::uint32_t east = column >= size / 2, north = row >= size / 2;
                        const std::uint32_t color = ttiles_color(7, colors, tile_x + east, tile_y + north);
                        // The patch is centred on the lattice point, its rows going south.
                        const int in_x = patches[color].first + size / 2 + static_cast<int>(column) - (east ? size : 0);
                        const int in_y = size / 2 - 1 - static_cast<int>(row) + (north ? size : 0);
                        ASSERT_EQ(atlas.values[ttiles_texel(7, colors, size, tile_x, tile_y, column, row)],
                                  exemplar.values[exemplar.at(in_x, in_y, 0)])
                            << x << " " << y << " " << column << " " << row;
                    }
    }
}

TEST(TextureTilesHeader, IsTheSameInOpenCl)
{
    const std::string text = kernel_source("runtime/texture_tiles.h") + R"(
        kernel void look_up(uint count, global uint* texels)
        {
            const uint i = get_global_id(0);
            if (i < count)
                texels[i] = i % 2u == 0u
                    ? ttiles_texel(i, 2u + i % 9u, 64u, i * 2654435761u, i * 40503u, i % 64u, i / 7u % 64u)
                    : ttiles_wang_texel(i, 2u + i % 9u, 64u, i * 2654435761u, i * 40503u, i % 64u, i / 7u % 64u);
        }
    )";
    constexpr std::uint32_t count = 5000;
    Device device = Device::open();
    auto texels = device.buffer<std::uint32_t>(count);
    device.kernel_from_text(text, "texture_tiles.h", "look_up").run(count, 64, count, texels);
    const std::vector<std::uint32_t> found = texels.read(0, count);
    for (std::uint32_t i = 0; i < count; ++i)
        ASSERT_EQ(found[i], (i % 2u == 0u ? ttiles_texel : ttiles_wang_texel)(i, 2u + i % 9u, 64u, i * 2654435761u,
                                                                              i * 40503u, i % 64u, i / 7u % 64u));
}

}
}
