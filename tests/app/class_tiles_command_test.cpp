// Tile sets with classes as a user has them: built, verified, written as points, placed as instances.
#include "base/files/whole_file.hpp"
#include "tests/support/program.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ClassTilesCommand : public testing::Test
{
protected:
    Outcome run(const std::vector<std::string>& arguments) const { return run_program(folder_.path(), arguments); }

    Outcome build(const std::vector<std::string>& more) const
    {
        std::vector<std::string> arguments{"tiles", "build",    "corner",   "--colors",  "2",
                                           "--out", "f.ptiles", "--engine", "reference", "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }

    std::vector<std::string> lines_of(const std::string& name) const
    {
        std::istringstream text(read_whole_file(folder_.path() / name));
        std::vector<std::string> lines;
        for (std::string line; std::getline(text, line);) lines.push_back(line);
        return lines;
    }

    TemporaryFolder folder_;
};

TEST_F(ClassTilesCommand, VerifiesEachPairOfClasses)
{
    EXPECT_EQ(build({"--class-points", "5", "12", "--relative-radius", "0.5"}).error, "");
    const Outcome outcome = run({"tiles", "verify", "f.ptiles", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    const auto json = nlohmann::json::parse(outcome.out)["classes"];
    EXPECT_EQ(json["points"], (std::vector{5, 12}));
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            EXPECT_GE(json["min_distances"][i][j], json["asked_distances"][i][j]);
            EXPECT_EQ(json["min_distances"][i][j], json["min_distances"][j][i]);
            const auto& place = json["nearest"][i][j];
            if (place.is_null()) continue; // a bound that no two points have
            const auto& points = place["points"];
            const double dx = points[0][0].get<double>() - points[1][0].get<double>();
            const double dy = points[0][1].get<double>() - points[1][1].get<double>();
            EXPECT_NEAR(std::hypot(dx, dy) / 65536, json["min_distances"][i][j].get<double>(), 1e-12);
        }
    EXPECT_THAT(run({"tiles", "verify", "f.ptiles"}).out, HasSubstr("class 1               12 points a tile"));

    PoissonTileSet set = read_tile_set(folder_.path() / "f.ptiles");
    set.class_squared_distances[1] *= 4;
    write_tile_set(folder_.path() / "f.ptiles", set);
    const Outcome spoiled = run({"tiles", "verify", "f.ptiles", "--json"});
    EXPECT_EQ(spoiled.status, 2);
    EXPECT_THAT(spoiled.error, HasSubstr("f.ptiles: classes 0 and 1: promises a squared distance of"));
}

TEST_F(ClassTilesCommand, WritesTheClassOfEachPoint)
{
    EXPECT_EQ(build({"--class-points", "5", "12", "--class-distances", "0.2", "0.12", "--ranked"}).error, "");
    const Outcome all = run({"tiles", "points", "f.ptiles", "--window", "3", "-2", "4", "5", "--out", "p.csv"});
    EXPECT_EQ(all.status, 0) << all.error;
    const std::vector<std::string> rows = lines_of("p.csv");
    ASSERT_EQ(rows.size(), 1U + 20 * 17);
    EXPECT_EQ(rows[0], "x,y,class");
    EXPECT_EQ(std::ranges::count_if(rows, [](const std::string& row) { return row.ends_with(",0"); }), 20 * 5);

    // Ranks keep the classes in their proportions, and leave points where they are.
    run({"tiles", "points", "f.ptiles", "--window", "3", "-2", "4", "5", "--density", "0.4", "--out", "h.csv"});
    const std::vector<std::string> fewer = lines_of("h.csv");
    EXPECT_EQ(std::ranges::count_if(fewer, [](const std::string& row) { return row.ends_with(",0"); }), 20 * 2);
    EXPECT_EQ(std::ranges::count_if(fewer, [](const std::string& row) { return row.ends_with(",1"); }), 20 * 5);
    for (const std::string& row : fewer) EXPECT_NE(std::ranges::find(rows, row), rows.end());

    const Outcome text = run({"tiles", "points", "f.ptiles", "--torus", "2", "--out", "p.txt"});
    EXPECT_EQ(text.status, 2);
    EXPECT_THAT(text.error, HasSubstr("the points of these tiles have classes: must end in .csv, .ply, .npy"));
}

TEST_F(ClassTilesCommand, GivesClassesToPicturesSpectraAndInstances)
{
    EXPECT_EQ(build({"--class-points", "5", "12", "--class-matrix", "0.2", "0.1", "0.1", "0.12"}).error, "");
    const Outcome torus = run({"distribute", "classes", "--tiles", "f.ptiles", "--torus", "4", "--engine", "reference",
                               "--out", "a.svg", "--out", "a.csv", "--spectra", "s.csv", "--json"});
    EXPECT_EQ(torus.status, 0) << torus.error;
    const auto numbers = nlohmann::json::parse(torus.out);
    EXPECT_EQ(numbers["points_1"], 16 * 12);
    EXPECT_NEAR(numbers["distance_0_1"].get<double>(), 0.1 / 4, 1e-12);
    EXPECT_GE(numbers["least_0_1"].get<double>(), 0.1 / 4 * (1 - 1e-9));
    EXPECT_THAT(lines_of("s.csv")[0], StartsWith("frequency,all,class_0,class_1,cross_0_1"));
    EXPECT_THAT(run({"distribute", "classes", "--tiles", "f.ptiles", "--points", "4", "--out", "a.csv"}).error,
                HasSubstr("--points 4: cannot be combined with --tiles"));

    const Outcome forest = run({"distribute", "instances", "forest", "--tiles", "f.ptiles", "--engine", "reference",
                                "--models", "3", "--density", "300", "--out", "i.csv", "--quiet"});
    EXPECT_EQ(forest.status, 0) << forest.error;
    const std::vector<std::string> rows = lines_of("i.csv");
    EXPECT_THAT(rows[0], testing::EndsWith(",index,class"));
    for (std::size_t i = 1; i < rows.size(); ++i) {
        std::vector<std::string> cells;
        std::istringstream row(rows[i]);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        EXPECT_EQ(cells.back(), std::stoi(cells[11]) < 5 ? "0" : "1"); // points come class after class
        EXPECT_EQ(std::stoi(cells[3]) % 2, std::stoi(cells.back()));
    }
    EXPECT_THAT(
        run({"distribute", "instances", "forest", "--tiles", "f.ptiles", "--models", "1", "--out", "i.csv"}).error,
        HasSubstr("--models 1: must be at least 2, one for each class"));
}

}
}
