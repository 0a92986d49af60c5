#include "analysis/tilings/color_spectrum.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace poissonlab {

double ColorSpectrum::peak() const { return *std::ranges::max_element(power); }

double ColorSpectrum::strongest(double share) const
{
    std::vector<double> sorted = power;
    const auto taken = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(sorted.size())));
    std::ranges::nth_element(sorted, sorted.begin() + taken, std::greater<>());
    const double all = std::accumulate(power.begin(), power.end(), 0.0);
    return std::accumulate(sorted.begin(), sorted.begin() + taken, 0.0) / all;
}

ColorSpectrum color_spectrum(const ColorField& field, std::uint32_t color)
{
    const std::size_t n = field.width, columns = n / 2 + 1;
    if (n < 2 || field.height() != n) throw std::invalid_argument("color_spectrum: the field must be square");
    ColorSpectrum spectrum{n, static_cast<std::uint64_t>(std::ranges::count(field.values, color)), {}};
    if (spectrum.count == 0 || spectrum.count == field.values.size())
        throw std::invalid_argument("color_spectrum: all places have the colour, or none");
    const double places = static_cast<double>(n) * static_cast<double>(n);
    const double p = static_cast<double>(spectrum.count) / places;
    std::vector<double> values;
    for (const std::uint8_t value : field.values) values.push_back((value == color ? 1 : 0) - p);
    std::vector<std::complex<double>> transform(n * columns);
    const FftwPlan plan = make_fftw_plan(fftw_plan_dft_r2c_2d, static_cast<int>(n), static_cast<int>(n), values.data(),
                                         fftw(transform.data()), FFTW_ESTIMATE);
    fftw_execute(plan.get());
    spectrum.power.resize(n * n);
    for (std::size_t y = 0; y < n; ++y)
        for (std::size_t x = 0; x < n; ++x) {
            const bool is_stored = x < columns; // the others are conjugates of those at the opposite frequency
            const std::complex<double> f =
                is_stored ? transform[y * columns + x] : transform[(n - y) % n * columns + n - x];
            spectrum.power[(y + n / 2) % n * n + (x + n / 2) % n] = std::norm(f) / (places * p * (1 - p));
        }
    spectrum.power[n / 2 * n + n / 2] = 0;
    return spectrum;
}

}
