#include "reports/plots/pair_correlation_curves.hpp"

#include "reports/plots/plot_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {

namespace {

constexpr double most_value_shown = 5;

// Distance and value, then the value one standard error lower and higher.
std::string data_block(const PairCorrelationCurve& curve)
{
    std::string block = fmt::format("$pairs{} << END\n", curve.index);
    for (const auto& bin : curve.bins)
        fmt::format_to(std::back_inserter(block), "{:.6g} {:.6g} {:.6g} {:.6g}\n", bin.distance / curve.unit, bin.value,
                       bin.value - bin.standard_error, bin.value + bin.standard_error);
    return block + "END\n";
}

std::string frame(const PairCorrelationScales& scales)
{
    return axes("distance / largest possible minimum distance", 0, scales.max_distance,
                {"pair correlation", 0, scales.max_value, scales.max_value > 2.5 ? 1 : 0.5, 1.4}) +
           reference_line(1);
}

std::string radius_mark(const PairCorrelationCurve& curve, const PairCorrelationScales& scales)
{
    if (!curve.relative_radius || *curve.relative_radius > scales.max_distance) return {};
    const bool room_on_the_left = *curve.relative_radius > 0.15 * scales.max_distance;
    return upright_mark(*curve.relative_radius, "d_{min}", room_on_the_left);
}

}

PairCorrelationScales common_pair_correlation_scales(const std::vector<PairCorrelationCurve>& curves)
{
    double distance = 0;
    double value = 0;
    for (const auto& curve : curves)
        for (const auto& bin : curve.bins) {
            distance = std::max(distance, bin.distance / curve.unit);
            value = std::max(value, bin.value);
        }
    return {std::ceil(distance), std::clamp(std::ceil(2.2 * value) / 2, 1.5, most_value_shown)};
}

GnuplotPicture plot_pair_correlation(const PairCorrelationCurve& curve, const PairCorrelationScales& scales,
                                     const std::filesystem::path& stem)
{
    return {frame(scales) + radius_mark(curve, scales) + data_block(curve) +
                fmt::format("plot $pairs{0} using 1:2 with lines {1}, $pairs{0} using 1:3:4 with filledcurves "
                            "fc rgb '{2}' fs transparent solid 0.25 noborder",
                            curve.index, line_style(curve.index), curve_color(curve.index)),
            panel_width, panel_height, stem};
}

GnuplotPicture overlay_pair_correlation(const std::vector<PairCorrelationCurve>& curves,
                                        const PairCorrelationScales& scales, const std::filesystem::path& stem)
{
    auto commands = frame(scales);
    std::string plot;
    std::vector<KeyEntry> key;
    for (const auto& curve : curves) {
        commands += data_block(curve);
        plot += fmt::format("{}$pairs{} using 1:2 with lines {} notitle", plot.empty() ? "plot " : ", ", curve.index,
                            line_style(curve.index));
        key.push_back({curve.index, curve.label});
    }
    return with_key(commands, plot, key, stem);
}

}
