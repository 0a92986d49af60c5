// `poissonlab tiles points --region`: which points are written, how far apart they are, and what is refused.
#include "base/points/point_file.hpp"
#include "host/tile_points/tile_points.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace poissonlab {
namespace {

using testing::HasSubstr;

using PlaneCorners = std::vector<std::array<double, 2>>;

/// True if a place is in a ring by the even-odd rule, counted along the half line to the right.
bool is_in_ring(const PlaneCorners& ring, double x, double y)
{
    bool is_inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto& [x0, y0] = ring[i];
        const auto& [x1, y1] = ring[(i + 1) % ring.size()];
        if ((y0 <= y) != (y1 <= y)) is_inside ^= x < x0 + (y - y0) / (y1 - y0) * (x1 - x0);
    }
    return is_inside;
}

class TilesInRegions : public test::CommandTest
{
protected:
    TilesInRegions() : CommandTest("tiles points")
    {
        tiles_ = random_chain_set(3, 20);
        tiles_.squared_min_distance = 5000ull * 5000;
        write_tile_set(folder_.path() / "tiles.ptiles", tiles_);
    }

    /// Words in quotes hold blanks.
    Outcome run(const std::string& arguments) const
    {
        std::vector<std::string> words{"tiles", "points"};
        std::istringstream parts(arguments);
        for (std::string part; std::getline(parts, part, '\'');) {
            std::ranges::copy(test::words_of(part), std::back_inserter(words));
            if (std::getline(parts, part, '\'')) words.push_back(part);
        }
        return run_program(folder_.path(), words);
    }

    /// Runs the command, and returns the text of the file that `--out` names.
    std::string file_of(const std::string& arguments, const std::string& file) const
    {
        const Outcome outcome = run("tiles.ptiles " + arguments + " --out " + file);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return content_of(folder_.path() / file);
    }

    std::vector<double> points_of(const std::string& arguments) const
    {
        const Outcome outcome = run("tiles.ptiles " + arguments + " --out points.txt");
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        std::vector<double> coordinates;
        std::istringstream lines(content_of(folder_.path() / "points.txt"));
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with('#')) continue;
            double x = 0, y = 0;
            std::istringstream(line) >> x >> y;
            coordinates.insert(coordinates.end(), {x, y});
        }
        return coordinates;
    }

    void expect_error(const std::string& arguments, const std::string& message) const
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_THAT(outcome.error, HasSubstr(message));
    }

    PoissonTileSet tiles_;
};

TEST_F(TilesInRegions, NameTheCoordinatesOfTheirFiles)
{
    const std::string globe = "--region 'SRID=4326;POLYGON ((4.70 50.86, 4.71 50.86, 4.71 50.87, 4.70 50.86))'";
    EXPECT_TRUE(file_of(globe + " --min-distance 90", "a.csv").starts_with("longitude,latitude\n4.7"));
    EXPECT_TRUE(file_of("--region 'disk 0 0 9' --min-distance 1", "a.csv").starts_with("x,y\n"));
    const std::string belgian = "--region 'rectangle 150000 170000 150900 170900' --crs EPSG:31370 --min-distance 90";
    const auto json = nlohmann::json::parse(file_of(belgian, "a.geojson"));
    EXPECT_EQ(json.at("crs").at("properties").at("name"), "EPSG:31370");
    EXPECT_FALSE(nlohmann::json::parse(file_of(globe + " --min-distance 90", "b.geojson")).contains("crs"));
}

/// These are the points that runtime/poisson_tiles.h finds, which are inside by another test, in another order.
TEST_F(TilesInRegions, HaveThePointsOfTheTilingThatAreInside)
{
    const PlaneCorners outline{{-30, 10}, {40, -20}, {55, 45}, {0, 20}}, hole{{0, 5}, {20, 5}, {20, 15}, {0, 15}};
    const double width = 3.0 * 65536 / 5000; // min_distance = 3; rounding makes it no more than 1e-15 wider
    const ptiles_tiling tiling = runtime_tiling(tiles_, {9, 0});
    const double low[] = {-2, -2}, high[] = {3, 3};
    std::vector<ptiles_point> all(ptiles_in_window(&tiling, low, high, nullptr, 0, 1));
    ptiles_in_window(&tiling, low, high, all.data(), all.size(), 1);
    std::vector<std::array<double, 2>> expected;
    for (const ptiles_point& point : all) {
        const double x = point.position[0] * width, y = point.position[1] * width;
        if (is_in_ring(outline, x, y) && !is_in_ring(hole, x, y)) expected.push_back({x, y});
    }
    const std::string region = "'POLYGON ((-30 10, 40 -20, 55 45, 0 20, -30 10), (0 5, 20 5, 20 15, 0 15, 0 5))'";
    const std::vector<double> found = points_of("--region " + region + " --min-distance 3 --seed 9");
    EXPECT_EQ(found, points_of("--region " + region + " --min-distance 3 --seed 9 --engine reference"));
    ASSERT_EQ(found.size(), 2 * expected.size());
    ASSERT_GT(expected.size(), 20U);
    std::vector<std::array<double, 2>> sorted;
    for (std::size_t i = 0; i < found.size(); i += 2) sorted.push_back({found[i], found[i + 1]});
    std::ranges::sort(sorted);
    std::ranges::sort(expected);
    for (std::size_t i = 0; i < sorted.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(sorted[i][k], expected[i][k], 1e-12);
}

/// Two regions beside each other have together what the region of both has.
TEST_F(TilesInRegions, OfRegionsBesideEachOtherFitTogether)
{
    const auto sorted_points = [&](const std::vector<std::string>& regions) {
        std::vector<std::array<double, 2>> all;
        for (const std::string& region : regions) {
            const std::vector<double> found = points_of("--region '" + region + "' --min-distance 0.5");
            for (std::size_t i = 0; i < found.size(); i += 2) all.push_back({found[i], found[i + 1]});
        }
        std::ranges::sort(all);
        return all;
    };
    EXPECT_EQ(sorted_points({"rectangle 100 200 110 207", "rectangle 110 200 118 207"}),
              sorted_points({"rectangle 100 200 118 207"}));
}

TEST_F(TilesInRegions, AreAsManyAsAreAskedFor)
{
    const Outcome outcome =
        run("tiles.ptiles --region 'disk 5e6 4e6 700' --points 1234 --density 0.5 --out points.npy --json");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto said = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(said["points"], 1234);
    EXPECT_NEAR(said["min_distance"], said["tile_width"].get<double>() * 5000 / 65536, 1e-8);
    EXPECT_EQ(points_of("--region 'disk 5e6 4e6 700' --points 1234 --density 0.5").size(), 2 * 1234);
    // The density is laid over the region's box: its left half, whose y is up to 5.
    const std::vector<double> half = points_of("--region 'rectangle 10 0 30 5' --points 100 --density 'x<0?1:0'");
    for (std::size_t i = 0; i < half.size(); i += 2) EXPECT_LT(half[i], 20 + 0.02);
}

/// Real tiles, far from 0: what a user computes from the file is not below what was asked for.
TEST_F(TilesInRegions, KeepTheirDistanceAlsoWhenItIsComputed)
{
    const std::string tiles = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
    ASSERT_EQ(run(tiles + " --region 'rectangle 512345.678 5412345.678 512385.678 5412385.678' --min-distance 0.7 " +
                  "--out points.npy")
                  .status,
              0);
    const PointSet points = read_points(folder_.path() / "points.npy", CoordinateRange{0, 1e7}).at(0);
    ASSERT_GT(points.size(), 2000U);
    double least = 1e9;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
    EXPECT_GE(least * 1e7, 0.7 - 1e-8); // reading divides by 1e7, which rounds
    EXPECT_LT(least * 1e7, 0.72);
}

TEST_F(TilesInRegions, SayWhatIsWrong)
{
    const std::string end = " --out points.npy";
    expect_error("tiles.ptiles --region 'rectangle 0 0 1 1'" + end,
                 "--region: needs --min-distance or --points, and not both");
    expect_error("tiles.ptiles --window 0 0 1 1 --points 7" + end, "tiles points: --points: needs --region");
    expect_error("tiles.ptiles --window 0 0 1 1 --region 'disk 0 0 1'" + end, "needs one of --window, --torus");
    expect_error("tiles.ptiles --region 'disk 0 0'" + end + " --points 9",
                 "--region: disk 0 0: must be disk X Y RADIUS");
    expect_error("tiles.ptiles --region 'disk 0 0 1' --min-distance 1e-6" + end,
                 "--region: takes 152588 tiles of 1.311e-05 units along an axis: must be at most 65534");
    expect_error("tiles.ptiles --region 'disk 1e9 0 1' --min-distance 1e-3" + end,
                 "tiles from 0: must be less than 2^31");
    write_tile_set(folder_.path() / "unproven.ptiles", random_tile_set(PoissonTileKind::corner, 2, 2, 9));
    expect_error("unproven.ptiles --region 'disk 0 0 1' --min-distance 1" + end, "has no proven minimum distance");
    write_tile_set(folder_.path() / "spheres.ptiles", random_tile_set(PoissonTileKind::corner, 3, 1, 8));
    expect_error("spheres.ptiles --region 'disk 0 0 1' --min-distance 1" + end, "tiles in space have no plane region");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "points.npy"));
}

}
}
