#include "host/texture/comparison/correlation_peak.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace poissonlab {

SelfCorrelation::SelfCorrelation(const LightMap& map)
    : width_(map.width), height_(map.height), line_(2 * (static_cast<std::size_t>(width_ + width_ / 4) / 2 + 1))
{
    // Zeros of a quarter of the map's sides keep pairs over opposite borders apart. Transforms are in place.
    const int columns = width_ + width_ / 4, rows = height_ + height_ / 4;
    const double mean =
        std::accumulate(map.values.begin(), map.values.end(), 0.0) / static_cast<double>(map.values.size());
    values_.resize(line_ * static_cast<std::size_t>(rows));
    double squares = 0;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const double value = map.at(x, y) - mean;
            values_[static_cast<std::size_t>(y) * line_ + static_cast<std::size_t>(x)] = value;
            squares += value * value;
        }
    if (squares == 0) return;
    auto* const spectrum = reinterpret_cast<std::complex<double>*>(values_.data()); // NOLINT: pairs of numbers
    const auto flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
    const FftwPlan forward = make_fftw_plan(fftw_plan_dft_r2c_2d, rows, columns, values_.data(), fftw(spectrum), flags);
    fftw_execute(forward.get());
    for (std::size_t i = 0; i < values_.size() / 2; ++i) spectrum[i] = std::norm(spectrum[i]);
    const FftwPlan backward =
        make_fftw_plan(fftw_plan_dft_c2r_2d, rows, columns, fftw(spectrum), values_.data(), flags);
    fftw_execute(backward.get());
    const double unit = 1 / (squares * rows * columns);
    for (double& value : values_) value *= unit;
}

double SelfCorrelation::at(int dx, int dy) const
{
    const double pairs = (1 - static_cast<double>(std::abs(dx)) / width_) * (1 - static_cast<double>(dy) / height_);
    const int x = dx < 0 ? dx + width_ + width_ / 4 : dx;
    return values_[static_cast<std::size_t>(dy) * line_ + static_cast<std::size_t>(x)] / pairs;
}

CorrelationPeak correlation_peak(const SelfCorrelation& correlations, int least)
{
    CorrelationPeak peak;
    for (int dy = 0; dy <= correlations.most_dy(); ++dy)
        for (int dx = dy == 0 ? 0 : -correlations.most_dx(); dx <= correlations.most_dx(); ++dx) {
            if (dx * dx + dy * dy < least * least) continue;
            const double value = correlations.at(dx, dy);
            if (value > peak.correlation) peak = {value, dx, dy};
        }
    return peak;
}

double chance_of_peak(const SelfCorrelation& sample, int least, int width, int height)
{
    double squares = 1; // at distance 0
    for (int dy = 0; dy <= std::min(least - 1, sample.most_dy()); ++dy)
        for (int dx = -sample.most_dx(); dx <= sample.most_dx(); ++dx)
            if (dx * dx + dy * dy < least * least && (dy > 0 || dx > 0)) squares += 2 * std::pow(sample.at(dx, dy), 2);
    const double places = static_cast<double>(width) * height;
    const double distances = places / 8 / squares; // that are independent
    return std::sqrt(squares / places) * std::sqrt(2 * std::log(std::max(std::numbers::e, distances)));
}

}
