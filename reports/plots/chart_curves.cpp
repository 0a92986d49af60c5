#include "reports/plots/chart_curves.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

Plot chart_plot(const CurveChart& chart)
{
    Plot plot;
    const auto axis = [](const ChartAxis& of) {
        return PlotAxis{.label = of.name, .low = of.low, .high = of.high, .step = of.step};
    };
    plot.x = axis(chart.x);
    plot.y = axis(chart.y);
    double least = chart.level, most = chart.level;
    for (const ChartCurve& of : chart.curves) {
        PlotCurve& curve = plot.curves.emplace_back();
        curve.index = plot.curves.size() - 1;
        curve.label = of.name;
        curve.color = of.color;
        for (const auto& [x, y] : of.places) {
            curve.x.push_back(x);
            curve.y.push_back(y);
            if (std::isfinite(y) && x >= chart.x.low && x <= chart.x.high)
                least = std::min(least, y), most = std::max(most, y);
        }
    }
    plot.y.high =
        std::min(chart.y.high, chart.y.low + chart.y.step * (1 + std::floor((most - chart.y.low) / chart.y.step)));
    plot.y.low += chart.y.step * std::max(0.0, std::floor((least - chart.y.low) / chart.y.step));
    if (chart.level > plot.y.low) plot.references.push_back({chart.level});
    plot.has_key = chart.curves.size() > 1;
    return plot;
}

}
