#include "reports/plots/plot_thumbnail.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

constexpr double thumbnail_width = 160, thumbnail_height = 120, dash = 4, dash_gap = 3;

double share(double value, const PlotAxis& axis) { return (value - axis.low) / (axis.high - axis.low); }

double row(double value, const Plot& plot) { return thumbnail_height * (1 - std::min(share(value, plot.y), 1.0)); }

Line line_of(const PlotCurve& curve, const Plot& plot)
{
    Line line;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::isfinite(curve.y[i]) && curve.x[i] <= plot.x.high)
            line.points.push_back({thumbnail_width * share(curve.x[i], plot.x), row(curve.y[i], plot)});
    return line;
}

}

Drawing plot_thumbnail(const Plot& plot)
{
    Drawing drawing{thumbnail_width, thumbnail_height, {}};
    for (const auto& reference : plot.references) {
        const double y = row(reference.height, plot);
        for (double x = 0; x < thumbnail_width; x += dash + dash_gap)
            drawing.shapes.push_back({Line{{{x, y}, {x + dash, y}}}, {}, "#777777", 1});
    }
    for (const auto& curve : plot.curves) drawing.shapes.push_back({line_of(curve, plot), {}, "#000000", 1});
    return drawing;
}

}
