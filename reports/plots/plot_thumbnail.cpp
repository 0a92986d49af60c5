#include "reports/plots/plot_thumbnail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {

namespace {

constexpr double width = 160, height = 120;

double share(double value, const PlotAxis& axis) { return (value - axis.low) / (axis.high - axis.low); }

double row(double value, const Plot& plot) { return height * (1 - std::min(share(value, plot.y), 1.0)); }

std::string path_of(const PlotCurve& curve, const Plot& plot)
{
    std::string path;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::isfinite(curve.y[i]) && curve.x[i] <= plot.x.high)
            fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L',
                           width * share(curve.x[i], plot.x), row(curve.y[i], plot));
    return path;
}

}

std::string plot_thumbnail_svg(const Plot& plot)
{
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\">\n",
        width, height);
    for (const auto& line : plot.references)
        fmt::format_to(std::back_inserter(svg),
                       "<path fill=\"none\" stroke=\"#777\" stroke-dasharray=\"4 3\" d=\"M0 {:.1f}H{:g}\"/>\n",
                       row(line.height, plot), width);
    for (const auto& curve : plot.curves)
        fmt::format_to(std::back_inserter(svg),
                       "<path fill=\"none\" stroke=\"#000\" stroke-linejoin=\"round\" d=\"{}\"/>\n",
                       path_of(curve, plot));
    return svg + "</svg>\n";
}

}
