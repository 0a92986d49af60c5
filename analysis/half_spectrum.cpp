#include "analysis/half_spectrum.hpp"

#include "analysis/radial_bin.hpp"

#include <tbb/parallel_for.h>

#include <cstdint>

namespace poissonlab {

std::vector<double> all_frequencies(const HalfSpectrum& half)
{
    const auto size = static_cast<std::size_t>(half.size);
    const std::size_t centre = size / 2, columns = half.columns(), rows = half.rows();
    const std::size_t slices = half.dimension == 3 ? size : 1;
    std::vector<double> power(size * size * slices);
    tbb::parallel_for(std::size_t{0}, slices * size, [&](std::size_t line) {
        const std::size_t v = line % size, w = line / size;
        const double* right = half.power.data() + (w * rows + v) * columns;
        const double* left = half.power.data() + ((half.slices() - 1 - w) * rows + rows - 1 - v) * columns;
        double* target = power.data() + line * size;
        for (std::size_t u = 0; u < centre; ++u) target[u] = left[centre - u];
        for (std::size_t u = centre; u < size; ++u) target[u] = right[u - centre];
    });
    return power;
}

HalfSpectrum half_of(const std::vector<double>& power, int dimension, int size)
{
    HalfSpectrum half{dimension, size, {}};
    const auto m = static_cast<std::size_t>(size);
    half.power.resize(half.columns() * half.rows() * half.slices());
    std::size_t at = 0;
    for (std::size_t w = 0; w < half.slices(); ++w) {
        for (std::size_t v = 0; v < half.rows(); ++v) {
            for (std::size_t u = m / 2; u <= m; ++u) {
                // Frequency M/2 stands in for -M/2, at the place of the negative frequency.
                const bool is_mirrored = u == m || v == m || (dimension == 3 && w == m);
                const std::size_t x = is_mirrored ? m - u : u, y = is_mirrored ? m - v : v;
                const std::size_t z = is_mirrored && dimension == 3 ? m - w : w;
                half.power[at++] = power[(z % m * m + y % m) * m + x % m];
            }
        }
    }
    return half;
}

std::vector<double> radial_means(const HalfSpectrum& half)
{
    const auto bins = static_cast<std::size_t>(half.size / 2);
    const std::int64_t centre = half.size / 2;
    const std::size_t lines = half.rows() * half.slices();
    // Sums of fixed parts, then of the parts in order: the same for any number of threads.
    constexpr std::size_t parts = 16;
    std::vector<double> sums(parts * bins), counts(parts * bins);
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
        double* const sum = sums.data() + part * bins;
        double* const count = counts.data() + part * bins;
        for (std::size_t line = lines * part / parts; line < lines * (part + 1) / parts; ++line) {
            const auto v = static_cast<std::int64_t>(line % half.rows()) - centre;
            const auto w = half.dimension == 3 ? static_cast<std::int64_t>(line / half.rows()) - centre : 0;
            const double* power = half.power.data() + line * half.columns();
            RadialBinWalk bin(v * v + w * w);
            for (std::int64_t u = 0; u < centre; ++u) {
                const std::size_t k = bin.of(u);
                if (k >= bins) break;
                const double weight = u == 0 ? 1 : 2; // the column u = 0 holds f and -f
                sum[k] += weight * power[u];
                count[k] += weight;
            }
        }
    });
    std::vector<double> means;
    for (std::size_t k = 1; k < bins; ++k) {
        double sum = 0, count = 0;
        for (std::size_t part = 0; part < parts; ++part) {
            sum += sums[part * bins + k];
            count += counts[part * bins + k];
        }
        means.push_back(sum / count);
    }
    return means;
}

}
