#include "analysis/spectra/radial_statistics.hpp"

#include "analysis/spectra/radial_bin.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace poissonlab {

namespace {

/// Calls visit(bin, power) for every sample of the bins in rows begin .. end - 1 of all slices.
template <class Visit>
void for_each_sample(const Spectrum& spectrum, const RadialBins& bins, std::int64_t begin, std::int64_t end,
                     const Visit& visit)
{
    const std::int64_t half = spectrum.size / 2;
    for (std::int64_t row = begin; row < end; ++row) {
        const std::int64_t v = row % spectrum.size - half;
        const std::int64_t w = spectrum.dimension == 3 ? row / spectrum.size - half : 0;
        const double* centre = spectrum.power.data() + row * spectrum.size + half;
        RadialBins::Walk bin(bins, 0, bins.squared(1, v) + bins.squared(2, w));
        for (std::int64_t u = 0; u < half; ++u) {
            const std::size_t k = bin.of(u);
            if (k >= bins.count()) break;
            visit(k, centre[u]);
            if (u > 0) visit(k, centre[-u]);
        }
    }
}

/// A sum over each bin's samples, and their number.
struct Sum
{
    double sum = 0;
    std::size_t samples = 0;
};

/// Sums of value(bin, power): of fixed parts, then of the parts in order, the same for any number of threads.
template <class Value>
std::vector<Sum> sums_of(const Spectrum& spectrum, const RadialBins& bins, const Value& value)
{
    constexpr std::int64_t parts = 16;
    const std::int64_t rows = static_cast<std::int64_t>(spectrum.size) * (spectrum.dimension == 3 ? spectrum.size : 1);
    std::array<std::vector<Sum>, parts> sums;
    tbb::parallel_for(std::int64_t{0}, parts, [&](std::int64_t part) {
        std::vector<Sum>& sum = sums[static_cast<std::size_t>(part)];
        sum.resize(bins.count());
        for_each_sample(spectrum, bins, rows * part / parts, rows * (part + 1) / parts,
                        [&](std::size_t k, double power) {
                            sum[k].sum += value(k, power);
                            ++sum[k].samples;
                        });
    });
    for (std::size_t part = 1; part < parts; ++part) {
        for (std::size_t k = 0; k < bins.count(); ++k) {
            sums[0][k].sum += sums[part][k].sum;
            sums[0][k].samples += sums[part][k].samples;
        }
    }
    return std::move(sums[0]);
}

double to_anisotropy_db(double variance, double mean, double zero)
{
    const double ratio = mean > zero ? variance / (mean * mean) : 0.0;
    return std::max(10.0 * std::log10(ratio), least_anisotropy_db);
}

}

std::vector<RadialBin> radial_statistics(const Spectrum& spectrum, double bin_width)
{
    // Bin 0, f = 0 alone, takes part in the sums and is dropped at the end.
    const RadialBins bins(spectrum.size, bin_width, spectrum.box);
    std::vector<RadialBin> radial(bins.count());
    const std::vector<Sum> sums = sums_of(spectrum, bins, [](std::size_t, double power) { return power; });
    for (std::size_t k = 0; k < radial.size(); ++k) {
        radial[k].frequency = bins.centre(k);
        radial[k].samples = sums[k].samples;
        radial[k].power = sums[k].sum / static_cast<double>(sums[k].samples);
    }

    // The variance in a second pass, about the mean: no cancellation.
    const std::vector<Sum> squares = sums_of(spectrum, bins, [&](std::size_t k, double power) {
        return (power - radial[k].power) * (power - radial[k].power);
    });
    for (std::size_t k = 1; k < radial.size(); ++k) {
        const double variance = squares[k].sum / static_cast<double>(radial[k].samples - 1);
        radial[k].anisotropy_db = to_anisotropy_db(variance, radial[k].power, zero_power(spectrum));
    }
    radial.erase(radial.begin());
    return radial;
}

double zero_power(const Spectrum& spectrum)
{
    return spectrum.transform_error * spectrum.transform_error * static_cast<double>(spectrum.points);
}

double background_anisotropy_db(int realizations) { return -10.0 * std::log10(static_cast<double>(realizations)); }

}
