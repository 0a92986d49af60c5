// Schemes of tilings: what they count and draw.
#include "host/schemes/scheme_run.hpp"

#include "base/images/png_file.hpp"
#include "host/distribution/tabled_noise.hpp"
#include "host/schemes/perlin_noise.hpp"
#include "tests/support/exhibits.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/tilings/permutation_hash.hpp"
#include "tiles/tilings/tile_shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

class Schemes : public testing::Test
{
protected:
    DistributionResult made(const auto& settings, std::uint64_t seed = 1)
    {
        return made_of(settings, seed, folder_.path());
    }

    MarkPicture picture(const std::string& name) const { return read_mark_picture(folder_.path() / name); }

    static double number(const DistributionResult& result, const std::string& key)
    {
        for (const DistributionNumber& entry : result.numbers)
            if (entry.key == key) return entry.value;
        ADD_FAILURE() << "no number " << key;
        return 0;
    }

    static std::size_t disks(const MarkPicture& picture)
    {
        std::size_t count = 0;
        for (const MarkGroup& group : picture.groups) count += group.disks.size();
        return count;
    }

    TemporaryFolder folder_;
};

TEST_F(Schemes, AnyTwoWangTilesLieDiagonallyAndOneInSoManyCornerTiles)
{
    for (const Color colors : {2U, 3U}) {
        const DistributionResult result = made(CornerProblemSettings{colors});
        EXPECT_EQ(number(result, "wang_pairs"), 1);
        EXPECT_DOUBLE_EQ(number(result, "corner_pairs"), 1.0 / colors); // the common corner has one of so many colours
        EXPECT_EQ(result.pictures.size(), 3);
    }
    EXPECT_EQ(number(made(CornerProblemSettings{2}), "compact_wang_pairs"), 1);
}

/// Each colour is that of a side of 2 C tiles of the compact set. At most, no tile has both colours; of two colours,
/// each tile of a pair for the same neighbours has another one in the south, so that two tiles have both.
TEST_F(Schemes, ObjectsAcrossCornersAreInSixOfEightAndInTwelveOfEighteenWangTiles)
{
    EXPECT_EQ(number(made(CornerProblemSettings{2}), "adapted_tiles"), 6);
    for (const Color colors : {3U, 4U})
        EXPECT_EQ(number(made(CornerProblemSettings{colors}), "adapted_tiles"), 4 * colors);
}

TEST_F(Schemes, ScanlinesHaveAsManyChoicesAsTheyShould)
{
    struct Case
    {
        TileKind kind;
        Color colors;
        bool is_compact;
        std::vector<int> choices; ///< first tile, first row, first column, inside
    };
    // The complete set has as many as there are colours for the sides or corners that are still free.
    const std::vector<Case> cases{
        {TileKind::wang, 2, true, {8, 4, 4, 2}},     {TileKind::wang, 3, true, {18, 6, 6, 2}},
        {TileKind::wang, 3, false, {81, 27, 27, 9}}, {TileKind::corner, 3, true, {54, 6, 6, 2}},
        {TileKind::corner, 2, false, {16, 4, 4, 2}}, {TileKind::corner, 3, false, {81, 9, 9, 3}}};
    for (const Case& c : cases) {
        const DistributionResult result = made(ScanlineStepsSettings{c.kind, c.colors, c.is_compact});
        EXPECT_EQ(number(result, "tiles"), c.choices[0]);
        EXPECT_EQ(number(result, "fewest_choices"), c.choices[3]);
        ASSERT_EQ(result.pictures.size(), 4);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_THAT(result.pictures[i].caption, testing::HasSubstr(" " + std::to_string(c.choices[i]) + " fit"));
    }
}

TEST_F(Schemes, LatticesHaveThePointsThatTilesNeed)
{
    const auto lattice_of = [&](const std::string& algorithm) {
        DirectTilingSettings settings;
        settings.request.algorithm = algorithm;
        settings.request.kind = algorithm == "direct" ? TileKind::corner : TileKind::wang;
        settings.window = {-2, 5, 5, 3};
        made(settings);
        return picture("lattice.json");
    };
    // A point is a coloured disk on a black one; with two hash functions two halves are on it; points that are left out
    // are one disk.
    EXPECT_EQ(disks(lattice_of("direct")), 2 * 6 * 4);
    EXPECT_EQ(disks(lattice_of("one-hash")), 2 * 6 * 4);
    EXPECT_EQ(disks(lattice_of("two-hashes")), 6 * 4);
    const std::size_t edges = 5 * 4 + 6 * 3;
    EXPECT_EQ(disks(lattice_of("edge-hash")), 2 * edges + (11 * 7 - edges));
}

TEST_F(Schemes, NoiseHasThePeriodsOfTheDissertation)
{
    const DistributionResult result = made(NoiseSettings{64, 4});
    EXPECT_EQ(number(result, "long_period"), 739'024);
    EXPECT_EQ(number(result, "long_entries"), 76);
    EXPECT_EQ(number(result, "plain_period"), 256);
    EXPECT_NEAR(number(result, "plain_repeat"), 1, 1e-12);
    EXPECT_LT(std::abs(number(result, "long_repeat")), 0.9);
    EXPECT_LT(number(result, "parts_of_large"), 0.05); // at most 4 of a mean distance of 62.7
    EXPECT_GT(number(result, "parts_of_small"), 0.5);
    EXPECT_EQ(result.pictures.size(), 2);
}

TEST_F(Schemes, CostsCountHashEvaluations)
{
    const DistributionResult result = made(TilingCostSettings{2, 4096});
    EXPECT_EQ(number(result, "corner_evaluations"), 4);
    EXPECT_EQ(number(result, "two_hashes_evaluations"), 8);
    EXPECT_EQ(number(result, "one_hash_evaluations"), 4);
    EXPECT_EQ(number(result, "edge_hash_evaluations"), 4);
    EXPECT_EQ(number(result, "period"), 5'930'659'848.0);
    EXPECT_EQ(number(result, "entries"), 180);
    EXPECT_GT(number(result, "scanline_wang_ns"), 0);
    // D 3.2.1 and 3.2.2 list the sizes for 2 to 8 colours; of compact Wang sets 72 is left out there.
    std::vector<std::string> wang, corner;
    for (const auto& row : result.tables.at(0).rows) {
        wang.push_back(row[1]);
        corner.push_back(row[2]);
    }
    EXPECT_THAT(wang, testing::ElementsAre("8", "18", "32", "50", "72", "98", "128"));
    EXPECT_THAT(corner, testing::ElementsAre("16", "54", "128", "250", "432", "686", "1024"));
}

/// The permutation of Perlin's own program (Improving noise, 2002).
constexpr std::array<std::uint8_t, 256> perlins_permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,  69,  142,
    8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,  94,  252, 219, 203,
    117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136, 171, 168, 68,  175, 74,  165,
    71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,
    55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,
    18,  169, 200, 196, 135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250,
    124, 123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189,
    28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,
    129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,
    242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114,
    67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

TEST(PerlinNoise, IsThatOfPerlinsProgram)
{
    const PermutationHash hash(256, {perlins_permutation.begin(), perlins_permutation.end()});
    EXPECT_NEAR(perlin_noise(hash, 3.14, 42, 7), 0.13691995878400012, 1e-15); // the value that other programs agree on
    EXPECT_EQ(perlin_noise(hash, -3, 42, 7), 0);
    EXPECT_EQ(perlin_noise(hash, 0.25, 0.5, 0.75), perlin_noise(hash, 256.25, -255.5, 512.75));
}

/// Look-ups that corners share are those of the hash function, to the last bit.
TEST(PerlinNoise, IsTheSameByATable)
{
    const PermutationHash hash(256, {perlins_permutation.begin(), perlins_permutation.end()});
    const TabledNoise noise(perlins_permutation);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-600, 600);
    for (int i = 0; i < 10'000; ++i) {
        const double x = place(random), y = place(random), z = place(random);
        ASSERT_EQ(noise.at(x, y, z), perlin_noise(hash, x, y, z)) << x << " " << y << " " << z;
    }
}

/// In the plane noise is 0 at lattice points, repeats after 256 cells, and at the middle of a cell is the mean of its
/// corners' slopes, each of which is the sum or difference of two halves.
TEST(PerlinNoise, InThePlaneIsMadeOfSlopes)
{
    const TabledNoise noise(perlins_permutation);
    for (int i = -300; i < 300; ++i) {
        EXPECT_EQ(noise.at(i, 3 * i), 0);
        EXPECT_EQ(noise.at(i + 0.25, 0.75 - i), noise.at(i + 256.25, 512.75 - i));
        const double middle = noise.at(i + 0.5, 2 * i + 0.5);
        EXPECT_EQ(middle * 4, std::round(middle * 4)) << i;
        EXPECT_LE(std::abs(middle), 1) << i;
    }
}

/// The texture has five colours in equal parts of the sphere: rows of pixels are narrower towards the poles.
TEST_F(Schemes, SphericalTilingsAreDrawnInEqualPartsOfTheirColors)
{
    const SphericalTileSettings settings{.curves = {{{0, 0}, {0.4, 0.1}, {1, 0}}, {{0, 0}, {0.6, -0.1}, {1, 0}}}};
    const DistributionResult result = made(settings);
    EXPECT_EQ(number(result, "tiles"), 60);
    EXPECT_EQ(number(result, "euler"), 2);
    EXPECT_EQ(number(result, "edges"), 180);
    EXPECT_EQ(number(result, "corners"), 122);
    EXPECT_NEAR(number(result, "area_over_sphere"), 1, 1e-12);
    const PngPixels texture = read_png(folder_.path() / "texture.png");
    std::map<std::array<int, 3>, double> areas;
    double whole = 0;
    for (int y = 0; y < texture.height; ++y)
        for (int x = 0; x < texture.width; ++x) {
            const double area = std::cos(((y + 0.5) / texture.height - 0.5) * std::numbers::pi);
            areas[{texture.values[texture.at(x, y, 0)], texture.values[texture.at(x, y, 1)],
                   texture.values[texture.at(x, y, 2)]}] += area;
            whole += area;
        }
    double colored = 0;
    for (Color color = 0; color < 5; ++color) {
        const auto byte = [&](std::size_t k) { return std::stoi(tile_color(color).substr(1 + 2 * k, 2), nullptr, 16); };
        const double share = areas[{byte(0), byte(1), byte(2)}] / whole;
        EXPECT_NEAR(share, 0.2, 0.02) << color; // less its lines
        colored += share;
    }
    EXPECT_GT(colored, 0.9);
    EXPECT_LT(colored, 1);
}

}
}
