#include "reports/plots/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {

bool has_curve(const Plot& plot, std::size_t index)
{
    return std::ranges::find(plot.curves, index, &PlotCurve::index) != plot.curves.end();
}

Plot alone(const Plot& all, std::size_t index)
{
    Plot plot = all;
    std::erase_if(plot.curves, [&](const PlotCurve& curve) { return curve.index != index; });
    plot.x.high = plot.curves.front().end;
    return plot;
}

Plot together(Plot all)
{
    all.x.high = std::ranges::max(all.curves, {}, &PlotCurve::end).end;
    all.is_overlay = true;
    for (auto& curve : all.curves)
        if (!curve.has_bars) curve.low = curve.high = {};
    return all;
}

double highest(const std::vector<PlotCurve>& curves, double least)
{
    for (const auto& curve : curves)
        for (const double value : curve.y)
            if (std::isfinite(value)) least = std::max(least, value);
    return least;
}

/// The palette follows that of Okabe and Ito, whose colours people with colour deficiencies tell apart.
const std::vector<CurveColor>& palette()
{
    static const std::vector<CurveColor> colors = {
        {"#0072b2", "#4aa8e8"}, {"#d55e00", "#f08a3c"}, {"#009e73", "#2fc89b"}, {"#c4569a", "#e58cc4"},
        {"#b88600", "#dcae3a"}, {"#3aa0dc", "#8fd0f5"}, {"#555555", "#b5b5b5"}};
    return colors;
}

const std::vector<std::string>& dash_patterns()
{
    static const std::vector<std::string> patterns = {"", "8 4", "2 3", "10 3 2 3"};
    return patterns;
}

std::string curve_color(std::size_t index) { return palette()[index % palette().size()].light; }

const std::string& curve_dashes(std::size_t index)
{
    return dash_patterns()[index / palette().size() % dash_patterns().size()];
}

std::string palette_css()
{
    const auto rules = [](const char* CurveColor::*ground) {
        std::string text = ":root {";
        for (std::size_t i = 0; i < palette().size(); ++i)
            fmt::format_to(std::back_inserter(text), " --curve-{}: {};", i, palette()[i].*ground);
        return text + " }";
    };
    return fmt::format("{0}\n@media (prefers-color-scheme: dark) {{ {1} }}\n@media print {{ {0} }}\n",
                       rules(&CurveColor::light), rules(&CurveColor::dark));
}

std::string plain_words(const std::string& label)
{
    std::string text;
    std::ranges::copy_if(label, std::back_inserter(text), [](char c) { return c != '{' && c != '}'; });
    return text;
}

}
