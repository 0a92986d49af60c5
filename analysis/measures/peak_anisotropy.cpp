#include "analysis/measures/peak_anisotropy.hpp"

#include <algorithm>
#include <cmath>
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

}

std::optional<PeakAnisotropy> peak_anisotropy(const std::vector<RadialBin>& radial, int realizations)
{
    const RadialBin* peak = nullptr;
    for (const RadialBin& bin : radial)
        if (takes_part(bin) && (!peak || bin.anisotropy_db > peak->anisotropy_db)) peak = &bin;
    if (!peak) return std::nullopt;
    PeakAnisotropy result{peak->anisotropy_db, peak->frequency, peak->samples};
    if (realizations > 1) result.standard_error_db = anisotropy_standard_error_db(peak->samples, realizations);
    return result;
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
