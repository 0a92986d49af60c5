#include "analysis/spectra/autocorrelation.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace poissonlab {
namespace {

constexpr int largest_padded = 2048; // 8,192 along each axis are half a GiB

/// The power spectrum beyond that of random points, tapered.
double tapered_power(const Spectrum& spectrum, int fx, int fy)
{
    const double share = std::hypot(fx, fy) / spectrum.size;
    if (share >= 0.5) return 0;
    const double root = std::cos(std::numbers::pi * share);
    const auto points = static_cast<double>(spectrum.points);
    return root * root * ((fx == 0 && fy == 0 ? points : spectrum.at(fx, fy)) - 1) / points;
}

}

double autocorrelation_step(int spectrum_size)
{
    return 1.0 / (spectrum_size <= largest_padded ? 2 * spectrum_size : spectrum_size);
}

SquareImage autocorrelation(const Spectrum& spectrum, double reach)
{
    if (spectrum.dimension != 2) throw std::invalid_argument("autocorrelation: the spectrum must be 2D");
    if (spectrum.points < 2) throw std::invalid_argument("autocorrelation: one point has no pairs");
    if (!(reach > 0 && reach <= 0.5)) throw std::invalid_argument("autocorrelation: reach must be in (0, 1/2]");
    const int length = static_cast<int>(std::lround(1 / autocorrelation_step(spectrum.size)));
    const auto columns = static_cast<std::size_t>(length / 2 + 1);
    std::vector<std::complex<double>> values(static_cast<std::size_t>(length) * columns);
    auto* const sums = reinterpret_cast<double*>(values.data()); // the transform takes the place of its input
    const FftwPlan plan = make_fftw_plan(fftw_plan_dft_c2r_2d, length, length, fftw(values.data()), sums,
                                         static_cast<unsigned>(FFTW_ESTIMATE));
    const int half = spectrum.size / 2;
    for (int fy = -half + 1; fy < half; ++fy)
        for (int fx = 0; fx < half; ++fx)
            values[static_cast<std::size_t>(fy < 0 ? fy + length : fy) * columns + static_cast<std::size_t>(fx)] =
                tapered_power(spectrum, fx, fy);
    fftw_execute(plan.get());

    const int middle = std::min(length / 2, static_cast<int>(std::lround(reach * length)));
    SquareImage image{2 * middle, {}};
    const auto wrapped = [&](int i) { return static_cast<std::size_t>((i - middle + length) % length); };
    for (int row = 0; row < image.size; ++row)
        for (int column = 0; column < image.size; ++column)
            image.pixels.push_back(sums[wrapped(row) * 2 * columns + wrapped(column)]);
    return image;
}

}
