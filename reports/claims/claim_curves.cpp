#include "reports/claims/claim_curves.hpp"

#include "analysis/measures/peak_anisotropy.hpp"
#include "analysis/statistics/welch.hpp"
#include "base/geometry/relative_radius.hpp"
#include "reports/claims/findings.hpp"
#include "results/periodograms.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::size_t enough_samples = 100; ///< of a ring, for anisotropy that chance does not dominate

/// N^(1/d): frequencies over it are in cycles per mean spacing.
double frequency_unit(const ReportSeries& series)
{
    return std::pow(static_cast<double>(series.stored->points), 1.0 / series.run->dimension);
}

/// The power at a frequency, between two rings in proportion; nothing outside of the curve.
std::optional<double> power_at(const std::vector<RadialBin>& bins, double frequency)
{
    const auto above = std::ranges::lower_bound(bins, frequency, {}, &RadialBin::frequency);
    if (above == bins.end()) return std::nullopt;
    if (above->frequency == frequency) return above->power;
    if (above == bins.begin()) return std::nullopt;
    const RadialBin& below = *(above - 1);
    const double part = (frequency - below.frequency) / (above->frequency - below.frequency);
    return below.power + part * (above->power - below.power);
}

/// Below this a ring has no power but that of rounding.
constexpr double least_ring_power = 1e-9;

std::vector<const RadialBin*> rings_with_directions(const ReportSeries& series)
{
    std::vector<const RadialBin*> rings;
    for (const RadialBin& bin : series.curve.bins)
        if (bin.samples >= enough_samples && bin.power > least_ring_power) rings.push_back(&bin);
    return rings;
}

Estimate mean_with_scatter(const std::vector<double>& values)
{
    const SampleMean mean = sample_mean(values);
    return {mean.value, values.size() > 1 ? std::optional(mean.standard_error) : std::nullopt};
}

}

Estimate mean_excess_anisotropy(const ReportSeries& series)
{
    std::vector<double> excess;
    for (const RadialBin* ring : rings_with_directions(series))
        excess.push_back(ring->anisotropy_db - series.curve.background_db);
    return excess.empty() ? Estimate{} : mean_with_scatter(excess);
}

Estimate peak_excess_anisotropy(const ReportSeries& series)
{
    const RadialBin* largest = nullptr;
    for (const RadialBin* ring : rings_with_directions(series))
        if (largest == nullptr || ring->anisotropy_db > largest->anisotropy_db) largest = ring;
    if (largest == nullptr) return {};
    return {largest->anisotropy_db - series.curve.background_db,
            anisotropy_standard_error_db(largest->samples, periodograms_of(*series.stored))};
}

RadialBin power_peak(const ReportSeries& series)
{
    return *std::ranges::max_element(series.curve.bins, {}, &RadialBin::power);
}

std::optional<Estimate> rise_width(const ReportSeries& series)
{
    const auto& bins = series.curve.bins;
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(bins, {}, &RadialBin::power) - bins.begin());
    // Down from the peak: the first rings hold few samples, and their noise is no rise.
    const auto crossing = [&](double power) -> std::optional<Estimate> {
        for (std::size_t i = peak; i > 0; --i) {
            const RadialBin &below = bins[i - 1], &above = bins[i];
            if (below.power >= power || above.power < power) continue;
            const double slope = (above.frequency - below.frequency) / (above.power - below.power);
            const double error = std::max(below.power_error, above.power_error) * slope;
            return Estimate{below.frequency + (power - below.power) * slope, error};
        }
        return std::nullopt;
    };
    const auto low = crossing(0.25), high = crossing(0.75);
    if (!low || !high) return std::nullopt;
    const Estimate width = difference_of(*high, *low);
    return Estimate{width.value / frequency_unit(series), *width.standard_error / frequency_unit(series)};
}

double usual_principal_frequency(const ReportSeries& series)
{
    return 1 / (0.75 * max_min_distance(series.stored->points, series.run->dimension));
}

std::optional<Estimate> mean_power(const ReportSeries& series, double low, double high)
{
    double sum = 0, samples = 0, squared_errors = 0;
    for (const auto& bin : series.curve.bins) {
        if (bin.frequency < low || bin.frequency > high) continue;
        const auto weight = static_cast<double>(bin.samples);
        sum += bin.power * weight;
        squared_errors += bin.power_error * bin.power_error * weight * weight;
        samples += weight;
    }
    if (samples == 0) return std::nullopt;
    return Estimate{sum / samples, std::sqrt(squared_errors) / samples};
}

std::vector<double> differences_of_curves(const ReportSeries& a, const ReportSeries& b)
{
    const double scale = frequency_unit(b) / frequency_unit(a);
    std::vector<double> differences;
    for (const RadialBin& ring : a.curve.bins) {
        const auto other = power_at(b.curve.bins, ring.frequency * scale);
        if (ring.samples >= enough_samples && other) differences.push_back(ring.power - *other);
    }
    return differences;
}

std::optional<Estimate> distance_of_curves(const ReportSeries& a, const ReportSeries& b)
{
    std::vector<double> differences = differences_of_curves(a, b);
    for (double& difference : differences) difference = std::abs(difference);
    return differences.empty() ? std::nullopt : std::optional(mean_with_scatter(differences));
}

}
