#include "analysis/measures/low_frequency_power.hpp"

#include <cmath>

namespace poissonlab {

namespace {

struct PowerSample
{
    double x = 0;
    double y = 0;
    double weight = 0;
};

struct Line
{
    double intercept = 0;
    double intercept_error = 0;
    double slope = 0;
    double slope_error = 0;
};

/// The line of weighted least squares, about the means; at least three samples with different x.
Line fit(const std::vector<PowerSample>& samples)
{
    double weight = 0, x = 0, y = 0;
    for (const PowerSample& s : samples) weight += s.weight, x += s.weight * s.x, y += s.weight * s.y;
    x /= weight, y /= weight;
    double xx = 0, xy = 0;
    for (const PowerSample& s : samples) {
        xx += s.weight * (s.x - x) * (s.x - x);
        xy += s.weight * (s.x - x) * (s.y - y);
    }
    Line line;
    line.slope = xy / xx;
    line.intercept = y - line.slope * x;

    double squares = 0;
    for (const PowerSample& s : samples) {
        const double residual = s.y - y - line.slope * (s.x - x);
        squares += s.weight * residual * residual;
    }
    const double variance = squares / static_cast<double>(samples.size() - 2); // of weight 1
    line.slope_error = std::sqrt(variance / xx);
    line.intercept_error = std::sqrt(variance * (1 / weight + x * x / xx));
    return line;
}

}

FrequencyRange low_frequency_range(std::size_t points, int dimension)
{
    constexpr double slack = 1 + 1e-12; // for roots that are whole numbers
    return {1, low_frequency_end * slack * std::pow(static_cast<double>(points), 1.0 / dimension)};
}

std::optional<double> mean_power_in(const std::vector<RadialBin>& radial, const FrequencyRange& range)
{
    double power = 0, samples = 0;
    for (const RadialBin& bin : radial) {
        if (bin.frequency < range.begin || bin.frequency > range.end) continue;
        power += bin.power * static_cast<double>(bin.samples);
        samples += static_cast<double>(bin.samples);
    }
    if (samples == 0) return std::nullopt;
    return power / samples;
}

std::optional<LowFrequencyPower> low_frequency_power(const std::vector<RadialBin>& radial, const FrequencyRange& range)
{
    std::vector<PowerSample> logarithms, parabola;
    LowFrequencyPower result;
    for (const RadialBin& bin : radial) {
        const double f = bin.frequency;
        if (!(f > 0 && f >= range.begin && f <= range.end) || bin.samples == 0) continue;
        const auto weight = static_cast<double>(bin.samples);
        if (bin.power > 0) logarithms.push_back({std::log(f), std::log(bin.power), weight});
        if (parabola.empty()) result.begin = f;
        result.end = f;
        parabola.push_back({f * f, bin.power, weight});
    }
    if (logarithms.size() < 3) return std::nullopt;

    const Line exponent = fit(logarithms);
    const Line intercept = fit(parabola);
    result.exponent = exponent.slope;
    result.exponent_standard_error = exponent.slope_error;
    result.intercept = intercept.intercept;
    result.intercept_standard_error = intercept.intercept_error;
    result.bins = parabola.size();
    return result;
}

}
