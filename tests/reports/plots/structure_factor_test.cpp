// Power on logarithmic axes: decades that show all curves, and the line of the fitted exponent.
#include "reports/plots/curves.hpp"
#include "reports/plots/gnuplot_text.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// A curve of 1,024 points with the power 0.003 f^2 up to frequency 16, 1 beyond, and none at frequency 20.
Curve square_law()
{
    Curve curve;
    curve.points = 1024;
    curve.max_frequency = 32;
    for (int k = 1; k < 32; ++k)
        curve.bins.push_back({static_cast<double>(k),
                              k == 20   ? 0
                              : k <= 16 ? 0.003 * k * k
                                        : 1,
                              0, static_cast<std::size_t>(6 * k), 0.001});
    return curve;
}

TEST(StructureFactor, AxesAreDecadesAroundAllCurves)
{
    const Curve curve = square_law();
    const Plot plot = structure_factor_plot({{0, "a", &curve}}, LengthUnit::absolute);
    EXPECT_TRUE(plot.x.logarithmic && plot.y.logarithmic);
    EXPECT_EQ(plot.x.low, 1);
    EXPECT_DOUBLE_EQ(plot.y.low, 1e-3); // 0.003 is the least power
    EXPECT_DOUBLE_EQ(plot.y.high, 10);
    // In mean spacings, of which there are 32 along an axis.
    EXPECT_DOUBLE_EQ(structure_factor_plot({{0, "a", &curve}}, LengthUnit::spacing).x.low, 1.0 / 32);
}

TEST(StructureFactor, RingsWithoutPowerLieBelowTheAxis)
{
    const Curve curve = square_law();
    const Plot plot = structure_factor_plot({{0, "a", &curve}}, LengthUnit::absolute);
    EXPECT_GT(plot.curves[0].y[19], 0);
    EXPECT_LT(plot.curves[0].y[19], plot.y.low);
    EXPECT_DOUBLE_EQ(plot.curves[0].y[2], 0.027);
    for (const double low : plot.curves[0].low) EXPECT_GT(low, 0);
}

TEST(StructureFactor, HasTheLineOfTheFit)
{
    const Curve curve = square_law();
    const auto fit = low_frequency_power(curve.bins, {2, 8});
    ASSERT_TRUE(fit);
    const Plot all = structure_factor_plot({{0, "a", &curve}}, LengthUnit::absolute);
    const Plot plot = structure_factor_alone(all, 0, curve, fit);
    ASSERT_TRUE(plot.slope);
    EXPECT_EQ(plot.slope->left, 2);
    EXPECT_EQ(plot.slope->right, 8);
    EXPECT_NEAR(plot.slope->left_height, 0.012, 1e-12);
    EXPECT_NEAR(plot.slope->right_height, 0.192, 1e-12);
    EXPECT_EQ(plot.slope->name, "f^{2.0}");
    EXPECT_FALSE(structure_factor_alone(all, 0, curve, std::nullopt).slope);
    // The part of a line from 0.012 to 0.192, what is above 0.048, which is half of it on logarithmic axes.
    Plot higher = all;
    higher.y.low = 0.048;
    const auto part = structure_factor_alone(higher, 0, curve, fit).slope;
    ASSERT_TRUE(part);
    EXPECT_NEAR(part->left, 4, 1e-12);
    EXPECT_EQ(part->left_height, 0.048);
    EXPECT_NEAR(part->right_height, 0.192, 1e-12);
    higher.y.low = 0.2;
    EXPECT_FALSE(structure_factor_alone(higher, 0, curve, fit).slope);
    const auto text = gnuplot_picture(plot, "a").commands;
    EXPECT_THAT(text, HasSubstr("set logscale x\n"));
    EXPECT_THAT(text, HasSubstr("set arrow from 2, 0.012 to 8, 0.192 nohead"));
}

}
}
