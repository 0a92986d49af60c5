// Plots as comma-separated values and for LaTeX.
#include "reports/plots/plot_export.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::Not;

PlotCurve curve(std::size_t index, const std::string& label)
{
    PlotCurve result;
    result.index = index;
    result.label = label;
    result.x = {0, 0.1, 2};
    result.y = {1, std::nan(""), 3.5};
    return result;
}

std::size_t count(const std::string& text, const std::string& words)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
    return found;
}

TEST(PlotCsv, HasALineForEachPlace)
{
    Plot plot;
    plot.curves = {curve(0, "a \"b\", c"), curve(1, "d")};
    plot.curves[1].low = {0.5, 0, 3};
    plot.curves[1].high = {1.5, 1, 4};
    EXPECT_EQ(plot_csv(plot), "curve,x,y,low,high,dot\n"
                              "\"a \"\"b\"\", c\",0,1,,,\n"
                              "\"a \"\"b\"\", c\",0.1,,,,\n"
                              "\"a \"\"b\"\", c\",2,3.5,,,\n"
                              "\"d\",0,1,0.5,1.5,\n"
                              "\"d\",0.1,,0,1,\n"
                              "\"d\",2,3.5,3,4,\n");
}

TEST(PlotLatex, HasTheCurvesTheirGapsAndALegend)
{
    Plot plot;
    plot.x = {.label = "frequency 1/d_{min}", .low = 0, .high = 2};
    plot.y = {.label = "power", .low = 0.01, .high = 10, .logarithmic = true};
    plot.curves = {curve(0, "rho = 50 %"), curve(3, "ρ_1 & more")};
    plot.references = {{.height = 1, .text = "white"}};
    plot.marks = {{.x = 1, .name = "Nyquist"}};
    const std::string text = plot_latex(plot);
    EXPECT_EQ(count(text, "\\addplot"), 2U);
    EXPECT_THAT(text, HasSubstr("(0,1)\n(0.1,nan)\n(2,3.5)\n"));
    EXPECT_THAT(text, HasSubstr("\\addlegendentry{rho = 50 \\%}"));
    EXPECT_THAT(text, HasSubstr("\\addlegendentry{$\\rho$\\_1 \\& more}"));
    EXPECT_THAT(text, HasSubstr("xlabel={frequency 1/d$_{\\mathrm{min}}$}, xmin=0, xmax=2"));
    EXPECT_THAT(text, HasSubstr("ymode=log"));
    EXPECT_THAT(text, HasSubstr("{white}"));
    EXPECT_THAT(text, HasSubstr("{Nyquist}"));
    // Groups and environments close.
    EXPECT_EQ(count(text, "\\begin"), count(text, "\\end"));
    EXPECT_EQ(count(text, "{"), count(text, "}"));
    plot.curves.pop_back();
    EXPECT_THAT(plot_latex(plot), Not(HasSubstr("legend")));
}

TEST(PlotLatex, DrawsBandsOfCurvesThatAreAloneAndBarsOfAll)
{
    Plot plot;
    plot.curves = {curve(0, "a")};
    plot.curves[0].low = {0.5, std::nan(""), 3};
    plot.curves[0].high = {1.5, std::nan(""), 4};
    EXPECT_THAT(plot_latex(plot),
                HasSubstr("fill opacity=0.25, forget plot] coordinates {\n(0,0.5)\n(2,3)\n(2,4)\n(0,1.5)\n};"));
    plot.curves[0].has_bars = true;
    EXPECT_THAT(plot_latex(plot), HasSubstr("(0,0.5)\n(0,1.5)\n(0,nan)\n(2,3)\n(2,4)\n(2,nan)\n};"));
}

TEST(LatexWords, EscapeWhatCommandsLatex)
{
    EXPECT_EQ(latex_words("N^{−1/2}"), "N$^{\\mathrm{-1/2}}$");
    EXPECT_EQ(latex_words("50% of #1 & {a_b} ~ \\x$"),
              "50\\% of \\#1 \\& \\{a\\_b\\} \\textasciitilde{} \\textbackslash{}x\\$");
    EXPECT_EQ(latex_words("−10 dB, ρ ≤ 1"), "$-$10 dB, $\\rho$ $\\leq$ 1");
}

}
}
