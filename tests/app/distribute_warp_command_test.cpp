// `poissonlab distribute warp`: its files, and what it refuses.
#include "base/images/png_file.hpp"
#include "base/points/point_file.hpp"
#include "tests/support/program.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class DistributeWarp : public testing::Test
{
protected:
    DistributeWarp()
    {
        write_tile_set(folder_.path() / "tiles.ptiles", random_tile_set(PoissonTileKind::corner, 2, 3, 8));
        write_picture("half.png", 4, 2, {0, 0, 255, 255, 0, 0, 255, 255});
    }

    void write_picture(const std::string& name, int width, int height, const std::vector<std::uint8_t>& grey) const
    {
        write_png(folder_.path() / name, {width, height, 1},
                  [&](int first, int) { return grey.data() + static_cast<std::size_t>(first * width); });
    }

    Outcome run(const std::vector<std::string>& arguments) const
    {
        std::vector<std::string> words{"distribute", "warp"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        return run_program(folder_.path(), words);
    }

    void expect_error(const std::vector<std::string>& arguments, const std::string& message) const
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_THAT(outcome.error, HasSubstr(message));
        EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out.txt"));
    }

    TemporaryFolder folder_;
};

/// The picture is white on its right, twice as wide as high: x is from 1/2 to 1, y from 0 to 1/2.
TEST_F(DistributeWarp, WritesCoordinatesInUnitsOfTheLongestSide)
{
    for (const std::string engine : {"opencl", "reference"}) {
        const Outcome outcome = run({"--density", "half.png", "--points", "64", "--tiles", "tiles.ptiles", "--seed",
                                     "3", "--out", engine + ".txt", "--engine", engine});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        const PointSet points = read_points(folder_.path() / (engine + ".txt")).at(0);
        EXPECT_EQ(points.size(), 64);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_TRUE(points[i][0] >= 0.5 && points[i][0] < 1) << points[i][0];
            EXPECT_TRUE(points[i][1] >= 0 && points[i][1] < 0.5) << points[i][1];
        }
    }
    EXPECT_EQ(content_of(folder_.path() / "opencl.txt"), content_of(folder_.path() / "reference.txt"));
    EXPECT_THAT(content_of(folder_.path() / "opencl.txt"), StartsWith("# domain 0:1\n# poissonlab distribute warp"));
}

TEST_F(DistributeWarp, TakesFormulasAndMethods)
{
    const Outcome outcome =
        run({"--density", "x > 0", "--points", "100", "--method", "{ sampler = \"regular\" }", "--out", "points.npy"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const PointSet points = read_points(folder_.path() / "points.npy").at(0);
    EXPECT_EQ(points.size(), 100);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_GE(points[i][0], 0.5);
}

/// All light comes from the upper left quarter: seen from outside, x, y and z of the direction are positive. Seen from
/// inside, the left border is -x: x is negative, and all else is the same.
TEST_F(DistributeWarp, WritesLightsOfEnvironmentMaps)
{
    write_picture("sky.png", 4, 2, {255, 0, 0, 0, 0, 0, 0, 0});
    const Outcome outcome = run({"--density", "sky.png", "--environment", "--points", "16", "--tiles", "tiles.ptiles",
                                 "--out", "places.txt", "--lights", "lights.csv", "--seen-from", "outside"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    std::istringstream lines(content_of(folder_.path() / "lights.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "x,y,z,power");
    int count = 0;
    for (; std::getline(lines, line); ++count) {
        EXPECT_EQ(line.find('-'), std::string::npos) << line;
        const double power = std::stod(line.substr(line.rfind(',') + 1));
        EXPECT_NEAR(power, 3.14159265358979 / 2 / 16, 1e-12); // an eighth of the sphere
    }
    EXPECT_EQ(count, 16);
    const std::string outside = content_of(folder_.path() / "lights.csv");
    const Outcome inside = run({"--density", "sky.png", "--environment", "--points", "16", "--tiles", "tiles.ptiles",
                                "--out", "places.txt", "--lights", "lights.csv"});
    ASSERT_EQ(inside.status, 0) << inside.error;
    std::string mirrored;
    for (const char c : content_of(folder_.path() / "lights.csv"))
        if (c != '-') mirrored += c;
    EXPECT_EQ(mirrored, outside);
    EXPECT_EQ(std::ranges::count(content_of(folder_.path() / "lights.csv"), '-'), 16);
}

TEST_F(DistributeWarp, RefusesWhatItCannotDo)
{
    const std::vector<std::string> out{"--points", "8", "--out", "out.txt"};
    const auto with = [&](std::vector<std::string> words) {
        words.insert(words.end(), out.begin(), out.end());
        return words;
    };
    expect_error(with({"--density", "none.png"}), "distribute warp: --density: none.png: no such file");
    expect_error(with({"--density", "x +"}), "distribute warp: --density: formula \"x +\"");
    expect_error(with({"--density", "0*x"}), "is 0 everywhere");
    expect_error(with({"--density", "half.png", "--density-from", "Z"}), "must be light, ink or a channel");
    expect_error(with({"--density", "x+1", "--density-from", "ink"}), "is for pictures");
    expect_error(with({"--density", "half.png", "--lights", "l.csv"}), "--lights: needs --environment");
    expect_error(with({"--density", "x+1", "--seen-from", "above"}),
                 "--seen-from above: must be one of \"inside\", \"outside\"");
    expect_error(with({"--density", "x+1", "--seen-from", "outside"}), "--seen-from outside: needs --environment");
    expect_error(with({"--density", "half.png", "--density-from", "ink", "--environment"}), "takes the light");
    expect_error(with({"--density", "x+1", "--engine", "fast"}), "--engine fast: must be one of");
    expect_error(with({"--density", "x+1", "--method", "dart-trowing"}), "did you mean");
    expect_error(with({"--density", "x+1", "--method", "{ sampler = "}), "distribute warp: --method");
    expect_error({"--density", "x+1", "--points", "0", "--out", "out.txt"}, "--points 0: must be an integer from 1 to");
    expect_error({"--density", "x+1", "--points", "8", "--out", "no/out.txt"}, "there is no folder no");
    expect_error(
        {"--density", "x+1", "--points", "8", "--out", "out.png"},
        "--out out.png: must end in .txt, .dat, .csv, .npy, .ply, .h5, .hdf5, .usda, .h5part, .geojson or .dxf");
    write_picture("square.png", 2, 2, {1, 2, 3, 4});
    expect_error(with({"--density", "square.png", "--environment"}), "must be twice as wide as high");
}

}
}
