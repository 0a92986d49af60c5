// Schemes of aperiodic sets, isohedral tilings and surfaces.
#include "host/schemes/scheme_run.hpp"

#include "results/pictures/mark_picture.hpp"
#include "tests/support/exhibits.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class AperiodicSchemes : public testing::Test
{
protected:
    DistributionResult made(const auto& settings) { return made_of(settings, 1, folder_.path()); }

    static double number_of(const DistributionResult& result, const std::string& key)
    {
        for (const DistributionNumber& entry : result.numbers)
            if (entry.key == key) return entry.value;
        ADD_FAILURE() << "no number " << key;
        return 0;
    }

    TemporaryFolder folder_;
};

TEST_F(AperiodicSchemes, ConstructionsHaveAsManyCornerTilesAsLieOverTheWindow)
{
    const std::vector<std::pair<CornerConstruction, int>> counts{{CornerConstruction::diagonal, 3 * 2},
                                                                 {CornerConstruction::horizontal, 3 * 3},
                                                                 {CornerConstruction::vertical, 4 * 2},
                                                                 {CornerConstruction::subdivision, 4 * 12},
                                                                 {CornerConstruction::rotation, 12 + 3 * 2}};
    for (const char* const set : {"ammann", "kari", "culik"})
        for (const auto& [construction, count] : counts)
            EXPECT_THAT(made(ConstructionSettings{set, construction, 4, 3}).facts,
                        testing::Contains(std::to_string(count) + " corner tiles"))
                << set;
}

TEST_F(AperiodicSchemes, TablesAreThoseOfTheDissertationAndItsSmallestSetRepeats)
{
    const DistributionResult result = made(AperiodicTableSettings{3});
    EXPECT_GT(number_of(result, "numbers"), 100);
    EXPECT_EQ(number_of(result, "same"), number_of(result, "numbers"));
    EXPECT_EQ(number_of(result, "unavailable"), 35) << "all of the set 32/16";
    EXPECT_EQ(number_of(result, "claimed_tiles"), 44);
    EXPECT_EQ(number_of(result, "claimed_period_width"), 2);
    EXPECT_EQ(number_of(result, "claimed_period_height"), 3);
    EXPECT_EQ(number_of(result, "smallest_tiles"), 49);
    ASSERT_EQ(result.tables.size(), 6);
    ASSERT_EQ(result.pictures.size(), 1) << "the torus";
    EXPECT_THAT(result.tables[0].rows,
                testing::Contains(std::vector<std::string>{"14/6", "4", "1213029/58910", "1213029/58910", "the same"}));
    EXPECT_THAT(result.tables[0].rows,
                testing::Contains(std::vector<std::string>{"32/16", "1", "114/32 [84]", "not available", "-"}));
}

TEST_F(AperiodicSchemes, AperiodicTilingsHavePeaksAndStochasticOnesHaveNot)
{
    DiffractionSettings settings;
    settings.size = 256;
    TilingRequest stochastic, ammann;
    stochastic.kind = ammann.kind = TileKind::wang;
    stochastic.algorithm = "scanline-compact";
    ammann.algorithm = "ammann";
    ammann.colors = 6;
    settings.tilings = {stochastic, ammann};
    const DistributionResult result = made(settings);
    // 65,535 powers, exponentially distributed: the highest is below 11.1 + 6.9 but once in a thousand.
    EXPECT_LT(number_of(result, "peak_scanline-compact"), 18);
    EXPECT_GT(number_of(result, "peak_ammann"), 1000);
    EXPECT_GT(number_of(result, "strongest_ammann"), 0.5);
    EXPECT_EQ(result.pictures.size(), 6);
    EXPECT_EQ(result.tables.at(0).rows.size(), 2);
}

TEST_F(AperiodicSchemes, SurfacesOfPolycubesAreTiledWithoutAMismatch)
{
    const DistributionResult cube = made(SurfaceSettings{{{0, 0, 0}}, 4});
    EXPECT_EQ(number_of(cube, "mismatches"), 0);
    EXPECT_EQ(number_of(cube, "irregular"), 8);
    EXPECT_EQ(number_of(cube, "euler"), 2);
    SurfaceSettings ring;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            if (x != 1 || y != 1) ring.cubes.push_back({x, y, 0});
    const DistributionResult torus = made(ring);
    EXPECT_EQ(number_of(torus, "mismatches"), 0);
    EXPECT_EQ(number_of(torus, "euler"), 0);
    EXPECT_EQ(number_of(torus, "crowded"), 0);
    EXPECT_EQ(number_of(torus, "irregular"), 16); // 8 outer corners with 3 faces, 8 inner ones with 5
    EXPECT_EQ(number_of(made(SurfaceSettings{{{0, 0, 0}, {1, 1, 0}}, 2}), "crowded"), 1);
}

TEST_F(AperiodicSchemes, IsohedralTilesFillThePlane)
{
    for (const int type : {1, 16, 28, 61, 93}) {
        IsohedralSettings settings;
        settings.type = type;
        settings.is_random = true;
        const DistributionResult result = made(settings);
        EXPECT_NEAR(number_of(result, "unit_over_tiles"), 1, 1e-9) << type;
        EXPECT_THAT(result.facts, testing::Contains("neighbours differ in colour")) << type;
        settings.coloring = TileColoring{1, std::vector<std::uint32_t>(12), {0, 0}};
        EXPECT_THAT(made(settings).facts, testing::Contains("some neighbours have the same colour")) << type;
    }
    IsohedralSettings divided;
    divided.type = 41;
    divided.split.emplace();
    const DistributionResult result = made(divided);
    EXPECT_EQ(number_of(result, "colors"), 2);
    EXPECT_THAT(result.facts, testing::Not(testing::Contains(testing::HasSubstr("colour"))));
}

/// An L of three squares with a hole tiles by half turns, IH4: the report says so, and each tile has the hole.
TEST_F(AperiodicSchemes, IsohedralTilesLookLikeAGoal)
{
    IsohedralSettings settings;
    settings.type = 4;
    settings.goal = "path evenodd M 0 0 2 0 2 1 1 1 1 2 0 2 Z M 0.4 0.4 0.6 0.4 0.6 0.6 Z";
    settings.columns = settings.rows = 4;
    const DistributionResult result = made(settings);
    EXPECT_LT(number_of(result, "step_distance"), 0.01);
    EXPECT_LT(number_of(result, "turning_distance"), 5); // degrees
    EXPECT_NEAR(number_of(result, "unit_over_tiles"), 1, 1e-9);
    EXPECT_THAT(result.files, testing::ElementsAre("tile.csv", "numbers.csv"));
    ASSERT_EQ(result.pictures.size(), 2);
    EXPECT_EQ(result.pictures[0].file, "tiling.json");
    std::size_t holes = 0, tiles = 0;
    for (const MarkGroup& group : read_mark_picture(folder_.path() / "tiling.json").groups)
        for (const auto& polygon : group.polygons) ++(polygon.size() == 3 ? holes : tiles);
    EXPECT_EQ(holes, tiles);
    EXPECT_GE(tiles, 16);
    settings.type.reset();
    settings.goal = "disk 0 0 1";
    const DistributionResult disk = made(settings);
    EXPECT_GT(number_of(disk, "candidates"), 2'000'000);
    EXPECT_GT(number_of(disk, "step_distance"), 0.01); // no disks fill the plane
    ASSERT_EQ(disk.tables.size(), 1);
    EXPECT_EQ(disk.tables[0].rows.size(), 10);
}

}
}
