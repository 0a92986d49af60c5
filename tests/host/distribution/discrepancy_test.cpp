// Discrepancies are held against SciPy, closed forms of single points and grids, and boxes one by one.
#include "host/distribution/discrepancy.hpp"

#include "host/settings/toml_reader.hpp"
#include "results/pictures/distribution_files.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

PointSet random_set(std::size_t points, std::uint32_t seed, int steps)
{
    std::mt19937 random(seed);
    PointSet set;
    for (std::size_t i = 0; i < 2 * points; ++i)
        set.coordinates.push_back(steps > 0 ? static_cast<double>(random() % static_cast<unsigned>(steps)) / steps
                                            : static_cast<double>(random()) * 0x1p-32);
    return set;
}

/// The largest difference of all boxes whose sides are coordinates or 1, closed and open.
double largest_of_all_boxes(const PointSet& set, std::size_t count)
{
    std::vector<double> x{1}, y{1};
    for (std::size_t i = 0; i < count; ++i) {
        x.push_back(set[i][0]);
        y.push_back(set[i][1]);
    }
    double largest = 0;
    for (const double u : x)
        for (const double v : y) {
            double open = 0, closed = 0;
            for (std::size_t i = 0; i < count; ++i) {
                open += set[i][0] < u && set[i][1] < v ? 1 : 0;
                closed += set[i][0] <= u && set[i][1] <= v ? 1 : 0;
            }
            const auto n = static_cast<double>(count);
            largest = std::max({largest, u * v - open / n, closed / n - u * v});
        }
    return largest;
}

TEST(Discrepancies, AreThoseOfSciPy)
{
    // scipy.stats.qmc.discrepancy(points, method="L2-star") of the points (i phi mod 1, i sqrt(2) mod 1), i = 1, 2, ...
    PointSet set;
    for (int i = 1; i <= 1000; ++i)
        for (const double step : {(1 + std::sqrt(5.0)) / 2, std::sqrt(2.0)})
            set.coordinates.push_back(std::fmod(i * step, 1.0));
    const std::vector<double> found = l2_star_discrepancies(set, {1, 2, 3, 10, 100, 1000});
    const double wanted[] = {0.28082656567376446,  0.17472316450032954, 0.15747074692304444,
                             0.062947212697260571, 0.01147694116595439, 0.0013345505520922353};
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-12) << i;
}

TEST(Discrepancies, OfOnePointFollowFromItsPlace)
{
    // Boxes without the point have at most the area max(x, y), those with it lack at most 1 - x y.
    for (const auto& [x, y] : {std::pair{0.5, 0.5}, {0.0, 0.0}, {0.9, 0.2}, {0.999, 0.999}}) {
        const PointSet set{2, {x, y}};
        EXPECT_NEAR(star_discrepancy(set, 1), std::max({x, y, 1 - x * y}), 1e-15);
        // The integral of (u v - [u > x, v > y])^2 over the square.
        const double square = 1.0 / 9 - (1 - x * x) * (1 - y * y) / 2 + (1 - x) * (1 - y);
        EXPECT_NEAR(l2_star_discrepancies(set, {1}).front(), std::sqrt(square), 1e-15);
    }
}

TEST(Discrepancies, OfAllBoxesAreFound)
{
    for (const std::size_t points : {1, 2, 3, 7, 20, 60})
        for (const int steps : {0, 2, 5}) { // coordinates that are equal too
            const PointSet set = random_set(points, static_cast<std::uint32_t>(points), steps);
            for (const std::size_t count : {std::size_t{1}, (points + 1) / 2, points})
                EXPECT_NEAR(star_discrepancy(set, count), largest_of_all_boxes(set, count), 1e-14);
        }
}

TEST(Discrepancies, OfRandomPointsHaveTheirMean)
{
    // The mean square is (1/4 - 1/9) / N; 400 sets, four standard errors of what they show.
    double sum = 0, squares = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        const double found = std::pow(l2_star_discrepancies(random_set(50, seed, 0), {50}).front(), 2);
        sum += found / 400;
        squares += found * found / 400;
    }
    EXPECT_NEAR(sum, 5.0 / 36 / 50, 4 * std::sqrt((squares - sum * sum) / 400));
}

DistributionResult result_of(const std::string& toml)
{
    const TemporaryFolder folder;
    DistributionFiles files([&](const std::string& name) { return folder.path() / name; });
    const Kind kind = discrepancy_kind();
    const KindSettings settings = read_kind(kind, read_toml(toml, "c.toml"), {"c.toml", 1}, "[[distribution]]");
    return std::get<DistributionResult>(kind.make(settings, 1, {Engine::reference, {}}, files));
}

TEST(DiscrepancyKind, MeasuresTheFirstPointsOfAllSets)
{
    const DistributionResult result = result_of("methods = [\"random\", \"sobol\"]\npoints = 100\nsets = 200");
    ASSERT_EQ(result.numbers.size(), 4U);
    // The root of the mean square of random points, within four standard errors; the exponent is -1/2.
    EXPECT_NEAR(result.numbers[0].value, std::sqrt(5.0 / 36 / 100), 4 * *result.numbers[0].standard_error);
    EXPECT_LT(*result.numbers[0].standard_error, 0.1 * result.numbers[0].value);
    EXPECT_NEAR(result.numbers[1].value, -0.5, 0.05);
    EXPECT_LT(result.numbers[2].value, result.numbers[0].value / 4);
    EXPECT_LT(result.numbers[3].value, -0.8);
    ASSERT_EQ(result.tables.size(), 2U);
    std::vector<std::string> points;
    for (const auto& row : result.tables[0].rows) points.push_back(row.front());
    EXPECT_EQ(points, (std::vector<std::string>{"16", "32", "64", "100"}));
}

TEST(DiscrepancyKind, TakesTheSmallestSets)
{
    const DistributionResult result = result_of("methods = [\"halton\"]\npoints = 16\nsets = 2");
    EXPECT_EQ(result.numbers.size(), 1U);
    EXPECT_EQ(result.tables[0].rows.size(), 1U);
}

TEST(DiscrepancyKind, RefusesAMethodTwice)
{
    EXPECT_EQ(message_of([] { result_of("methods = [\"halton\", \"halton\"]"); }),
              "c.toml:1: methods = [\"halton\", \"halton\"]: must have each method once");
}

}
}
