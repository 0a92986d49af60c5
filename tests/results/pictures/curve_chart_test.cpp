// Curves of distributions, written, read, and as plots.
#include "results/pictures/curve_chart.hpp"

#include "reports/plots/distribution_curves.hpp"
#include "reports/plots/gnuplot_text.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

CurveChart some_chart()
{
    return {{"gap / mean gap", 0, 4, 1},
            {"part of gaps", 0, 1, 0.2},
            0.25,
            {{"points", "#2c728e", {{0, 0}, {1, 0.5}, {5, 0.9}}}, {"random", "#8a8f98", {{0.5, 0.3}}}}};
}

TEST(CurveChart, IsReadAsItWasWritten)
{
    const TemporaryFolder folder;
    folder.write("a-curves.json", curve_chart_json(some_chart()));
    EXPECT_EQ(read_curve_chart(folder.path() / "a-curves.json"), some_chart());
}

TEST(CurveChart, IsRefusedWhereItIsDamaged)
{
    const auto refusal = [](const std::string& from, const std::string& to) {
        const TemporaryFolder folder;
        std::string text = curve_chart_json(some_chart());
        text.replace(text.find(from), from.size(), to);
        folder.write("a-curves.json", text);
        return message_of([&] { read_curve_chart(folder.path() / "a-curves.json"); });
    };
    EXPECT_THAT(refusal("poissonlab-curves", "else"), HasSubstr("must be \"poissonlab-curves\""));
    EXPECT_THAT(refusal("#2c728e", "blue"), HasSubstr("must be #rrggbb"));
    EXPECT_THAT(refusal("\"high\":4.0", "\"high\":0"), HasSubstr("must be above low"));
    EXPECT_THAT(refusal("[0.0,1.0,5.0]", "[0.0,1.0]"), HasSubstr("must have as many numbers as x"));
}

/// The vertical axis ends at the tick above what is seen: 0.5, since 0.9 is beyond the right end.
TEST(CurveChart, IsAPlotWithAKeyBelow)
{
    const Plot plot = chart_plot(some_chart());
    EXPECT_DOUBLE_EQ(plot.y.high, 0.6);
    EXPECT_EQ(plot.x.high, 4);
    ASSERT_EQ(plot.references.size(), 1u);
    EXPECT_EQ(plot.references[0].height, 0.25);
    const GnuplotPicture picture = gnuplot_picture(plot, "stem");
    EXPECT_EQ(picture.width, panel_width);
    EXPECT_EQ(picture.height, panel_height + 3 * 16);
    EXPECT_THAT(picture.commands, HasSubstr("lc rgb '#2c728e'"));
    EXPECT_THAT(picture.commands, HasSubstr("title 'random'"));
    CurveChart one = some_chart();
    one.curves.pop_back();
    EXPECT_EQ(gnuplot_picture(chart_plot(one), "stem").height, panel_height);
}

}
}
