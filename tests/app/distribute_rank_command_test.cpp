// `poissonlab distribute rank`: its files, and what it refuses.
#include "base/points/point_file.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class DistributeRank : public testing::Test
{
protected:
    Outcome run(const std::string& density, std::size_t points, const std::string& file,
                const std::string& seed = "1") const
    {
        return run_program(folder_.path(), {"distribute", "rank", "--density", density, "--points",
                                            std::to_string(points), "--seed", seed, "--out", file});
    }

    std::set<std::pair<double, double>> places(const std::string& density, std::size_t points,
                                               const std::string& seed = "1") const
    {
        const Outcome outcome = run(density, points, "points.npy", seed);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        const PointSet set = read_points(folder_.path() / "points.npy").at(0);
        std::set<std::pair<double, double>> all;
        for (std::size_t i = 0; i < set.size(); ++i) all.insert({set[i][0], set[i][1]});
        EXPECT_EQ(all.size(), set.size());
        return all;
    }

    TemporaryFolder folder_;
};

/// A constant density of 16 * 4^k points is the tile divided k times, all of it.
TEST_F(DistributeRank, MakesAsManyPointsAsAreAskedFor)
{
    EXPECT_EQ(places("1", 1024).size(), 1024U);
    const auto right = places("x > 0", 1000);
    EXPECT_NEAR(static_cast<double>(right.size()), 1000, 60);
    for (const auto& [x, y] : right) EXPECT_TRUE(x >= 0.5 && x < 1 && y >= 0 && y < 1) << x << " " << y;
}

/// Sixteen points a tile: within one division, a larger number keeps the points of lower rank.
TEST_F(DistributeRank, AddsPointsAndMovesNoneUntilTilesAreDivided)
{
    const auto few = places("1", 600), many = places("1", 1000);
    EXPECT_LT(few.size(), many.size());
    EXPECT_TRUE(std::ranges::includes(many, few));
    EXPECT_NE(places("1", 600, "2"), few);
}

TEST_F(DistributeRank, RefusesWhatItCannotDo)
{
    for (const auto& [density, points, words] :
         {std::tuple{"none.png", 8, "distribute rank: --density: none.png: no such file"},
          {"x +", 8, "distribute rank: --density: formula \"x +\""},
          {"0*x", 8, "is 0 everywhere"},
          {"1", 0, "--points 0: must be an integer from 1 to"}}) {
        const Outcome outcome = run(density, static_cast<std::size_t>(points), "out.txt");
        EXPECT_EQ(outcome.status, 2);
        EXPECT_THAT(outcome.error, HasSubstr(words));
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out.txt"));
    }
}

}
}
