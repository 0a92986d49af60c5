// Measures that say how even the pixels below a threshold are.
#include "analysis/measures/distance_statistics.hpp"
#include "analysis/spectra/cross_spectrum.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/distribution/masks/dither_mask.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The largest frequency that is looked at: of pictures that of two pixels a turn.
int spectrum_reach(const DitherMask& mask) { return static_cast<int>(std::min<std::uint32_t>(mask.size / 2, 512)); }

/// The mean over all frequencies of rings up to `end`, each as often as it is long.
double mean_power_below(const std::vector<double>& power, double end)
{
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < power.size() && static_cast<double>(k + 1) < end; ++k) {
        sum += static_cast<double>(k + 1) * power[k];
        weights += static_cast<double>(k + 1);
    }
    return weights > 0 ? sum / weights : 0;
}

}

ThresholdMeasures threshold_measures(const DitherMask& mask, std::uint32_t sixteenths)
{
    const bool is_below = sixteenths <= 8;
    PointSet points{2, {}};
    for (std::uint32_t i = 0; i < mask.pixels(); ++i) {
        if ((std::uint64_t{mask.ranks[i]} * 16 < std::uint64_t{sixteenths} * mask.levels) != is_below) continue;
        points.coordinates.push_back((i % mask.size + 0.5) / mask.size);
        points.coordinates.push_back((static_cast<double>(i / mask.size) + 0.5) / mask.size);
    }
    ThresholdMeasures measures;
    measures.pixels = points.size();
    if (points.size() < 2) return measures;
    measures.least_distance = std::round(min_toroidal_distance(points) * mask.size * 1e6) / 1e6;
    measures.mean_nearest = mean_nearest_distance(points) / max_min_distance(points.size(), 2);
    measures.power = cross_spectra({points}, spectrum_reach(mask)).power.front();
    measures.low_power = mean_power_below(measures.power, principal_frequency(points.size(), 2) / 2);
    return measures;
}

std::vector<DistributionNumber> dither_numbers(const std::vector<ThresholdMeasures>& measures)
{
    std::vector<DistributionNumber> numbers;
    for (std::size_t i = 0; i < measures.size(); ++i) {
        const std::string of = fmt::format("at threshold {}/16", i + 1);
        numbers.push_back({fmt::format("least_distance_{}", i + 1),
                           fmt::format("Least distance {}/16", i + 1),
                           measures[i].least_distance,
                           "pixels, " + of,
                           {},
                           true});
        numbers.push_back({fmt::format("mean_nearest_{}", i + 1),
                           fmt::format("Mean nearest distance {}/16", i + 1),
                           measures[i].mean_nearest,
                           "of that of the densest packing, " + of,
                           {},
                           true});
        numbers.push_back({fmt::format("low_power_{}", i + 1),
                           fmt::format("Low power {}/16", i + 1),
                           measures[i].low_power,
                           "of frequencies below half of the principal one, " + of,
                           {},
                           true});
    }
    return numbers;
}

DistributionTable dither_table(const std::vector<ThresholdMeasures>& measures)
{
    DistributionTable table{"Pixels below thresholds, from the middle on those above",
                            {"threshold", "pixels", "least distance, pixels", "mean nearest distance", "low power"},
                            {}};
    for (std::size_t i = 0; i < measures.size(); ++i)
        table.rows.push_back({fmt::format("{}/16", i + 1), fmt::format("{}", measures[i].pixels),
                              fmt::format("{:.3f}", measures[i].least_distance),
                              fmt::format("{:.3f}", measures[i].mean_nearest),
                              fmt::format("{:.4f}", measures[i].low_power)});
    return table;
}

CurveChart dither_curves(const std::vector<ThresholdMeasures>& measures)
{
    std::vector<ChartCurve> curves;
    std::size_t reach = 1;
    for (std::size_t i = 0; i < std::min<std::size_t>(measures.size(), 8); ++i) {
        ChartCurve curve{fmt::format("{}/16", i + 1), class_color(i), {}};
        reach = std::max(reach, measures[i].power.size());
        for (std::size_t k = 0; k < measures[i].power.size(); ++k)
            curve.places.push_back(
                {static_cast<double>(k + 1) / static_cast<double>(measures[i].power.size()), measures[i].power[k]});
        curves.push_back(std::move(curve));
    }
    return {{"frequency / Nyquist frequency", 0, 1, 0.2}, {"radially averaged power", 0, 3, 0.5}, 1, curves};
}

}
