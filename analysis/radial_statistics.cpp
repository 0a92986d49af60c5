#include "analysis/radial_statistics.hpp"

#include "analysis/radial_bin.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace poissonlab {

namespace {

/// Calls visit(bin, power) for every sample of bins 0 .. M/2 - 1.
template <class Visit>
void for_each_sample(const Spectrum& spectrum, const Visit& visit)
{
    const std::int64_t half = spectrum.size / 2;
    const std::int64_t slices = spectrum.dimension == 3 ? half : 0;
    const double* centre = spectrum.power.data() + half;
    for (std::int64_t w = -slices; w < std::max<std::int64_t>(slices, 1); ++w) {
        for (std::int64_t v = -half; v < half; ++v, centre += spectrum.size) {
            RadialBinWalk bin(v * v + w * w);
            for (std::int64_t u = 0; u < half; ++u) {
                const std::size_t k = bin.of(u);
                if (k >= static_cast<std::size_t>(half)) break;
                visit(k, centre[u]);
                if (u > 0) visit(k, centre[-u]);
            }
        }
    }
}

/// Powers up to this are zeros: the square of the transform's error, over N.
double zero_power(const Spectrum& spectrum)
{
    return spectrum.transform_error * spectrum.transform_error * static_cast<double>(spectrum.points);
}

double to_anisotropy_db(double variance, double mean, double zero)
{
    const double ratio = mean > zero ? variance / (mean * mean) : 0.0;
    return std::max(10.0 * std::log10(ratio), least_anisotropy_db);
}

}

std::vector<RadialBin> radial_statistics(const Spectrum& spectrum)
{
    // Bin 0, f = 0 alone, takes part in the sums and is dropped at the end.
    const auto bins = static_cast<std::size_t>(spectrum.size / 2);
    std::vector<RadialBin> radial(bins);
    for_each_sample(spectrum, [&](std::size_t k, double power) {
        radial[k].power += power;
        ++radial[k].samples;
    });
    for (std::size_t k = 0; k < bins; ++k) {
        radial[k].frequency = static_cast<double>(k);
        radial[k].power /= static_cast<double>(radial[k].samples);
    }

    // The variance in a second pass, about the mean: no cancellation.
    std::vector<double> squares(bins);
    for_each_sample(spectrum, [&](std::size_t k, double power) {
        squares[k] += (power - radial[k].power) * (power - radial[k].power);
    });
    for (std::size_t k = 1; k < bins; ++k) {
        const double variance = squares[k] / static_cast<double>(radial[k].samples - 1);
        radial[k].anisotropy_db = to_anisotropy_db(variance, radial[k].power, zero_power(spectrum));
    }
    if (!radial.empty()) radial.erase(radial.begin());
    return radial;
}

double background_anisotropy_db(int realizations)
{
    return -10.0 * std::log10(static_cast<double>(realizations));
}

}
