#include "analysis/measures/peak_anisotropy.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab {

std::optional<PeakAnisotropy> peak_anisotropy(const std::vector<RadialBin>& radial, int realizations)
{
    const RadialBin* peak = nullptr;
    for (const RadialBin& bin : radial)
        if (bin.samples >= least_peak_samples && std::isfinite(bin.anisotropy_db) &&
            (!peak || bin.anisotropy_db > peak->anisotropy_db))
            peak = &bin;
    if (!peak) return std::nullopt;
    PeakAnisotropy result{peak->anisotropy_db, peak->frequency, peak->samples};
    if (realizations > 1) result.standard_error_db = anisotropy_standard_error_db(peak->samples, realizations);
    return result;
}

double anisotropy_standard_error_db(std::size_t samples, int realizations)
{
    const double independent = static_cast<double>(samples) / 2;
    const double relative_variance = (2 + 2.0 / realizations) / independent;
    return 10 / std::numbers::ln10 * std::sqrt(relative_variance);
}

}
