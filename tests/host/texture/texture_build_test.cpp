// Texture tile sets of noise, in which every joint can be told: they fit together, and follow from request and seed.
#include "host/texture/texture_build.hpp"

#include "base/images/raw_picture.hpp"
#include "host/texture/exemplar.hpp"
#include "host/texture/synthetic_exemplar.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/texture/seam_measures.hpp"
#include "tiles/texture/texture_certificate.hpp"
#include "tiles/texture/texture_tiling.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <tbb/global_control.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

namespace poissonlab {
namespace {

using testing::HasSubstr;

void go_on(const std::string&, std::size_t, std::size_t) {}

TextureRequest small_request(TextureKind kind, Color colors)
{
    TextureRequest request;
    request.kind = kind;
    request.colors = {colors, colors};
    request.size = 32;
    request.candidates = 2;
    request.attempts = 5;
    return request;
}

const PngPixels& noise()
{
    static const PngPixels picture = test::random_picture(120, 110, 1, 7);
    return picture;
}

BuiltTexture built(const TextureRequest& request) { return build_texture(request, noise(), go_on); }

TEST(TextureBuild, MakesCornerTilesThatFitWithoutExceptions)
{
    for (const int stages : {0, 1, 3})
        for (const Color colors : {2u, 3u}) {
            TextureRequest request = small_request(TextureKind::corner, colors);
            request.stages = stages;
            const BuiltTexture texture = built(request);
            const TextureCertificate proof = certify_texture(texture.set);
            EXPECT_EQ(texture.set.tiles.size(), colors * colors * colors * colors);
            // Each tile has colors^2 that fit to its east, and to its north.
            EXPECT_EQ(proof.tile_pairs, 2 * texture.set.tiles.size() * colors * colors);
            EXPECT_EQ(proof.pixel_pairs, proof.tile_pairs * 32);
            EXPECT_EQ(proof.exceptions, 0u);
            // Patches reach across the border, and nothing else does without pieces around edges.
            if (stages < 3) {
                EXPECT_EQ(proof.joints, 0u);
            }
        }
}

/// The papers' circle, which reaches the border: the middles of tiles meet there.
TEST(TextureBuild, WithoutARingHasBordersThatDoNotFit)
{
    TextureRequest request = small_request(TextureKind::corner, 2);
    request.stages = 1;
    request.ring = 0;
    EXPECT_THAT(message_of([&] { certify_texture(built(request).set); }), HasSubstr("do not predict"));
}

TEST(TextureBuild, MakesWangTilesThatFitButAtCorners)
{
    for (const QuiltingCut cut : {QuiltingCut::minimum_cut, QuiltingCut::path})
        for (const std::string tiles : {"complete", "compact"}) {
            TextureRequest request = small_request(TextureKind::wang, 2);
            request.cut = cut;
            request.tiles = tiles;
            const BuiltTexture texture = built(request);
            const TextureCertificate proof = certify_texture(texture.set);
            EXPECT_EQ(texture.set.tiles.size(), tiles == "compact" ? 8u : 16u);
            EXPECT_EQ(proof.joints, 0u);
            // A pixel at each end of a vertical edge, where north or south colours differ: half of all pairs.
            EXPECT_GT(proof.exceptions, 0u);
            EXPECT_LE(proof.exceptions, proof.tile_pairs);
            EXPECT_EQ(texture.windows.size(), 4u);
        }
}

/// The mean difference of pixels two columns apart across the borders of tiles with one colour at their vertical edge.
double step_beside_vertical_edges(const TextureSet& set)
{
    double sum = 0;
    int count = 0;
    for (std::size_t a = 0; a < set.tiles.size(); ++a)
        for (std::size_t b = 0; b < set.tiles.size(); ++b) {
            if (wang_tile(set.tiles[a].index, set.colors).east != wang_tile(set.tiles[b].index, set.colors).west)
                continue;
            for (std::size_t row = 0; row < 32; ++row, ++count)
                sum += std::abs(set.values_of(a)[row * 32 + 30] - set.values_of(b)[row * 32 + 1]);
        }
    return sum / count;
}

/// Ng and others 2005, figures 6b and 10 iii: smoothing makes vertical seams in Wang tiles. Light that differs from
/// sample to sample is where it should help.
TEST(TextureBuild, WangTilesGetVerticalSeamsFromSmoothing)
{
    TextureRequest request = small_request(TextureKind::wang, 2);
    const PngPixels ramp = synthetic_exemplar("ramp", 160, 1, {});
    const TextureSet plain = build_texture(request, ramp, go_on).set;
    request.smooth = true;
    const TextureSet smoothed = build_texture(request, ramp, go_on).set;
    certify_texture(smoothed);
    EXPECT_EQ(smoothed.ring, 1);
    EXPECT_EQ(smoothed.sources, plain.sources);
    EXPECT_GT(step_beside_vertical_edges(smoothed), 2 * step_beside_vertical_edges(plain));
}

/// Two exemplars side by side: patches of marked colours come from the second one, and so do pieces between them.
TEST(TextureBuild, TakesMarkedCornersFromTheSecondExemplar)
{
    const PngPixels marked = test::random_picture(100, 130, 1, 8);
    const PngPixels both = side_by_side(noise(), marked);
    EXPECT_EQ(both.width, 220);
    EXPECT_EQ(both.height, 110);
    TextureRequest request = small_request(TextureKind::corner, 4);
    request.split = noise().width;
    request.attempts = request.candidates = 1;
    const BuiltTexture texture = build_texture(request, both, go_on);
    const TextureSet& set = texture.set;
    EXPECT_EQ(set.classes, 2);
    EXPECT_EQ(certify_texture(set).exceptions, 0u);
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile) {
        const CornerTile t = corner_tile(set.tiles[tile].index, 4);
        const int count = (t.north_east >= 2) + (t.south_east >= 2) + (t.south_west >= 2) + (t.north_west >= 2);
        const auto is_second = [](SourcePixel source) { return source.x >= 120; };
        const auto sources = set.sources_of(tile);
        if (count == 0 || count == 4) {
            EXPECT_EQ(std::ranges::count_if(sources, is_second), count == 0 ? 0 : 32 * 32);
        }
        EXPECT_EQ(is_second(sources[0]), t.north_west >= 2);
    }
    for (const ExemplarWindow& window : texture.windows)
        EXPECT_TRUE(window.x + window.size <= 120 || window.x >= 120) << window.x;
}

TEST(TextureBuild, LaysMarkedCornersByAMap)
{
    TextureRequest request = small_request(TextureKind::corner, 4);
    request.split = noise().width;
    request.attempts = request.candidates = 1;
    const TextureSet set =
        build_texture(request, side_by_side(noise(), test::random_picture(120, 110, 1, 8)), go_on).set;
    // The left half is marked: lattice columns 0, 1 and 2 of 6.
    PngPixels marks{2, 2, 1, {255, 0, 255, 0}};
    const auto is_marked = [](std::uint64_t column, std::uint64_t) { return column < 3; };
    const TextureWindow window = marked_texture_window(set, {4, -3, 5, 2}, 9, is_marked);
    for (std::size_t i = 0; i < window.tiles.size(); ++i) {
        const CornerTile t = corner_tile(set.tiles[window.tiles[i]].index, 4);
        EXPECT_EQ(t.south_west >= 2, i % 5 < 3);
        EXPECT_EQ(t.north_east >= 2, i % 5 + 1 < 3);
    }
    const CornerMarks by_picture = corner_marks(marks, 5, 2);
    EXPECT_TRUE(by_picture(0, 0) && by_picture(4, 2));
    EXPECT_FALSE(by_picture(5, 1));
    TextureSet plain = set;
    plain.classes = 1;
    EXPECT_THAT(message_of([&] {
                    marked_texture_window(plain, {0, 0, 1, 1}, 1, is_marked);
                }),
                HasSubstr("marks need Wang tiles or a complete set"));
    EXPECT_EQ(message_of([&] { side_by_side(noise(), test::random_picture(9, 9, 3, 1)); }),
              "the exemplar of marked corners must have colours as the other one has, or none");
}

TEST(TextureBuild, MakesAllSetsOfCohenAndNg)
{
    TextureRequest twelve = small_request(TextureKind::wang, 2);
    twelve.colors.vertical = 3;
    twelve.tiles = "compact";
    EXPECT_EQ(built(twelve).set.tiles.size(), 12u);
    for (const std::string tiles : {"4", "8", "16", "16b", "32", "4-doubled", "8-doubled", "16b-doubled"}) {
        TextureRequest request = small_request(TextureKind::omega, 4);
        request.tiles = tiles;
        request.diversity = 4;
        const BuiltTexture texture = built(request);
        EXPECT_EQ(texture.set.tiles.size(),
                  std::strtoul(tiles.c_str(), nullptr, 10) * (tiles.ends_with("doubled") ? 2 : 1));
        EXPECT_EQ(certify_texture(texture.set).exceptions, 0u);
    }
}

TEST(TextureBuild, IsTheSameOnAnyNumberOfThreads)
{
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang}) {
        const TextureRequest request = small_request(kind, 2);
        const BuiltTexture many = built(request);
        const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
        const BuiltTexture one = built(request);
        EXPECT_EQ(one.set.sources, many.set.sources);
        EXPECT_EQ(one.set.values, many.set.values);
        EXPECT_EQ(one.cost, many.cost);
        TextureRequest other = request;
        other.seed = 2;
        EXPECT_NE(built(other).set.sources, many.set.sources);
    }
}

TEST(TextureBuild, TakesWindowsThatAreAsFarApartAsAsked)
{
    TextureRequest request = small_request(TextureKind::corner, 2);
    request.diversity = 6;
    const std::vector<ExemplarWindow> windows = built(request).windows;
    EXPECT_EQ(windows.size(), 2u + 8 + 16);
    for (std::size_t i = 0; i < windows.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto middle = [](int corner, int size) { return corner + size / 2.0; };
            const ExemplarWindow &a = windows[i], &b = windows[j];
            EXPECT_GE(std::max(std::abs(middle(a.x, a.size) - middle(b.x, b.size)),
                               std::abs(middle(a.y, a.size) - middle(b.y, b.size))),
                      6);
        }
    request.diversity = 20;
    EXPECT_EQ(message_of([&] { built(request); }),
              "diversity = 20: 26 windows are needed, of which 4 are sure to fit into an exemplar of 120 x 110 pixels");
}

/// Minimum cuts of a picture without differences have no 0 / 0, and cost 1 a pair.
TEST(TextureBuild, TakesPicturesOfOneColor)
{
    const PngPixels grey{80, 80, 3, std::vector<std::uint8_t>(80 * 80 * 3, 90)};
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang}) {
        const BuiltTexture texture = build_texture(small_request(kind, 2), grey, go_on);
        EXPECT_EQ(certify_texture(texture.set).tile_pairs, 128u * (kind == TextureKind::wang ? 2 : 1));
        EXPECT_EQ(std::ranges::count(texture.set.values, 90), 16 * 32 * 32 * 3);
    }
}

/// On gravel, with plain weights, seams differ by less than 1.25 of what neighbours do anyway; three stages do better
/// than one, which leaves the joints of patches at the middles of edges.
TEST(TextureBuild, HidesSeamsInGravel)
{
    const PngPixels gravel = read_exemplar(source_folder() + "/configs/exemplars/gravel.png");
    TextureRequest request;
    request.weight = SeamWeight::plain;
    const double three = seam_measures(build_texture(request, gravel, go_on).set).mismatch;
    request.stages = 1;
    const double one = seam_measures(build_texture(request, gravel, go_on).set).mismatch;
    EXPECT_LT(three, 1.25);
    EXPECT_LT(three, one);
}

TEST(TextureBuild, EndsWhenProgressThrows)
{
    const auto stop = [](const std::string&, std::size_t, std::size_t) { throw std::runtime_error("enough"); };
    EXPECT_EQ(
        message_of<std::runtime_error>([&] { build_texture(small_request(TextureKind::corner, 2), noise(), stop); }),
        "enough");
}

TEST(TextureBuild, SmoothsWithoutTouchingTheRing)
{
    TextureRequest request = small_request(TextureKind::corner, 2);
    const BuiltTexture plain = built(request);
    request.smooth = true;
    const BuiltTexture smoothed = built(request);
    EXPECT_EQ(certify_texture(smoothed.set).exceptions, 0u);
    EXPECT_EQ(smoothed.set.sources, plain.set.sources);
    EXPECT_NE(smoothed.set.values, plain.set.values);
}

TEST(TextureBuild, RefusesWhatCannotBe)
{
    const auto refusal = [](auto change) {
        TextureRequest request = small_request(TextureKind::corner, 3);
        change(request);
        return message_of([&] { built(request); });
    };
    EXPECT_EQ(refusal([](auto& r) { r.size = 31; }), "size = 31: must be even");
    EXPECT_EQ(refusal([](auto& r) { r.size = 8; }), "size = 8: must be an integer from 16 to 512");
    EXPECT_EQ(refusal([](auto& r) { r.size = 256; }), "size = 256: must be at most the exemplar's, 120 x 110 pixels");
    EXPECT_EQ(refusal([](auto& r) { r.ring = 6; }), "ring = 6: must be an integer from 1 to 5");
    EXPECT_EQ(refusal([](auto& r) { r.stages = 2; }), "stages = 2: must be 0, 1 or 3");
    EXPECT_EQ(refusal([](auto& r) { r.colors = {9, 9}; }), "colors = 9: must be an integer from 2 to 8");
    EXPECT_EQ(refusal([](auto& r) { r.colors = {2, 3}; }), "vertical_colors = 3: is for compact Wang tiles");
    EXPECT_EQ(refusal([](auto& r) { r.tiles = "compact"; }), "tiles = compact: must be one of complete");
    EXPECT_EQ(refusal([](auto& r) { r.kind = TextureKind::omega; }), "colors = 3: must be 4 for omega tiles");
    EXPECT_EQ(refusal([](auto& r) { r.core = 0.5; }), "core = 0.5: must be a number from 0 to 0.4");
    EXPECT_EQ(refusal([](auto& r) {
                  r.colors = {8, 8}, r.size = 512;
              }),
              "size = 512: all tiles have 1073741824 pixels: must be at most 268435456");
}

/// Ng and others 2005, section 4.2: a row's first tile has two choices, all others one; a tile is never beside itself.
TEST(OmegaTiles, HaveTheChoicesThatTheArticleSays)
{
    for (const std::string name : {"16", "16b", "16b-doubled", "32"}) {
        const std::size_t variants = name.starts_with("16") && !name.ends_with("doubled") ? 1 : 2;
        TextureRequest request = small_request(TextureKind::omega, 4);
        request.tiles = name;
        std::set<TileIndex> different;
        for (const TextureTile& tile : requested_tiles(request)) different.insert(tile.index);
        EXPECT_EQ(requested_tiles(request).size(), 16 * variants);
        const std::vector<TileIndex> indices(different.begin(), different.end());
        const FittingTiles fitting({TileKind::corner, {4, 4}, indices});
        for (const TileIndex north : indices) {
            EXPECT_EQ(fitting.choices(&north, nullptr).size(), 2u);
            for (const TileIndex west : fitting.choices(nullptr, &north)) EXPECT_NE(west, north);
            for (const TileIndex west : indices) {
                const CornerTile n = corner_tile(north, 4), w = corner_tile(west, 4);
                if (n.south_west != w.north_east) continue;
                EXPECT_EQ(fitting.choices(&north, &west).size(), 1u) << name << " " << north << " " << west;
            }
        }
    }
}

TEST(Exemplar, IsReadAsItsBytesAre)
{
    const TemporaryFolder folder;
    for (const int channels : {1, 3}) {
        const PngPixels picture = test::random_picture(37, 23, channels, 9);
        const auto file = folder.path() / "a.png";
        write_png(file, {37, 23, channels}, [&](int row, int) { return &picture.values[picture.at(0, row, 0)]; });
        const PngPixels exemplar = read_exemplar(file);
        EXPECT_EQ(exemplar.channels, channels);
        EXPECT_EQ(exemplar.values, picture.values);
    }
    // Bytes that are read as they are, beside those that became light.
    PngPixels all{16, 16, 1, {}};
    RawPicture opaque{16, 16, SampleType::byte, {"Y", "A"}, {}};
    for (int value = 0; value < 256; ++value) {
        all.values.push_back(static_cast<std::uint8_t>(value));
        opaque.bytes.insert(opaque.bytes.end(), {static_cast<std::uint8_t>(value), 255});
    }
    write_raw_picture(folder.path() / "opaque.png", opaque);
    EXPECT_EQ(read_exemplar(folder.path() / "opaque.png").values, all.values);
    // 16 bits: each byte twice is the same level.
    const PngPixels picture = test::random_picture(20, 20, 3, 10);
    DeepPixels deep{20, 20, 3, {}};
    for (const std::uint8_t value : picture.values) deep.values.push_back(static_cast<std::uint16_t>(value * 257));
    write_deep_png(folder.path() / "deep.png", deep);
    EXPECT_EQ(read_exemplar(folder.path() / "deep.png").values, picture.values);
    EXPECT_EQ(read_deep_png(folder.path() / "deep.png").values, deep.values);
    // Alpha is left out, with a word, unless it covers.
    const PngPixels translucent = test::random_picture(5, 4, 2, 11);
    write_png(folder.path() / "alpha.png", {5, 4, 2},
              [&](int row, int) { return &translucent.values[translucent.at(0, row, 0)]; });
    std::string note;
    EXPECT_EQ(read_exemplar(folder.path() / "alpha.png", note).channels, 1);
    std::size_t clear = 0;
    for (std::size_t i = 1; i < translucent.values.size(); i += 2) clear += translucent.values[i] < 255;
    EXPECT_EQ(note, "alpha.png: alpha is left out: " + std::to_string(clear) +
                        " pixels are not opaque, and their colour beneath counts");
    write_raw_picture(folder.path() / "marks.png", {2, 1, SampleType::byte, {"Y", "A"}, {255, 0, 255, 255}});
    EXPECT_EQ(read_exemplar(folder.path() / "marks.png").values, (std::vector<std::uint8_t>{255, 255}));
    EXPECT_EQ(read_exemplar(folder.path() / "marks.png", AlphaUse::covers).values, (std::vector<std::uint8_t>{0, 255}));
    EXPECT_THAT(message_of([&] { read_exemplar(folder.path() / "no.png"); }), HasSubstr("no.png: cannot read"));
}

}
}
