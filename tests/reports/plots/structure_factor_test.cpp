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
    // Lengths are in mean spacings, of which there are 32 along an axis.
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

TEST(StructureFactor, HasPowerLawsToCompareDeepCurvesWith)
{
    Curve deep = square_law();
    EXPECT_TRUE(structure_factor_plot({{0, "a", &deep}}, LengthUnit::absolute).slopes.empty());
    deep.points = 10'000; // 100 cycles are one a mean spacing
    deep.bins.front().power = 1e-8;
    const Plot plot = structure_factor_plot({{0, "a", &deep}}, LengthUnit::absolute);
    ASSERT_EQ(plot.slopes.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const SlopeMark& law = plot.slopes[i];
        EXPECT_EQ(law.right, 40);
        EXPECT_EQ(law.right_height, 0.03);
        const double slope = std::log(law.right_height / law.left_height) / std::log(law.right / law.left);
        EXPECT_NEAR(slope, 2.0 + 2 * static_cast<double>(i), 1e-9);
        EXPECT_GE(law.left_height, plot.y.low * (1 - 1e-12));
    }
    EXPECT_EQ(plot.slopes[0].name, "f^2");
}

TEST(StructureFactor, HasTheLineOfTheFit)
{
    const Curve curve = square_law();
    const auto fit = low_frequency_power(curve.bins, {2, 8});
    ASSERT_TRUE(fit);
    const Plot all = structure_factor_plot({{0, "a", &curve}}, LengthUnit::absolute);
    const Plot plot = structure_factor_alone(all, 0, curve, fit);
    ASSERT_EQ(plot.slopes.size(), 1u);
    const SlopeMark& line = plot.slopes.front();
    EXPECT_EQ(line.left, 2);
    EXPECT_EQ(line.right, 8);
    EXPECT_NEAR(line.left_height, 0.012, 1e-12);
    EXPECT_NEAR(line.right_height, 0.192, 1e-12);
    EXPECT_EQ(line.name, "f^{2.0}");
    EXPECT_TRUE(structure_factor_alone(all, 0, curve, std::nullopt).slopes.empty());
    // The part of a line from 0.012 to 0.192, what is above 0.048, which is half of it on logarithmic axes.
    Plot higher = all;
    higher.y.low = 0.048;
    const auto part = structure_factor_alone(higher, 0, curve, fit).slopes;
    ASSERT_EQ(part.size(), 1u);
    EXPECT_NEAR(part[0].left, 4, 1e-12);
    EXPECT_EQ(part[0].left_height, 0.048);
    EXPECT_NEAR(part[0].right_height, 0.192, 1e-12);
    higher.y.low = 0.2;
    EXPECT_TRUE(structure_factor_alone(higher, 0, curve, fit).slopes.empty());
    const auto text = gnuplot_picture(plot, "a").commands;
    EXPECT_THAT(text, HasSubstr("set logscale x\n"));
    EXPECT_THAT(text, HasSubstr("set arrow from 2, 0.012 to 8, 0.192 nohead"));
}

}
}
