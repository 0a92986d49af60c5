// Pairs of points of three classes in a rectangle and in a polygon with a hole, against spatstat.
#include "analysis/classes/class_pairs.hpp"
#include "tests/analysis/classes/spatstat_classes.hpp"
#include "tests/analysis/regions/spatstat_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace poissonlab {
namespace {

class SpatstatClasses : public testing::TestWithParam<bool>
{
protected:
    SpatstatClasses()
    {
        for (std::size_t i = 0; i < all.size(); ++i) {
            std::vector<double>& own = classes[test::spatstat_classes[i]].coordinates;
            own.insert(own.end(), all[i].begin(), all[i].end());
        }
        steps.step = test::spatstat_reach / region->side() / test::spatstat_count;
        steps.count = test::spatstat_count;
        steps.half_width = 0.15 * region->unit_length() / std::sqrt(static_cast<double>(all.size()));
    }

    bool is_rectangle = GetParam();
    const test::SpatstatClassNumbers& expected =
        is_rectangle ? test::spatstat_classes_in_rectangle : test::spatstat_classes_in_polygon;
    std::shared_ptr<const FramedRegion> region = std::make_shared<const FramedRegion>(
        is_rectangle ? test::spatstat_rectangle : test::spatstat_polygon, "region");
    ClassPlace place{region};
    PointSet all = region->framed({2, test::spatstat_classed_points}, "points");
    PointSet classes[3]{{2, {}}, {2, {}}, {2, {}}};
    ClassDistanceSteps steps;
};

TEST_P(SpatstatClasses, PairCorrelationsAreTheSame)
{
    std::size_t pair = 0;
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i <= j; ++i, ++pair) {
            const std::vector<double> g = class_pair_correlation(classes[i], classes[j], place, steps);
            ASSERT_EQ(g.size(), expected.g[pair].size());
            for (std::size_t k = 0; k < g.size(); ++k) {
                const double exact = expected.g[pair][k], on_grid = expected.pcf[pair][k];
                // spatstat's exact areas of polygons are those of its polygon clipper, whose corners are whole numbers.
                EXPECT_NEAR(g[k], exact, std::max((is_rectangle ? 1e-11 : 1e-7) * exact, 1e-12)) << i << j << " " << k;
                // pcf() and pcfcross() spread pairs over a grid of 10 / 2560, and take areas of polygons from pixels.
                EXPECT_NEAR(g[k], on_grid, std::max((is_rectangle ? 3e-4 : 1e-2) * on_grid, 2e-3))
                    << i << j << " " << k;
            }
        }
}

TEST_P(SpatstatClasses, NearestDistancesAreTheSame)
{
    for (std::size_t from = 0; from < 3; ++from)
        for (std::size_t to = 0; to < 3; ++to)
            EXPECT_NEAR(cross_nearest(classes[from], classes[to], place).mean * region->side(),
                        expected.nearest[from][to], 1e-12)
                << from << to;
}

TEST_P(SpatstatClasses, MarkCorrelationIsTheSame)
{
    const std::vector<double> found = mark_correlation(all, test::spatstat_classes, place, steps, 0).values;
    ASSERT_EQ(found.size(), expected.marks.size());
    // In 0.38 of all pairs both points are of one class: no mark correlation is larger than the inverse.
    const double largest = 180.0 * 179 / (30 * 29 + 60 * 59 + 90 * 89);
    for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k], expected.marks[k], std::max((is_rectangle ? 1e-11 : 1e-7) * found[k], 1e-12)) << k;
        // Pairs of markcorr() are not divided by their distance d, which is off by 3/8 of the kernel's half width h on
        // average: weights within the kernel differ by 3 h / (8 d), and the mean by half of that times the range of
        // its values. markcorr() knows no pair beyond the last distance, so that this one is left out.
        const double distance = steps.step * static_cast<double>(k + 1);
        if (k + 1 == found.size()) break;
        EXPECT_NEAR(found[k], expected.markcorr[k], 3 * steps.half_width / (8 * distance) * largest / 2) << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Windows, SpatstatClasses, testing::Bool(),
                         [](const auto& window) { return window.param ? "Rectangle" : "Polygon"; });

}
}
