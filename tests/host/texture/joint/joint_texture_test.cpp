// Sets that are chosen together: pixels that tiles share, costs that do not rise, tiles that fit.
#include "host/texture/joint/assembly.hpp"
#include "host/texture/joint/feature_map.hpp"
#include "host/texture/joint/site_move.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/errors.hpp"
#include "tiles/texture/texture_certificate.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace poissonlab {
namespace {

using testing::HasSubstr;

void never_mind(const std::string&, std::size_t, std::size_t) {}

TextureRequest joint_request(TextureKind kind, Color colors)
{
    TextureRequest request;
    request.kind = kind;
    request.colors = {colors, colors};
    request.size = 32;
    request.candidates = 2;
    request.joint = true;
    request.rounds = 4;
    return request;
}

const PngPixels& grains()
{
    static const PngPixels picture = test::random_picture(120, 110, 1, 7);
    return picture;
}

/// Numbers by the papers' words alone: pixels of two tiles are one exactly where the colours that they share say so.
TEST(SetCover, SharesWhatColorsShare)
{
    const TextureRequest request = joint_request(TextureKind::corner, 2);
    const std::vector<TextureTile> tiles = requested_tiles(request);
    const SetCover cover(set_parts(request, tiles), 32, 2);
    std::map<std::size_t, std::tuple<int, int, int, int>> known; // by number: which colours, and the place beside them
    std::set<std::tuple<int, int, int, int>> all;
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
        const CornerTile t = corner_tile(tiles[tile].index, 2);
        const auto color = [&](bool is_south, bool is_east) {
            return static_cast<int>(is_south ? (is_east ? t.south_east : t.south_west)
                                             : (is_east ? t.north_east : t.north_west));
        };
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const bool is_beside_x = x < 2 || x >= 30, is_beside_y = y < 2 || y >= 30;
                const int from_x = x < 16 ? x : x - 32, from_y = y < 16 ? y : y - 32;
                std::tuple<int, int, int, int> what{3, static_cast<int>(tile), x, y};
                if (is_beside_x && is_beside_y)
                    what = {0, color(y >= 16, x >= 16), from_x, from_y};
                else if (is_beside_x)
                    what = {1, 2 * color(false, x >= 16) + color(true, x >= 16), from_x, y};
                else if (is_beside_y)
                    what = {2, 2 * color(y >= 16, false) + color(y >= 16, true), x, from_y};
                const std::size_t number = cover.pixel(tile, x, y);
                ASSERT_LT(number, cover.pixels());
                const auto [place, is_new] = known.insert({number, what});
                EXPECT_EQ(place->second, what);
                all.insert(what);
            }
    }
    EXPECT_EQ(known.size(), all.size());
    EXPECT_EQ(known.size(), cover.pixels());
}

TEST(SetCover, GoesOnBeyondBorders)
{
    const TextureRequest request = joint_request(TextureKind::corner, 2);
    const std::vector<TextureTile> tiles = requested_tiles(request);
    const SetCover cover(set_parts(request, tiles), 32, 2);
    for (std::size_t a = 0; a < tiles.size(); ++a)
        for (std::size_t b = 0; b < tiles.size(); ++b) {
            const CornerTile one = corner_tile(tiles[a].index, 2), other = corner_tile(tiles[b].index, 2);
            if (one.north_east == other.north_west && one.south_east == other.south_west) {
                for (int y = 0; y < 32; ++y) EXPECT_EQ(cover.pixel(a, 32, y), cover.pixel(b, 0, y));
            }
            if (one.south_west == other.north_west && one.south_east == other.north_east) {
                for (int x = 0; x < 32; ++x) EXPECT_EQ(cover.pixel(a, x, 32), cover.pixel(b, x, 0));
            }
        }
}

/// Kwatra's cost of two windows is a distance: the way over a third one is not shorter.
TEST(Assembly, SeamsObeyTheTriangleInequality)
{
    const TextureRequest request = joint_request(TextureKind::corner, 2);
    const SetCover cover(set_parts(request, requested_tiles(request)), 32, 2);
    const PngPixels picture = test::random_picture(20, 20, 3, 5);
    const Assembly assembly(picture, cover, {});
    std::mt19937 random(3);
    const auto source = [&] {
        return SourcePixel{static_cast<std::uint16_t>(random() % 20), static_cast<std::uint16_t>(random() % 20)};
    };
    for (int i = 0; i < 2000; ++i) {
        const SourcePixel p = source(), q = source();
        // A third window, which shows (x, y) at p and (x + 1, y) at q.
        const SourcePixel third{static_cast<std::uint16_t>(random() % 19), static_cast<std::uint16_t>(random() % 20)};
        const SourcePixel beside{static_cast<std::uint16_t>(third.x + 1), third.y};
        EXPECT_EQ(assembly.seam_cost(third, beside, Neighbour::east), 0);
        EXPECT_LE(assembly.seam_cost(p, q, Neighbour::east),
                  assembly.seam_cost(p, beside, Neighbour::east) + assembly.seam_cost(third, q, Neighbour::east));
    }
}

/// Levels cost what they are in parts of the mean step in their direction: rows that repeat are dear to break.
TEST(Assembly, WeighsDirectionsByTheirSteps)
{
    const TextureRequest request = joint_request(TextureKind::corner, 2);
    const SetCover cover(set_parts(request, requested_tiles(request)), 32, 2);
    // Levels 8 x + y: steps of 8 to the east and of 1 to the south. Two windows that differ by 16 levels.
    PngPixels ramp{20, 20, 1, {}};
    for (int i = 0; i < 400; ++i) ramp.values.push_back(static_cast<std::uint8_t>(8 * (i % 20) + i / 20));
    const Assembly assembly(ramp, cover, {});
    const auto cost = [&](SourcePixel p, SourcePixel q, Neighbour neighbour) {
        return static_cast<double>(assembly.seam_cost(p, q, neighbour) - Assembly::seam_unit) / Assembly::seam_unit;
    };
    const double east = cost({5, 5}, {8, 5}, Neighbour::east), south = cost({5, 5}, {7, 6}, Neighbour::south);
    EXPECT_NEAR(east, 32 / std::sqrt(8.0), 32.0 / (2 * Assembly::seam_unit)); // weights are rounded
    EXPECT_NEAR(south, 32 * std::sqrt(8.0), 32.0 / (2 * Assembly::seam_unit));
}

/// Large windows, small ones, and after four rounds of each of three sizes large ones again make seams cheaper, whose
/// cost may rise in single rounds in favour of what repeats.
TEST(JointTexture, GainsByRounds)
{
    TextureRequest request = joint_request(TextureKind::corner, 2);
    std::int64_t before = std::numeric_limits<std::int64_t>::max();
    for (const int rounds : {1, 8, 13}) {
        request.rounds = rounds;
        const std::int64_t cost = build_texture(request, grains(), never_mind).cost;
        EXPECT_LT(cost, before) << rounds;
        before = cost;
    }
}

/// A move says of its gain what the whole set's costs say, added up anew, at every kind of site.
TEST(SiteMove, GainsWhatAllCostsSay)
{
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang}) {
        const TextureRequest request = joint_request(kind, 2);
        const SetCover cover(set_parts(request, requested_tiles(request)), 32, 2);
        const PngPixels picture = test::random_picture(60, 60, 3, 5);
        Assembly::Weights weights;
        weights.lines = 30;
        Assembly assembly(picture, cover, weights);
        std::mt19937 random(11);
        for (std::size_t i = 0; i < cover.pixels(); ++i)
            assembly.show(i, {static_cast<std::uint16_t>(random() % 60), static_cast<std::uint16_t>(random() % 60)});
        assembly.count_tiles();
        for (const Site& site : sites_of(cover)) {
            const SiteMove move(assembly, site, {-8, -8, 16});
            const SiteChange change = move.best({20 + static_cast<int>(random() % 20), 30});
            const double before = assembly.cost(),
                         foreseen = static_cast<double>(change.seam_gain) + assembly.sums_gain(change.pixels);
            const std::int64_t seams = assembly.seams();
            assembly.change(change.pixels);
            EXPECT_FALSE(change.pixels.empty()); // white noise has seams everywhere
            EXPECT_EQ(seams - assembly.seams(), change.seam_gain);
            EXPECT_NEAR(before - assembly.cost(), foreseen, 1e-9 * before);
            const auto sums = assembly.sums();
            const std::int64_t squares = assembly.squares();
            assembly.count_tiles();
            EXPECT_EQ(assembly.sums(), sums);
            EXPECT_EQ(assembly.squares(), squares);
        }
    }
}

TEST(JointTexture, MakesTilesThatFit)
{
    const TextureRequest request = joint_request(TextureKind::corner, 2);
    const TextureCertificate proof = certify_texture(build_texture(request, grains(), never_mind).set);
    EXPECT_EQ(proof.tile_pairs, 128u); // each of 16 tiles has 4 that fit to its east, and to its north
    EXPECT_EQ(proof.exceptions, 0u);
}

/// The corner problem: Cohen's tiles do not fit there (TextureBuild.MakesWangTilesThatFitButAtCorners).
TEST(JointTexture, MakesWangTilesThatFitAtCorners)
{
    for (const std::string tiles : {"complete", "compact"}) {
        TextureRequest request = joint_request(TextureKind::wang, 2);
        request.tiles = tiles;
        const TextureCertificate proof = certify_texture(build_texture(request, grains(), never_mind).set);
        EXPECT_GT(proof.tile_pairs, 0u);
        EXPECT_EQ(proof.exceptions, 0u);
    }
}

TEST(JointTexture, CostsLessThanOnePieceAfterAnother)
{
    TextureRequest request = joint_request(TextureKind::corner, 2);
    const std::int64_t together = build_texture(request, grains(), never_mind).cost;
    request.joint = false;
    const TextureSet one_by_one = build_texture(request, grains(), never_mind).set;
    const SetCover cover(set_parts(request, one_by_one.tiles), one_by_one.size, one_by_one.ring);
    Assembly assembly(grains(), cover, {});
    for (std::size_t tile = 0; tile < one_by_one.tiles.size(); ++tile)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                assembly.show(cover.pixel(tile, x, y),
                              one_by_one.sources_of(tile)[static_cast<std::size_t>(y * 32 + x)]);
    EXPECT_LT(together, assembly.seams());
}

TEST(JointTexture, IsTheSameOnAnyNumberOfThreads)
{
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang}) {
        const TextureRequest request = joint_request(kind, 2);
        const auto sources = [&](int threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threads));
            tbb::task_arena arena(threads);
            return arena.execute([&] { return build_texture(request, grains(), never_mind).set.sources; });
        };
        EXPECT_EQ(sources(1), sources(4)) << texture_kinds[kind];
    }
}

/// Windows that others cover are not counted, but for patches.
TEST(JointTexture, CountsWindowsThatAreShown)
{
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang}) {
        const BuiltTexture built = build_texture(joint_request(kind, 2), grains(), never_mind);
        EXPECT_EQ(built.patches, kind == TextureKind::corner ? 2u : 1u);
        for (std::size_t i = built.patches; i < built.windows.size(); ++i)
            EXPECT_TRUE(std::ranges::any_of(built.set.sources, [&](const SourcePixel& source) {
                const ExemplarWindow& window = built.windows[i];
                return source.x >= window.x && source.x < window.x + window.size && source.y >= window.y &&
                       source.y < window.y + window.size;
            }));
    }
}

TEST(JointTexture, SaysWhatWasUsed)
{
    const auto parameters = parameters_of(joint_request(TextureKind::wang, 2));
    EXPECT_EQ(parameters.at("joint"), "true");
    EXPECT_EQ(parameters.at("rounds"), "4");
    EXPECT_EQ(parameters.at("candidates"), "2");
    EXPECT_EQ(parameters.at("core"), "0.36");
    EXPECT_FALSE(parameters.contains("overlap") || parameters.contains("cut"));
    TextureRequest request = joint_request(TextureKind::wang, 2);
    request.joint = false;
    EXPECT_FALSE(parameters_of(request).contains("joint"));
    EXPECT_TRUE(parameters_of(request).contains("overlap"));
}

TEST(ChangedRuns, AreThePixelsAgain)
{
    std::vector<ChangedPixel> pixels;
    for (std::size_t i = 0; i < 8; ++i)
        pixels.push_back({100 + i, {static_cast<std::uint16_t>(i), 3}, 4 + static_cast<int>(i), 5, i < 6 ? 1 : 2});
    pixels[3].source.y = 9; // runs of 3, 1, 2, 2
    const std::vector<ChangedRun> runs = runs_of(pixels);
    EXPECT_EQ(runs.size(), 4u);
    EXPECT_EQ(pixels_of(runs), pixels);
    EXPECT_TRUE(runs_of({}).empty());
}

TEST(JointTexture, TakesPicturesOfOneColor)
{
    const PngPixels grey{64, 64, 1, std::vector<std::uint8_t>(64 * 64, 90)};
    const TextureSet set = build_texture(joint_request(TextureKind::corner, 2), grey, never_mind).set;
    EXPECT_EQ(std::set<std::uint8_t>(set.values.begin(), set.values.end()), std::set<std::uint8_t>{90});
}

TEST(JointTexture, RefusesWhatItDoesNotDo)
{
    const auto message = [](auto change) {
        TextureRequest request = joint_request(TextureKind::corner, 2);
        change(request);
        return message_of([&] { build_texture(request, grains(), never_mind); });
    };
    EXPECT_THAT(message([](TextureRequest& r) { r.stages = 1; }), HasSubstr("joint = true"));
    EXPECT_THAT(message([](TextureRequest& r) { r.weight = SeamWeight::gradient; }), HasSubstr("joint = true"));
    EXPECT_THAT(message([](TextureRequest& r) { r.smooth = true; }), HasSubstr("joint = true"));
    EXPECT_THAT(message([](TextureRequest& r) { r.rounds = 0; }), HasSubstr("rounds = 0"));
    EXPECT_THAT(message([](TextureRequest& r) { r.split = 40; }), HasSubstr("joint = true"));
}

/// A step from 50 to 150 in the third column: derivatives from left to right have their sign there, others none.
TEST(FeatureMap, HasSlopesBesideColors)
{
    PngPixels step{8, 8, 1, {}};
    for (int i = 0; i < 64; ++i) step.values.push_back(i % 8 < 3 ? 50 : 150);
    const PngPixels features = feature_map(step, 0.5);
    ASSERT_EQ(features.channels, 5);
    for (int y = 0; y < 8; ++y) {
        EXPECT_EQ(features.values[features.at(1, y, 0)], 50);
        EXPECT_GT(features.values[features.at(2, y, 1)], 128);
        EXPECT_EQ(features.values[features.at(6, y, 1)], 128);
        EXPECT_EQ(features.values[features.at(2, y, 2)], 128);
    }
    EXPECT_EQ(feature_map(step, 0).values, step.values);
}

}
}
