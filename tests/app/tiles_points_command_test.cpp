// `poissonlab tiles points`: the file's points are those of the reference, in every format.
#include "base/images/png_file.hpp"
#include "base/points/point_file.hpp"
#include "host/tile_points/tile_points.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/monotile_points_file.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class TilesPointsCommand : public test::CommandTest
{
protected:
    TilesPointsCommand() : CommandTest("tiles points") { write_tile_set(folder_.path() / "tiles.ptiles", tiles_); }

    void expect_error(const std::string& arguments, const std::string& message) const
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_THAT(outcome.error, HasSubstr(message));
    }

    PoissonTileSet tiles_ = random_tile_set(PoissonTileKind::corner, 2, 3, 9);
};

/// The points as read from a file whose range of coordinates is [0, size).
PointSet expected_points(const PoissonTileSet& tiles, const PoissonTiling& tiling, const TileBlock& block, double size)
{
    PointSet points{tiles.parameters.dimension, {}};
    for (const std::uint32_t unit : reference::exact_tile_points(tiles, tiling, block))
        points.coordinates.push_back(unit / 65536.0 / size);
    return points;
}

TEST_F(TilesPointsCommand, WritesAWindowInEveryFormat)
{
    const PointSet expected = expected_points(tiles_, {7, 0}, {{-3, 5, 0}, {8, 8, 1}}, 8);
    for (const std::string name : {"points.txt", "points.ply", "points.npy"}) {
        const Outcome outcome = run("tiles.ptiles --window -3 5 8 8 --seed 7 --out " + name);
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.out + outcome.error, "");
        // NumPy files say nothing of their domain.
        const auto range = name == "points.npy" ? std::optional(CoordinateRange{0, 8}) : std::nullopt;
        EXPECT_EQ(read_points(folder_.path() / name, range).at(0), expected) << name;
    }
    EXPECT_THAT(content_of(folder_.path() / "points.txt"),
                StartsWith("# domain 0:8\n# poissonlab tiles points tiles."));
}

/// Windows of one tile that never repeats, 10^12 edges away: files of every format have the points of the header, and a
/// density leaves those of its level.
TEST_F(TilesPointsCommand, WritesWindowsOfHatsAndSpectres)
{
    constexpr std::array<std::int64_t, 2> origin{1'000'000'000'000, -77};
    constexpr std::array<double, 2> low{}, high{23, 23};
    for (const std::string word : {"hat", "spectre"}) {
        const std::string set = fmt::format("{}/runtime/tile_sets/{}-n4.ptiles", source_folder(), word);
        const MonotilePointsFile file = read_monotile_points(set);
        for (const double density : {1.0, 0.4}) {
            std::array<pmono_point, 500> found{};
            const std::size_t count = pmono_in_window(&file.set(), 5, origin.data(), low.data(), high.data(),
                                                      found.data(), found.size(), density);
            PointSet expected{2, {}};
            for (std::size_t i = 0; i < count; ++i)
                for (const double x : found[i].position) expected.coordinates.push_back(x / 23);
            for (const std::string name : {"points.txt", "points.npy"}) {
                const Outcome outcome = run(fmt::format(
                    "{} --window 1000000000000 -77 23 23 --seed 5 --density {} --out {}", set, density, name));
                ASSERT_EQ(outcome.status, 0) << outcome.error;
                EXPECT_EQ(outcome.out + outcome.error, "");
                EXPECT_EQ(read_points(folder_.path() / name, CoordinateRange{0, 23}).at(0), expected) << name;
            }
        }
    }
    expect_error(source_folder() + "/runtime/tile_sets/hat-n4.ptiles --torus 3 --out a.txt", "never close");
}

/// Regions of hats and spectres keep the distance that was asked for, or have as many points as were asked for; files
/// of longitudes and latitudes have places in them.
TEST_F(TilesPointsCommand, FillsRegionsWithHatsAndSpectres)
{
    for (const std::string word : {"hat", "spectre"}) {
        const std::string set = fmt::format("{}/runtime/tile_sets/{}-n4.ptiles", source_folder(), word);
        const Outcome distance = run_program(folder_.path(), {"tiles", "points", set, "--region", "disk 5000 -7000 30",
                                                              "--min-distance", "2", "--json", "--out", "points.txt"});
        ASSERT_EQ(distance.status, 0) << distance.error;
        const auto said = nlohmann::json::parse(distance.out);
        EXPECT_EQ(said["min_distance"], 2);
        EXPECT_NEAR(said["edge"], 2 / pmono_min_distance(&read_monotile_points(set).set()), 1e-8);
        const PointSet points = read_points(folder_.path() / "points.txt", CoordinateRange{-8000, 8000}).at(0);
        EXPECT_EQ(points.size(), said["points"]);
        double least = 1e9;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto at = [&](std::size_t k, std::size_t axis) {
                return points.coordinates[2 * k + axis] * 16000 - 8000;
            };
            EXPECT_LE(std::hypot(at(i, 0) - 5000, at(i, 1) + 7000), 30 + 1e-6);
            for (std::size_t j = 0; j < i; ++j)
                least = std::min(least, std::hypot(at(i, 0) - at(j, 0), at(i, 1) - at(j, 1)));
        }
        EXPECT_GT(least, 2 - 1e-9);
        EXPECT_LT(least, 2.05);
        const Outcome many = run_program(folder_.path(), {"tiles", "points", set, "--region", "disk 0 0 1", "--points",
                                                          "1234", "--density", "0.5", "--out", "points.npy"});
        ASSERT_EQ(many.status, 0) << many.error;
        EXPECT_EQ(read_points(folder_.path() / "points.npy", CoordinateRange{-1, 1}).at(0).size(), 1234U);
    }
}

/// Both engines write equal bytes, of windows, tori and parts of the points.
TEST_F(TilesPointsCommand, EitherEngineMakesTheSameFile)
{
    write_tile_set(folder_.path() / "spheres.ptiles", random_tile_set(PoissonTileKind::corner, 3, 2, 8));
    for (const std::string arguments :
         {"tiles.ptiles --window -3 5 4 7", "tiles.ptiles --torus 5", "tiles.ptiles --window 0 0 9 9 --density 0.4",
          "spheres.ptiles --window -1 -2 3 4 2 3", "spheres.ptiles --torus 3"}) {
        ASSERT_EQ(run(arguments + " --out device.npy").status, 0) << arguments;
        ASSERT_EQ(run(arguments + " --engine reference --out reference.npy").status, 0) << arguments;
        EXPECT_EQ(content_of(folder_.path() / "device.npy"), content_of(folder_.path() / "reference.npy")) << arguments;
    }
    expect_error("tiles.ptiles --torus 5 --engine foo --out x.npy",
                 "--engine foo: must be one of \"opencl\", \"reference\"");
}

TEST_F(TilesPointsCommand, WritesSpheres)
{
    const PoissonTileSet spheres = random_tile_set(PoissonTileKind::corner, 3, 2, 8);
    write_tile_set(folder_.path() / "spheres.json", spheres);
    const Outcome outcome = run("spheres.json --window -1 -2 3 4 2 3 --out points.dat");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    PointReading how;
    how.domain = CoordinateRange{0, 4}; // of a window that is not a cube
    EXPECT_EQ(read_points(folder_.path() / "points.dat", how).at(0),
              expected_points(spheres, {1, 0}, {{-1, -2, 3}, {4, 2, 3}}, 4));
}

/// With chains a window has the points that lie in it, whichever tiles they belong to, as engines find them.
TEST_F(TilesPointsCommand, WindowsOfChainsFitTogether)
{
    const PoissonTileSet tiles = random_chain_set(3, 20);
    write_tile_set(folder_.path() / "chains.ptiles", tiles);
    ASSERT_EQ(run("chains.ptiles --window -3 5 8 7 --seed 7 --out points.txt").status, 0);
    EXPECT_THAT(content_of(folder_.path() / "points.txt"), testing::Not(HasSubstr("domain"))); // it is not a square
    ASSERT_EQ(run("chains.ptiles --window -3 5 8 8 --seed 7 --out points.txt").status, 0);
    const PointSet found = read_points(folder_.path() / "points.txt").at(0);
    const ptiles_tiling tiling = runtime_tiling(tiles, {7, 0});
    const double low[] = {-3, 5}, high[] = {5, 13};
    std::vector<ptiles_point> expected(ptiles_in_window(&tiling, low, high, nullptr, 0, 1));
    ptiles_in_window(&tiling, low, high, expected.data(), expected.size(), 1);
    ASSERT_EQ(found.size(), expected.size());
    expect_error("chains.ptiles --window 0 0 65536 1 --out wide.npy",
                 "65536 tiles along an axis: must be at most 65534");
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t axis = 0; axis < 2; ++axis)
            EXPECT_EQ(found.coordinates[2 * i + axis], (expected[i].position[axis] - low[axis]) / 8);
}

/// The points of the header for engines with a level below what a function of their place says.
template <class DensityAt>
std::vector<double> sparser_points(const PoissonTileSet& tiles, const DensityAt& density_at)
{
    const ptiles_tiling tiling = runtime_tiling(tiles, {3, 0});
    const double low[] = {-3, 5}, high[] = {5, 9};
    std::vector<ptiles_point> points(ptiles_in_window(&tiling, low, high, nullptr, 0, 1));
    ptiles_in_window(&tiling, low, high, points.data(), points.size(), 1);
    std::vector<double> kept;
    for (const ptiles_point& point : points) {
        const double x = (point.position[0] + 3) / 8, y = (point.position[1] - 5) / 8;
        if (point.level < density_at(x, y)) kept.insert(kept.end(), {x, y});
    }
    return kept;
}

class TilesPointsByDensity : public TilesPointsCommand, public testing::WithParamInterface<bool>
{
protected:
    std::vector<double> points_with(const std::string& density) const
    {
        const Outcome outcome = run("set.ptiles --window -3 5 8 4 --seed 3 --out points.txt --density " + density);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        PointReading how;
        how.domain = CoordinateRange{0, 8}; // of a window that is not a square
        return read_points(folder_.path() / "points.txt", how).at(0).coordinates;
    }
};

TEST_P(TilesPointsByDensity, ThoseOfLowerLevelsAreLeft)
{
    const PoissonTileSet tiles = GetParam() ? with_random_ranks(random_chain_set(3, 20)) : random_chain_set(3, 20);
    write_tile_set(folder_.path() / "set.ptiles", tiles);
    EXPECT_EQ(points_with("0.3"), sparser_points(tiles, [](double, double) { return 0.3; }));
    EXPECT_EQ(points_with("1"), sparser_points(tiles, [](double, double) { return 1; }));
    // The window is twice as wide as high: its upper half has y above 0.
    EXPECT_EQ(points_with("y>0?1:0.25"), sparser_points(tiles, [](double, double y) { return y < 0.25 ? 0.25 : 1; }));
    write_png(folder_.path() / "ink.png", {.width = 2, .height = 1, .channels = 1},
              [](int, int) { return reinterpret_cast<const std::uint8_t*>("\0\xff"); });
    EXPECT_EQ(points_with("ink.png"), sparser_points(tiles, [](double x, double) { return x < 0.5 ? 0 : 1; }));
    EXPECT_EQ(points_with("ink.png --density-from ink"),
              sparser_points(tiles, [](double x, double) { return x < 0.5 ? 1 : 0; }));
}

INSTANTIATE_TEST_SUITE_P(RankedAndNot, TilesPointsByDensity, testing::Bool());

TEST_F(TilesPointsCommand, SaysWhatIsWrongWithADensity)
{
    const auto expect = [&](const std::string& options, const std::string& message) {
        expect_error("tiles.ptiles --window 0 0 2 2 --out points.npy --density " + options, message);
    };
    for (const char* number : {"0", "-0.5", "1.5", "nan", "inf"})
        expect(number, std::string("tiles points: --density ") + number +
                           ": must be a number greater than 0 and at most 1, a picture or a formula");
    expect("none.png", "tiles points: --density: none.png: no such file; as a formula \"none.png\": ");
    expect("sin(x", "tiles points: --density: formula \"sin(x\": ");
    expect("tiles.ptiles", "tiles points: --density: tiles.ptiles: cannot read the picture: ");
    expect("x*0", "is 0 everywhere");
    expect("0.5 --density-from ink", "--density-from ink: is for pictures, and --density 0.5 is none");
    write_tile_set(folder_.path() / "spheres.ptiles", random_tile_set(PoissonTileKind::corner, 3, 1, 8));
    expect_error("spheres.ptiles --window 0 0 0 1 1 1 --out points.npy --density x*x",
                 "--density x*x: must be a number for tiles in space");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "points.npy"));
}

TEST_F(TilesPointsCommand, SaysWhatIsWrong)
{
    expect_error("none.ptiles --window 0 0 1 1 --out points.npy", "none.ptiles: cannot be read");
    expect_error(
        "tiles.ptiles --window 0 0 1 1 --out points.svg",
        "--out points.svg: must end in .txt, .dat, .csv, .npy, .ply, .h5, .hdf5, .usda, .h5part, .geojson or .dxf");
    expect_error("tiles.ptiles --window 0 0 1 --out points.npy", "--window 0 0 1: must be X Y W H");
    expect_error("tiles.ptiles --window 0 0 0 1 --out points.npy", "sizes are at least 1");
    expect_error("tiles.ptiles --window 0 0 70000 1 --out points.npy", "must be 1 to 65536");
    expect_error("tiles.ptiles --window 3000000000 0 1 1 --out points.npy", "32 bits");
    expect_error("tiles.ptiles --window 0 0 1 1 --seed -1 --out points.npy", "must be an integer from 0 to 4294967295");
    expect_error("tiles.ptiles --window 0 0 1 1", "tiles points: needs --out");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "points.npy"));
}

}
}
