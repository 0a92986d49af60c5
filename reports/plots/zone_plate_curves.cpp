#include "reports/plots/zone_plate_curves.hpp"

#include "analysis/zone_plate/zone_plate_reference.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

constexpr double most_frequency_shown = 2;
constexpr double most_error_shown = 0.5;
constexpr double finest_pixels_show = 0.5; // cycles per pixel

/// Distances along the upper edge, of pictures of that size.
TopAxis distance_axis(double max_frequency, int size)
{
    return {"distance from the origin", max_frequency / plate_frequency(1, size)};
}

}

Plot zone_plate_plot(const std::vector<ZonePlateCurve>& curves)
{
    Plot plot;
    double end = 0;
    for (const auto& source : curves) {
        PlotCurve curve{source.index, source.label};
        for (const auto& bin : *source.bins) {
            curve.x.push_back(bin.frequency);
            curve.y.push_back(bin.rms_error);
            end = std::max(end, bin.frequency);
        }
        plot.curves.push_back(std::move(curve));
    }
    end = std::min(end, most_frequency_shown);
    for (auto& curve : plot.curves) curve.end = end;
    const double top = std::clamp(std::ceil(highest(plot.curves, 0) / 0.1) * 0.1, 0.1, most_error_shown);
    plot.x = {.label = "frequency of the plate (cycles per pixel)"};
    plot.y = {.label = "RMS error", .high = top, .step = 0.1};
    if (end > finest_pixels_show) plot.marks = {{finest_pixels_show, "finest that pixels show", false, 0.06}};
    const int size = curves.front().size;
    if (std::ranges::all_of(curves, [&](const auto& curve) { return curve.size == size; }))
        plot.top = distance_axis(end, size);
    return plot;
}

Plot zone_plate_alone(const Plot& all, std::size_t index, int size)
{
    Plot plot = alone(all, index);
    plot.top = distance_axis(plot.x.high, size);
    return plot;
}

}
