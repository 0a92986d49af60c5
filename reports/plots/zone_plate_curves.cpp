#include "reports/plots/zone_plate_curves.hpp"

#include "analysis/zone_plate/zone_plate.hpp"
#include "reports/plots/plot_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {

namespace {

constexpr double most_frequency_shown = 2;
constexpr double most_error_shown = 0.5;
constexpr double finest_pixels_show = 0.5; // cycles per pixel

std::string data_block(const ZonePlateCurve& curve)
{
    std::string block = fmt::format("$plate{} << END\n", curve.index);
    for (const auto& bin : curve.bins)
        fmt::format_to(std::back_inserter(block), "{:.6g} {:.6g}\n", bin.frequency, bin.rms_error);
    return block + "END\n";
}

// Distances from the origin along the upper edge, of pictures of that size.
std::string distance_axis(double max_frequency, int size)
{
    return top_axis("distance from the origin", max_frequency / plate_frequency(1, size));
}

std::string frame(const ZonePlateScales& scales)
{
    auto commands = axes("frequency of the plate (cycles per pixel)", 0, scales.max_frequency,
                         {"RMS error", 0, scales.max_error, 0.1, 1.4});
    if (scales.max_frequency <= finest_pixels_show) return commands;
    return commands + fmt::format("set arrow from first {0}, graph 0 to first {0}, graph 1 nohead back lw 1 "
                                  "dt (2,3) lc rgb '{1}'\n"
                                  "set label 'finest that pixels show' at first {0}, graph 0.06 left offset 0.5,0 "
                                  "textcolor rgb '{1}'\n",
                                  finest_pixels_show, mark_color);
}

}

ZonePlateScales common_zone_plate_scales(const std::vector<ZonePlateCurve>& curves)
{
    double frequency = 0;
    double error = 0;
    for (const auto& curve : curves)
        for (const auto& bin : curve.bins) {
            frequency = std::max(frequency, bin.frequency);
            error = std::max(error, bin.rms_error);
        }
    return {std::min(frequency, most_frequency_shown), std::clamp(std::ceil(error / 0.1) * 0.1, 0.1, most_error_shown)};
}

GnuplotPicture plot_zone_plate_error(const ZonePlateCurve& curve, const ZonePlateScales& scales,
                                     const std::filesystem::path& stem)
{
    return {frame(scales) + distance_axis(scales.max_frequency, curve.size) + data_block(curve) +
                fmt::format("plot $plate{0} using 1:2 with lines {1}", curve.index, line_style(curve.index)),
            panel_width, panel_height, stem};
}

GnuplotPicture overlay_zone_plate_error(const std::vector<ZonePlateCurve>& curves, const ZonePlateScales& scales,
                                        const std::filesystem::path& stem)
{
    auto commands = frame(scales);
    const int size = curves.front().size;
    if (std::ranges::all_of(curves, [&](const auto& curve) { return curve.size == size; }))
        commands += distance_axis(scales.max_frequency, size);
    std::string plot;
    std::vector<KeyEntry> key;
    for (const auto& curve : curves) {
        commands += data_block(curve);
        plot += fmt::format("{}$plate{} using 1:2 with lines {} notitle", plot.empty() ? "plot " : ", ", curve.index,
                            line_style(curve.index));
        key.push_back({curve.index, curve.label});
    }
    return with_key(commands, plot, key, stem);
}

}
