// `poissonlab analyze` of sets that keep their distance inside but not across the border, and of points of the plane
// with a third coordinate.
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A set of darts that are 0.05 apart in the unit square, which is not a torus.
std::string darts_in_the_square(unsigned seed, const char* third = "")
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate;
    std::vector<std::array<double, 2>> darts;
    std::string text;
    for (int attempt = 0; attempt < 4000; ++attempt) {
        const double x = coordinate(random), y = coordinate(random);
        const auto is_near = [&](const auto& dart) { return std::hypot(dart[0] - x, dart[1] - y) < 0.05; };
        if (darts.size() == 230 || std::ranges::any_of(darts, is_near)) continue;
        darts.push_back({x, y});
        text += fmt::format("{} {}{}\n", x, y, third);
    }
    return text;
}

class Border : public testing::Test
{
protected:
    Border() { folder_.write("darts.txt", darts_in_the_square(1)); }

    Outcome analyze(std::vector<std::string> more) const
    {
        std::vector<std::string> words{"analyze", "darts.txt", "--out", "o"};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(folder_.path(), words);
    }

    nlohmann::json series() const
    {
        return nlohmann::json::parse(content_of(folder_.path() / "o/results.json"))["series"][0];
    }

    TemporaryFolder folder_;
};

TEST_F(Border, SetsThatAreNotPeriodicAreNamed)
{
    const Outcome outcome = analyze({});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("darts: The closest pairs of points meet across the border ("));
    EXPECT_THAT(outcome.out, HasSubstr("--periodic no"));
    const auto json = series();
    EXPECT_GE(json["border"]["pairs_across"], 4);
    EXPECT_LT(json["border"]["chance"], 1e-5);
    EXPECT_GE(json["border"]["relative_radius"], 0.05 / std::sqrt(2 / std::sqrt(3) / json["points"].get<double>()));
    EXPECT_LT(json["relative_radius"]["mean"], 0.9 * json["border"]["relative_radius"].get<double>());
    const std::string overview = content_of(folder_.path() / "o/index.html");
    EXPECT_THAT(overview, HasSubstr("meet across the border"));
    EXPECT_THAT(overview, HasSubstr("not periodic: not ranked"));
    EXPECT_THAT(overview, Not(HasSubstr("points nearly meet")));
    EXPECT_THAT(content_of(folder_.path() / "o/darts/index.html"), HasSubstr("meet across the border"));
}

TEST_F(Border, NoMeasuresWithinTheSquare)
{
    ASSERT_EQ(analyze({}).status, 0);
    const double inside = series()["border"]["relative_radius"], nearest = series()["border"]["mean_nearest_distance"];
    const Outcome outcome = analyze({"--periodic", "no"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, Not(HasSubstr("across the border")));
    const auto json = series();
    EXPECT_FALSE(json.contains("border"));
    EXPECT_EQ(json["region"]["name"], "rectangle 0 0 1 1");
    EXPECT_NEAR(json["relative_radius"]["mean"], inside, 1e-8);
    EXPECT_NEAR(json["measures"]["mean_nearest_distance"], nearest, 1e-8);
}

TEST_F(Border, NoGoesWithOtherDomainsAndWithMeasuresOfSquares)
{
    folder_.write("large.txt", "10 10\n30 10\n10 30\n30 30\n20 15\n");
    const Outcome scaled =
        run_program(folder_.path(), {"analyze", "large.txt", "--domain", "40", "--periodic", "no", "--out", "o"});
    ASSERT_EQ(scaled.status, 0) << scaled.error;
    EXPECT_NEAR(series()["min_distance"]["min"], std::hypot(10, 5) / 40, 1e-8);
    // Points keep their units: all results are those of the region.
    const auto by_domain = series();
    EXPECT_EQ(by_domain["region"]["name"], "rectangle 0 0 40 40");
    ASSERT_EQ(
        run_program(folder_.path(), {"analyze", "large.txt", "--region", "rectangle 0 0 40 40", "--out", "o"}).status,
        0);
    for (const char* member : {"region", "min_distance", "measures"}) EXPECT_EQ(series()[member], by_domain[member]);
    const Outcome tiled = analyze({"--periodic", "no", "--set", "analysis.tiles=2"});
    ASSERT_EQ(tiled.status, 0) << tiled.error;
    EXPECT_EQ(series()["window"], true);
}

TEST_F(Border, YesSaysNothing)
{
    const Outcome outcome = analyze({"--periodic", "yes"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, Not(HasSubstr("across the border")));
    EXPECT_FALSE(series().contains("border"));
}

TEST_F(Border, OtherWordsAreErrors)
{
    EXPECT_THAT(analyze({"--periodic", "maybe"}).error, HasSubstr("--periodic maybe: must be yes or no"));
    EXPECT_EQ(analyze({"--periodic", "maybe"}).status, 2);
    EXPECT_THAT(analyze({"--periodic", "no", "--region", "rectangle 0 0 1 1"}).error,
                HasSubstr("--periodic cannot be combined with --region"));
}

TEST_F(Border, PointsOfThePlaneInSpaceAreMeasuredInThePlaneWithAWord)
{
    folder_.write("darts.txt", darts_in_the_square(1, " 0"));
    const Outcome outcome = analyze({});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("darts.txt: all points have the same third coordinate"));
    EXPECT_EQ(nlohmann::json::parse(content_of(folder_.path() / "o/results.json"))["dimension"], 2);
}

}
}
