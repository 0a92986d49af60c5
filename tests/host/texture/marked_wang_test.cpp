// Wang tiles with marked corners out of two exemplars of noise, in which every pixel's exemplar can be told.
#include "base/files/whole_file.hpp"
#include "host/texture/exemplar.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/texture/texture_certificate.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace poissonlab {
namespace {

using testing::HasSubstr;

constexpr int split = 100; ///< columns of the exemplar of unmarked corners

PngPixels both_exemplars()
{
    return side_by_side(test::random_picture(split, 110, 1, 7), test::random_picture(90, 120, 1, 8));
}

TextureRequest marked_request(const std::string& tiles)
{
    TextureRequest request;
    request.kind = TextureKind::wang;
    request.tiles = tiles;
    request.size = 32;
    request.attempts = 1;
    request.split = split;
    return request;
}

BuiltTexture marked_texture(const TextureRequest& request)
{
    return build_texture(request, both_exemplars(), [](const std::string&, std::size_t, std::size_t) {});
}

bool is_of_marked(SourcePixel source) { return source.x >= split; }

TEST(MarkedWangTexture, FitsAndShowsTheExemplarOfEachCorner)
{
    for (const QuiltingCut cut : {QuiltingCut::minimum_cut, QuiltingCut::path})
        for (const std::string tiles : {"complete", "compact", "random-marks"}) {
            TextureRequest request = marked_request(tiles);
            request.cut = cut;
            const BuiltTexture texture = marked_texture(request);
            const TextureSet& set = texture.set;
            EXPECT_EQ(set.tiles.size(), tiles == "complete" ? 256u : tiles == "compact" ? 128u : 64u);
            EXPECT_EQ(texture.windows.size(), 8u); // one of each exemplar for each of four colours
            for (const ExemplarWindow& window : texture.windows)
                EXPECT_TRUE(window.x + window.size <= split || window.x >= split) << window.x;
            const TextureCertificate proof = certify_texture(set);
            EXPECT_LE(proof.exceptions, 2 * proof.tile_pairs);
            for (std::size_t tile = 0; tile < set.tiles.size(); ++tile) {
                const CornerTile marks = marks_of(set, set.tiles[tile].index);
                const Color count = marks.north_east + marks.south_east + marks.south_west + marks.north_west;
                const auto shown = std::ranges::count_if(set.sources_of(tile), is_of_marked);
                if (count % 4 == 0)
                    EXPECT_EQ(shown, count == 0 ? 0 : 32 * 32);
                else
                    EXPECT_TRUE(shown > 0 && shown < 32 * 32) << shown;
            }
        }
}

/// Along an edge between a marked and an unmarked corner, sources change the exemplar within the band, four pixels wide
/// on both sides of its middle.
TEST(MarkedWangTexture, JoinsHalvesOfEdgesInTheirMiddles)
{
    const TextureSet set = marked_texture(marked_request("compact")).set;
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile) {
        const CornerTile marks = marks_of(set, set.tiles[tile].index);
        const auto sources = set.sources_of(tile);
        const auto north = [&](std::size_t x) { return is_of_marked(sources[x]); };
        for (std::size_t x = 0; x < 32; ++x) {
            if (x < 12) {
                EXPECT_EQ(north(x), marks.north_west == 1);
            }
            if (x >= 20) {
                EXPECT_EQ(north(x), marks.north_east == 1);
            }
        }
    }
}

TEST(MarkedWangTexture, IsRefusedWhereACornerShowsTheWrongExemplar)
{
    TextureSet set = marked_texture(marked_request("random-marks")).set;
    set.marked_column = split + 90; // then nothing is marked
    EXPECT_THAT(message_of([&] { certify_texture(set); }),
                HasSubstr("corner does not show the exemplar of marked corners"));
}

TEST(MarkedWangTexture, IsLaidAtRandomAndByAMap)
{
    const TextureSet set = marked_texture(marked_request("compact")).set;
    const auto is_marked = [](std::uint64_t column, std::uint64_t row) { return column * column + row * row < 30; };
    const TextureWindow window = marked_texture_window(set, {0, 0, 9, 7}, 3, is_marked);
    for (std::size_t i = 0; i < window.tiles.size(); ++i) {
        const std::uint64_t column = i % 9, row = 6 - i / 9;
        EXPECT_EQ(marks_of(set, set.tiles[window.tiles[i]].index),
                  (CornerTile{is_marked(column + 1, row + 1), is_marked(column + 1, row), is_marked(column, row),
                              is_marked(column, row + 1)}));
    }
    EXPECT_THAT(message_of([&] {
                    marked_texture_window(set, {1, 0, 2, 2}, 3, is_marked);
                }),
                HasSubstr("must be at 0 0"));
    const TextureSet half = marked_texture(marked_request("random-marks")).set;
    EXPECT_EQ(message_of([&] {
                  marked_texture_window(half, {0, 0, 9, 7}, 3, is_marked);
              }),
              "a map of marks leaves no choice of these tiles, which are for marks at random");
    // Marks at random: each of the inner lattice points is marked with probability 1/2; 4 standard deviations.
    const TextureWindow random = texture_window(half, {0, 0, 60, 60}, 3);
    double marked = 0;
    for (const std::size_t tile : random.tiles) marked += marks_of(half, half.tiles[tile].index).south_east;
    EXPECT_NEAR(marked / 3600, 0.5, 4 * 0.5 / 60);
}

TEST(MarkedWangTexture, IsReadAsItWasWritten)
{
    const TemporaryFolder folder;
    const TextureSet set = marked_texture(marked_request("random-marks")).set;
    write_texture_set(folder.path(), set);
    const TextureSet read = read_texture_set(folder.path());
    EXPECT_EQ(read.classes, 2);
    EXPECT_EQ(read.marked_column, split);
    EXPECT_EQ(read.tiles, set.tiles);
    EXPECT_EQ(read.sources, set.sources);
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string text = read_whole_file(folder.path() / "texture.json");
        text.replace(text.find(from), from.size(), to);
        folder.write("texture.json", text);
        return message_of([&] { read_texture_set(folder.path()); });
    };
    EXPECT_THAT(refusal("\"marked_column\": 100", "\"marked_column\": 190"),
                HasSubstr("texture.json: marked_column = 190: must be below the exemplar's width, 190"));
    EXPECT_THAT(refusal("\"color_classes\": 2", "\"color_classes\": 1"),
                HasSubstr("texture.json: marked_column = 190: is for color_classes = 2"));
}

TEST(MarkedWangTexture, RefusesWhatCannotBe)
{
    const auto refusal = [](auto change) {
        TextureRequest request = marked_request("compact");
        change(request);
        return message_of([&] { marked_texture(request); });
    };
    EXPECT_EQ(refusal([](auto& r) {
                  r.kind = TextureKind::omega, r.tiles = "16", r.colors = {4, 4};
              }),
              "kind = omega: has no marked corners: must be corner or wang");
    EXPECT_EQ(refusal([](auto& r) { r.smooth = true; }), "smooth = true: is for Wang tiles without marked corners");
    EXPECT_EQ(refusal([](auto& r) { r.colors = {9, 9}; }), "colors = 9: must be an integer from 2 to 8");
    EXPECT_EQ(refusal([](auto& r) { r.size = 92; }), "size = 92: must be at most the exemplar's, 90 x 110 pixels");
    EXPECT_EQ(refusal([](auto& r) { r.split = 0, r.tiles = "random-marks"; }),
              "tiles = random-marks: needs an exemplar for marked corners");
}

}
}
