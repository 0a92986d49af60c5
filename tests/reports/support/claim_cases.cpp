#include "tests/reports/support/claim_cases.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab::test {

ReportSeries& darts(MadeUpReport& report, const std::string& rho, std::size_t points, int dimension)
{
    return report.add("dart-throwing", {{"relative_radius", rho}}, points, dimension);
}

ReportSeries& jones(MadeUpReport& report, std::size_t points)
{
    return report.add("voronoi-darts", {{"relative_radius", "0.75"}}, points);
}

ReportSeries& relaxation(MadeUpReport& report, const std::string& factor, const std::string& attempts,
                         std::size_t points, int dimension)
{
    return report.add("relaxation-dart-throwing",
                      {{"initial_radius", "0.15"}, {"factor", factor}, {"attempts", attempts}}, points, dimension);
}

ReportSeries& lloyd(MadeUpReport& report, int iterations, std::size_t points, int dimension)
{
    return report.add("lloyd",
                      {{"iterations", std::to_string(iterations)}, {"start", "dart-throwing (relative_radius = 0.7)"}},
                      points, dimension);
}

void set_number(ReportSeries& series, const std::string& key, double value)
{
    const_cast<Series*>(series.stored)->measures.numbers[key] = {value, value / 100};
}

void set_oscillation(ReportSeries& series, double value)
{
    const_cast<Series*>(series.stored)->measures.oscillation = Oscillation{value, 100, 300, {}};
}

ReportSeries& with_target(MadeUpReport& report, const std::string& target, double nyquist)
{
    ReportSeries& series =
        report.add("target-spectrum", {{"target", target}, {"frequency", target == "step" ? "0.55" : "0.7"}});
    MadeUpReport::set_curve(series, {});
    set_number(series, "effective_nyquist", nyquist);
    return series;
}

void saturated(MadeUpReport& report, int dimension, double intercept)
{
    ReportSeries& series = report.add("dart-throwing", {{"stop", "saturation"}}, 16384, dimension);
    LowFrequencyPower power;
    power.intercept = intercept;
    power.intercept_standard_error = 0.0002;
    const_cast<Series*>(series.stored)->measures.low_frequency_power = power;
}

/// `speckle`: anisotropy between the peaks, in dB above chance.
ReportSeries& tiles(MadeUpReport& report, const std::string& kind, int set, int points_per_tile, double mean_peak,
                    double speckle)
{
    auto& series = report.add(kind + "-tiles", {{kind == "template" ? "tiles" : "colors", std::to_string(set)},
                                                {"points_per_tile", std::to_string(points_per_tile)}});
    MadeUpReport::set_curve(series, {});
    MadeUpReport::set_peaks(series, static_cast<int>(std::lround(std::sqrt(16384.0 / points_per_tile))), mean_peak);
    const_cast<Series*>(series.stored)->measures.numbers["off_lattice_anisotropy"] = {speckle, {}};
    return series;
}

void set_seconds(ReportSeries& series, double seconds)
{
    const_cast<Series*>(series.stored)->sample_seconds = {seconds};
}

/// A method beside three others: more anisotropic than they are, or not.
void among_others(MadeUpReport& report, const std::string& sampler, bool is_worse)
{
    for (const char* other : {"lloyd", "edge-tiles", "corner-tiles"})
        MadeUpReport::set_curve(report.add(other, {}), {.anisotropy = 1});
    MadeUpReport::set_curve(report.add(sampler, {}), {.anisotropy = is_worse ? 5.0 : 0.2});
}

/// Radii from `start` to `end`, there after so many of 128 iterations.
std::vector<double> relaxed(double start, double end, int settled)
{
    std::vector<double> radii;
    for (int i = 0; i <= 128; ++i)
        radii.push_back(start + (end - start) * std::min(1.0, static_cast<double>(i) / settled));
    return radii;
}

}
