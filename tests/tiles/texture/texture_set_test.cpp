// Texture sets as files, their proof, and their tilings, by a set whose tiles are the quarters of two patches.
#include "tiles/texture/texture_set.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tiles/texture/quartered_set.hpp"
#include "tiles/texture/texture_certificate.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace poissonlab {
namespace {

using testing::HasSubstr;

constexpr int side = 8; // of a tile

/// An exemplar of 16 x 8 pixels whose values tell the place: patch 0 is the left half, patch 1 the right half.
PngPixels numbered_exemplar()
{
    PngPixels exemplar{2 * side, side, 1, {}};
    for (int i = 0; i < 2 * side * side; ++i) exemplar.values.push_back(static_cast<std::uint8_t>(i));
    return exemplar;
}

/// All corner tiles over two colours, each of four quarters of patches: the joints are inside of tiles.
TextureSet small_set() { return test::quartered_set(numbered_exemplar(), side, {{0, 0}, {side, 0}}); }

/// Gives a pixel another source, and its value.
void move_source(TextureSet& set, std::size_t tile, int x, int y, SourcePixel source)
{
    const std::size_t pixel = tile * set.pixels_a_tile() + static_cast<std::size_t>(y * side + x);
    set.sources[pixel] = source;
    set.values[pixel] = set.exemplar.values[set.exemplar.at(source.x, source.y, 0)];
}

TEST(TextureCertificate, CountsAllPairsOfASetThatFits)
{
    const TextureCertificate proof = certify_texture(small_set());
    EXPECT_EQ(proof.tile_pairs, 16u * 4 * 2);
    EXPECT_EQ(proof.pixel_pairs, 16u * 4 * 2 * side);
    EXPECT_EQ(proof.joints, 0u);
    EXPECT_EQ(proof.exceptions, 0u);
}

TEST(TextureCertificate, FindsASinglePixelThatDoesNotFit)
{
    TextureSet set = small_set();
    move_source(set, 5, 0, 3, {2, 2});
    EXPECT_THAT(message_of([&] { certify_texture(set); }), HasSubstr("its ring of 1 pixels is not that of"));
    set.ring = 0; // the ring alone is no proof: borders are compared as well
    EXPECT_THAT(message_of([&] { certify_texture(set); }), HasSubstr("have a joint that their shared colours do not"));
}

TEST(TextureCertificate, FindsAPixelThatIsNotItsSources)
{
    TextureSet set = small_set();
    set.values[7 * set.pixels_a_tile() + 3 * side + 4] ^= 1;
    EXPECT_EQ(message_of([&] { certify_texture(set); }), "tile 7: the pixel in column 4, row 3 is not its source's");
    set.is_smoothed = true; // inside of the ring pixels may differ, not in it
    certify_texture(set);
    set.values[7 * set.pixels_a_tile() + 4] ^= 1;
    EXPECT_EQ(message_of([&] { certify_texture(set); }), "tile 7: the pixel in column 4, row 0 is not its source's");
}

/// The middle of a tile is its own.
TEST(TextureCertificate, LeavesTheMiddleFree)
{
    TextureSet set = small_set();
    move_source(set, 9, 4, 4, {0, 0});
    EXPECT_EQ(certify_texture(set).joints, 0u);
}

/// Joints across a border that all tiles with the colours have are predicted.
TEST(TextureCertificate, CountsJointsThatTheColorsPredict)
{
    TextureSet set = small_set();
    for (std::size_t tile = 0; tile < 16; ++tile) {
        const CornerTile t = corner_tile(set.tiles[tile].index, 2);
        if (t.north_east == 1 && t.south_east == 0) move_source(set, tile, side - 1, 3, {1, 1});
    }
    const TextureCertificate proof = certify_texture(set);
    EXPECT_EQ(proof.joints, 4u * 4);
}

class TextureFiles : public testing::Test
{
protected:
    TextureFiles() { write_texture_set(folder_.path(), small_set()); }

    std::string refusal() const
    {
        return message_of([&] { read_texture_set(folder_.path()); }).substr(folder_.path().string().size() + 1);
    }

    /// Replaces a text of the JSON file.
    void change(const std::string& from, const std::string& to) const
    {
        std::ifstream stream(folder_.path() / "texture.json");
        std::string text{std::istreambuf_iterator<char>(stream), {}};
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << text;
        folder_.write("texture.json", text.replace(at, from.size(), to));
    }

    TemporaryFolder folder_;
};

TEST_F(TextureFiles, AreReadAsTheyWereWritten)
{
    const TextureSet written = small_set(), read = read_texture_set(folder_.path());
    EXPECT_EQ(read.kind, written.kind);
    EXPECT_EQ(read.colors, written.colors);
    EXPECT_EQ(read.size, written.size);
    EXPECT_EQ(read.ring, written.ring);
    EXPECT_EQ(read.tiles, written.tiles);
    EXPECT_EQ(read.sources, written.sources);
    EXPECT_EQ(read.values, written.values);
    EXPECT_EQ(read.exemplar.values, written.exemplar.values);
    EXPECT_EQ(read.parameters, written.parameters);
    EXPECT_THAT(folder_.names(),
                testing::UnorderedElementsAre("atlas.png", "sources.png", "exemplar.png", "texture.json"));
}

/// Neighbours in the atlas have the same colours where they meet: no joint at the borders of its tiles either.
TEST_F(TextureFiles, HaveAnAtlasThatIsAPacking)
{
    const PngPixels atlas = read_png(folder_.path() / "atlas.png");
    const DeepPixels sources = read_deep_png(folder_.path() / "sources.png");
    EXPECT_EQ(atlas.width, 4 * side);
    EXPECT_EQ(atlas.height, 4 * side);
    const auto source = [&](int x, int y) {
        const auto at = static_cast<std::size_t>(y % atlas.height * atlas.width + x % atlas.width) * 3;
        return std::pair<int, int>(sources.values[at], sources.values[at + 1]);
    };
    for (int i = 0; i < 4 * side; ++i)
        for (int border = side; border <= 4 * side; border += side) {
            EXPECT_EQ(source(border, i), std::pair(source(border - 1, i).first + 1, source(border - 1, i).second));
            EXPECT_EQ(source(i, border), std::pair(source(i, border - 1).first, source(i, border - 1).second + 1));
        }
}

TEST_F(TextureFiles, AreRefusedWhereTheyAreDamaged)
{
    change("\"ring\": 1", "\"ring\": 5");
    EXPECT_EQ(refusal(), "texture.json: ring = 5: must be at most half of tile_size");
    change("\"ring\": 5", "\"ring\": 1");
    change("\"tile_size\": 8", "\"tile_size\": 4");
    EXPECT_THAT(refusal(), HasSubstr("atlas.png: 32 x 32 pixels with 1 channels: must be 16 x 16 with 1"));
    change("\"tile_size\": 4", "\"tile_size\": 8");
    change("\"column\": 0", "\"column\": 1");
    EXPECT_EQ(refusal(), "texture.json: tiles lie elsewhere in the atlas");
    change("\"column\": 1", "\"column\": 0");
    read_texture_set(folder_.path());
    PngPixels atlas = read_png(folder_.path() / "atlas.png");
    atlas.values[77] ^= 1;
    write_png(folder_.path() / "atlas.png", {atlas.width, atlas.height, 1},
              [&](int row, int) { return &atlas.values[atlas.at(0, row, 0)]; });
    EXPECT_EQ(refusal(), "atlas.png: is damaged, or not the picture of this texture.json");
    std::filesystem::remove(folder_.path() / "sources.png");
    EXPECT_THAT(refusal(), HasSubstr("sources.png: cannot read the picture"));
    std::filesystem::remove(folder_.path() / "texture.json");
    EXPECT_THAT(refusal(), HasSubstr("texture.json"));
}

TEST(TextureTiling, LaysTilesThatFit)
{
    const TextureSet set = small_set();
    const TextureWindow window = texture_window(set, {-3, 5, 9, 7}, 4);
    EXPECT_EQ(window.tiles.size(), 63u);
    for (std::size_t row = 0; row < 7; ++row)
        for (std::size_t column = 0; column + 1 < 9; ++column) {
            const CornerTile west = corner_tile(set.tiles[window.tiles[row * 9 + column]].index, 2);
            const CornerTile east = corner_tile(set.tiles[window.tiles[row * 9 + column + 1]].index, 2);
            EXPECT_EQ(west.north_east, east.north_west);
            EXPECT_EQ(west.south_east, east.south_west);
        }
    // A part of it is the same.
    const TextureWindow part = texture_window(set, {-1, 6, 3, 2}, 4);
    for (std::size_t row = 0; row < 2; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            EXPECT_EQ(part.tiles[row * 3 + column], window.tiles[(row + 4) * 9 + column + 2]);
}

TEST(TextureTiling, WritesThePixelsOfItsTiles)
{
    const TextureSet set = small_set();
    const TextureWindow window = texture_window(set, {0, 0, 3, 2}, 1);
    const TemporaryFolder folder;
    write_texture_window(folder.path() / "t.png", set, window);
    const PngPixels picture = read_png(folder.path() / "t.png");
    ASSERT_EQ(picture.width, 3 * side);
    ASSERT_EQ(picture.height, 2 * side);
    for (int y = 0; y < 2 * side; ++y)
        for (int x = 0; x < 3 * side; ++x) {
            const std::size_t tile = window.tiles[static_cast<std::size_t>(y / side * 3 + x / side)];
            EXPECT_EQ(picture.values[picture.at(x, y, 0)],
                      set.values_of(tile)[static_cast<std::size_t>(y % side * side + x % side)]);
        }
}

/// Sets that are not complete are laid in scanlines from (0, 0), by variants too.
TEST(TextureTiling, LaysOtherSetsInScanlines)
{
    TextureSet set = small_set();
    for (TextureTile& tile : set.tiles) tile = {corner_index({0, 0, 0, 0}, 2), tile.index};
    const TextureWindow window = texture_window(set, {0, 0, 20, 20}, 3);
    EXPECT_EQ(std::set<std::size_t>(window.tiles.begin(), window.tiles.end()).size(), 16u);
    EXPECT_THAT(message_of([&] { texture_window(set, {1, 0, 2, 2}, 3); }), HasSubstr("must be at 0 0"));
    EXPECT_THAT(message_of([&] { texture_window(set, {0, 0, 1 << 20, 1 << 20}, 3); }), HasSubstr("must have at most"));
}

}
}
