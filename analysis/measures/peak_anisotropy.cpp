#include "analysis/measures/peak_anisotropy.hpp"

#include "analysis/spectra/radial_bin.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

/// The chance that an isotropic set is said to have directions.
constexpr double anisotropy_level = 1e-3;

bool takes_part(const RadialBin& ring)
{
    return ring.samples >= least_peak_samples && ring.power >= least_peak_power && std::isfinite(ring.anisotropy_db);
}

/// The ratio of variance to squared mean in every direction of a ring between two others.
double ratio_by_slope(const RadialBin& before, const RadialBin& after)
{
    constexpr double least_power = 1e-30;
    const double slope = std::log(std::max(after.power, least_power) / std::max(before.power, least_power)) / 2;
    if (std::abs(slope) < 1e-4) return slope * slope / 12;
    return slope / 2 / std::tanh(slope / 2) - 1;
}

constexpr double errors_beyond_chance = 4;

struct Deviate
{
    double mean = 0, deviation = 0;
};

/// The standard deviation of the largest of independent normal deviates, by the distribution of how far it is below a
/// value that it does not reach.
double deviation_of_largest(const std::vector<Deviate>& deviates)
{
    constexpr double far = 8;
    constexpr int steps = 600;
    double top = -std::numeric_limits<double>::infinity(), bottom = top;
    for (const Deviate& d : deviates) {
        top = std::max(top, d.mean + far * d.deviation);
        bottom = std::max(bottom, d.mean - far * d.deviation);
    }
    const double step = (top - bottom) / steps;
    double first = 0, second = 0; // moments of the way down from the top
    for (int i = 0; i < steps; ++i) {
        const double way = (i + 0.5) * step;
        double below = 1; // the probability that all are
        for (const Deviate& d : deviates)
            below *= 0.5 * std::erfc((d.mean - (top - way)) / (std::numbers::sqrt2 * d.deviation));
        first += below * step;
        second += 2 * way * below * step;
    }
    return std::sqrt(std::max(0.0, second - first * first));
}

/// The standard error of the anisotropy of a ring, in dB, from that of each of its powers (delta method): the ratio of
/// variance to squared mean m has the slope 2 (P - m) / (n - 1) / m^2 - 2 ratio / (n m) over a power P, and bends by
/// 2 / (n - 1) / m^2. A slope is taken at a measured power, so that its square is too large by bend^2 times the
/// variance of the power: that is taken off, and a half of it is what the bend itself adds to the variance of the ratio
/// (second order). Where powers are equal, nearly all of the slope is such noise, and a half remains.
double ring_error_db(const RadialBin& ring, const Spectrum& mean)
{
    const double m = ring.power, n = static_cast<double>(ring.samples);
    const double ratio = std::pow(10, ring.anisotropy_db / 10);
    const double inner = std::round(ring.frequency) - 0.5, outer = inner + 1;
    const RadialBins bins(mean.size, 1, mean.box);
    const auto reach = [&](std::size_t axis) { return static_cast<std::int64_t>(outer * mean.box.sides[axis]); };
    const std::int64_t half = mean.size / 2, slices = mean.dimension == 3 ? reach(2) : 0;
    const double bend = 2 / (n - 1) / (m * m);
    double by_slope = 0, by_noise = 0;
    for (std::int64_t w = -slices; w <= slices; ++w)
        for (std::int64_t v = -reach(1); v <= reach(1); ++v)
            for (std::int64_t u = -reach(0); u <= reach(0); ++u) {
                const double squared = bins.squared(0, u) + bins.squared(1, v) + bins.squared(2, w);
                if (squared <= inner * inner || squared > outer * outer) continue;
                const std::int64_t slice = mean.dimension == 3 ? w + half : 0;
                const auto at = static_cast<std::size_t>((slice * mean.size + v + half) * mean.size + u + half);
                const double slope = 2 * (mean.power[at] - m) / (n - 1) / (m * m) - 2 * ratio / (n * m);
                const double noise = mean.variance[at] / mean.realizations;
                // f and -f have one power, and each counts here: a half of the square of twice the slope.
                by_slope += 2 * slope * slope * noise;
                by_noise += 2 * bend * bend * noise * noise;
            }
    return 10 / std::numbers::ln10 * std::sqrt(std::max(by_slope / 2, by_slope - by_noise / 2)) / ratio;
}

}

std::optional<PeakAnisotropy> peak_anisotropy(const std::vector<RadialBin>& radial)
{
    const RadialBin* peak = nullptr;
    for (const RadialBin& bin : radial)
        if (takes_part(bin) && (!peak || bin.anisotropy_db > peak->anisotropy_db)) peak = &bin;
    if (!peak) return std::nullopt;
    return PeakAnisotropy{peak->anisotropy_db, peak->frequency, peak->samples, {}, peak->power};
}

double peak_anisotropy_error_db(const std::vector<RadialBin>& radial, const PeakAnisotropy& peak, const Spectrum& mean)
{
    const int realizations = mean.realizations;
    std::vector<Deviate> rings;
    for (const RadialBin& bin : radial) {
        if (!takes_part(bin)) continue;
        const double chance = background_anisotropy_db(realizations);
        Deviate ring{chance, anisotropy_standard_error_db(bin.samples, realizations)};
        if (bin.anisotropy_db > chance + errors_beyond_chance * ring.deviation) {
            ring.mean = bin.anisotropy_db;
            if (bin.frequency == peak.frequency) ring.deviation = ring_error_db(bin, mean);
        }
        rings.push_back(ring);
    }
    return deviation_of_largest(rings);
}

std::optional<double> anisotropy_above_chance_db(const std::vector<RadialBin>& radial, int realizations)
{
    struct Ring
    {
        double above_db = 0, errors = 0;
    };
    std::vector<Ring> rings;
    for (std::size_t k = 1; k + 1 < radial.size(); ++k) {
        if (!takes_part(radial[k])) continue;
        const double expected = (1 + 1.0 / realizations) * (1 + ratio_by_slope(radial[k - 1], radial[k + 1])) - 1;
        const double above = radial[k].anisotropy_db - 10 * std::log10(expected);
        rings.push_back({above, above / anisotropy_standard_error_db(radial[k].samples, realizations)});
    }
    if (rings.empty()) return std::nullopt;
    double largest = 0;
    for (const Ring& ring : rings) {
        const double chance = std::erfc(ring.errors / std::numbers::sqrt2) / 2;
        if (chance * static_cast<double>(rings.size()) < anisotropy_level) largest = std::max(largest, ring.above_db);
    }
    return largest;
}

double anisotropy_standard_error_db(std::size_t samples, int realizations)
{
    const double independent = static_cast<double>(samples) / 2;
    const double relative_variance = (2 + 2.0 / realizations) / independent;
    return 10 / std::numbers::ln10 * std::sqrt(relative_variance);
}

}
