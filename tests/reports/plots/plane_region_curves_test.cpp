#include "reports/plots/distribution_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Rows of random points of two a square, whose band is a tenth to either side.
std::vector<RegionCurveRow> random_rows()
{
    std::vector<RegionCurveRow> rows;
    for (int k = 1; k <= 20; ++k) {
        RegionCurveRow row;
        row.distance = 0.1 * k;
        const double circle = std::numbers::pi * row.distance * row.distance, share = 1 - std::exp(-2 * circle);
        row.k_isotropic = circle;
        row.value = {1, circle, share, share, 1};
        for (std::size_t f = 0; f < region_functions; ++f) {
            row.low[f] = 0.9 * row.value[f];
            row.high[f] = 1.1 * row.value[f];
        }
        rows.push_back(row);
    }
    return rows;
}

TEST(PlaneRegionCurves, OfRandomPointsLieOnTheirFormulas)
{
    const auto rows = random_rows();
    const PlaneRegionCurves curves{3, &rows, 2, true};
    const Plot l = region_l_plot(curves);
    ASSERT_EQ(l.curves.size(), 2) << "both corrections";
    for (const PlotCurve& curve : l.curves)
        for (const double y : curve.y) EXPECT_NEAR(y, 0, 1e-15);
    EXPECT_LT(l.curves[0].low.back(), 0);
    EXPECT_LT(l.y.low, l.curves[0].low.back());
    EXPECT_EQ(l.curves[0].index, 3);
    const Plot nearest = region_distance_plot(curves, RegionFunction::nearest);
    ASSERT_EQ(nearest.curves.size(), 2) << "estimate and formula";
    for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_NEAR(nearest.curves[0].y[k], nearest.curves[1].y[k], 1e-12);
    EXPECT_EQ(region_distance_plot({3, &rows, 2, false}, RegionFunction::nearest).curves.size(), 1);
}

TEST(PlaneRegionCurves, AxesEndWhereNothingChangesAnyMore)
{
    auto rows = random_rows();
    const PlaneRegionCurves curves{0, &rows, 2, true};
    EXPECT_NEAR(region_j_plot(curves).x.high, 2, 1e-12);
    for (std::size_t k = 5; k < rows.size(); ++k) rows[k].value[4] = rows[k].high[4] = std::nan("");
    EXPECT_NEAR(region_j_plot(curves).x.high, 0.5, 1e-12);
    for (std::size_t k = 3; k < rows.size(); ++k) rows[k].value[2] = rows[k].value[3] = 1;
    EXPECT_NEAR(region_distance_plot(curves, RegionFunction::empty_space).x.high, 1.6 * 0.4, 1e-12);
}

}
}
