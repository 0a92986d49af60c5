#include "analysis/spectra/half_spectrum.hpp"

#include "analysis/spectra/radial_bin.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>

namespace poissonlab {

std::vector<double> all_frequencies(std::span<const double> half, int dimension, int size, double factor)
{
    const auto m = static_cast<std::size_t>(size);
    const std::size_t centre = m / 2, rows = m + 1, lines = dimension == 3 ? rows : 1;
    const std::size_t middle = dimension == 3 ? m : 1; // frequencies along y between those along z and x
    std::vector<double> power;
    power.reserve(m * m * middle);
    ask_for_large_pages(power.data(), m * m * middle * sizeof(double));
    power.resize(m * m * middle);
    // Rows become columns by tiles: long steps through memory are slow.
    constexpr std::size_t height = 64, width = 8;
    tbb::parallel_for(std::size_t{0}, (m + height - 1) / height * middle, [&](std::size_t task) {
        const std::size_t begin = task / middle * height, count = std::min(height, m - begin), v = task % middle;
        for (std::size_t x = 0; x < m; x += width) {
            double tile[height][width];
            for (std::size_t i = 0; i < width && x + i < m; ++i) {
                const bool is_mirrored = x + i < centre;
                const std::size_t u = is_mirrored ? centre - x - i : x + i - centre;
                const double* line = half.data() + (u * lines + (is_mirrored ? lines - 1 - v : v)) * rows;
                for (std::size_t row = 0; row < count; ++row) {
                    tile[row][i] = factor * line[is_mirrored ? rows - 1 - begin - row : begin + row];
                }
            }
            for (std::size_t row = 0; row < count; ++row) {
                std::copy_n(tile[row], std::min(width, m - x), &power[((begin + row) * middle + v) * m + x]);
            }
        }
    });
    return power;
}

HalfSpectrum half_of(const std::vector<double>& power, int dimension, int size)
{
    HalfSpectrum half{dimension, size, {}};
    const auto m = static_cast<std::size_t>(size);
    const std::size_t middle = dimension == 3 ? m : 1;
    half.power.reserve(half.columns() * half.lines() * half.rows());
    for (std::size_t u = m / 2; u <= m; ++u) {
        for (std::size_t v = 0; v < half.lines(); ++v) {
            for (std::size_t w = 0; w <= m; ++w) {
                // Frequency M/2 stands in for -M/2, at the place of the negative frequency.
                const bool is_mirrored = u == m || w == m || (dimension == 3 && v == m);
                const std::size_t x = is_mirrored ? m - u : u, z = is_mirrored ? m - w : w;
                const std::size_t y = is_mirrored && dimension == 3 ? m - v : v;
                half.power.push_back(power[(z % m * middle + y % middle) * m + x % m]);
            }
        }
    }
    return half;
}

std::vector<double> radial_means(const HalfSpectrum& half, double bin_width)
{
    const RadialBins radial_bins(half.size, bin_width, half.box);
    const std::size_t bins = radial_bins.count();
    const std::int64_t centre = half.size / 2;
    const std::size_t lines = half.columns() * half.lines();
    // Sums of fixed parts, then of the parts in order: the same for any number of threads.
    constexpr std::size_t parts = 16;
    std::vector<double> sums(parts * bins), counts(parts * bins);
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
        double* const sum = sums.data() + part * bins;
        double* const count = counts.data() + part * bins;
        for (std::size_t line = lines * part / parts; line < lines * (part + 1) / parts; ++line) {
            const auto u = static_cast<std::int64_t>(line / half.lines());
            const auto v = half.dimension == 3 ? static_cast<std::int64_t>(line % half.lines()) - centre : 0;
            const double weight = u == 0 ? 1 : 2; // the lines of u = 0 hold f and -f
            const double* power = half.power.data() + line * half.rows() + centre;
            RadialBins::Walk bin(radial_bins, half.dimension == 3 ? 2 : 1,
                                 radial_bins.squared(0, u) + radial_bins.squared(1, v));
            for (std::int64_t w = 0; w < centre; ++w) {
                const std::size_t k = bin.of(w);
                if (k >= bins) break;
                sum[k] += weight * (w == 0 ? power[0] : power[w] + power[-w]);
                count[k] += w == 0 ? weight : 2 * weight;
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
