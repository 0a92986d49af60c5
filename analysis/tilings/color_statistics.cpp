#include "analysis/tilings/color_statistics.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace poissonlab {

namespace {

/// The numbers of pairs of places at each displacement that have the same colour: the sum over colours of the
/// autocorrelation of each one's indicator, on a grid large enough that displacements do not wrap around.
class AgreementGrid
{
public:
    AgreementGrid(const ColorField& field, int lags)
        : width_(field.width + static_cast<std::size_t>(lags)),
          height_(field.height() + static_cast<std::size_t>(lags)), columns_(width_ / 2 + 1), values_(height_ * width_),
          transform_(height_ * columns_), powers_(height_ * columns_),
          forward_(make_fftw_plan(fftw_plan_dft_r2c_2d, static_cast<int>(height_), static_cast<int>(width_),
                                  values_.data(), fftw(transform_.data()), FFTW_ESTIMATE)),
          backward_(make_fftw_plan(fftw_plan_dft_c2r_2d, static_cast<int>(height_), static_cast<int>(width_),
                                   fftw(transform_.data()), values_.data(), FFTW_ESTIMATE))
    {
        for (std::uint32_t color = 0; color < field.colors; ++color) add_power_of(field, color);
        std::ranges::copy(powers_, transform_.begin());
        fftw_execute(backward_.get());
    }

    /// Displacements from (-lags, -lags); counts are whole numbers, the transform's rounding is far below
    /// 1/2.
    double pairs(int dx, int dy) const
    {
        const auto x = dx < 0 ? width_ - static_cast<std::size_t>(-dx) : static_cast<std::size_t>(dx);
        const auto y = dy < 0 ? height_ - static_cast<std::size_t>(-dy) : static_cast<std::size_t>(dy);
        return std::round(values_[y * width_ + x] / static_cast<double>(width_ * height_));
    }

private:
    void add_power_of(const ColorField& field, std::uint32_t color)
    {
        std::ranges::fill(values_, 0.0);
        for (std::size_t i = 0; i < field.values.size(); ++i)
            if (field.values[i] == color) values_[i / field.width * width_ + i % field.width] = 1;
        fftw_execute(forward_.get());
        for (std::size_t i = 0; i < powers_.size(); ++i) powers_[i] += std::norm(transform_[i]);
    }

    std::size_t width_, height_, columns_;
    std::vector<double> values_;
    std::vector<std::complex<double>> transform_;
    std::vector<double> powers_;
    FftwPlan forward_, backward_;
};

}

FrequencyTest test_frequencies(std::span<const std::uint64_t> counts)
{
    double total = 0;
    for (const std::uint64_t count : counts) total += static_cast<double>(count);
    if (counts.size() < 2 || total == 0) return {};
    const double mean = total / static_cast<double>(counts.size());
    FrequencyTest test;
    for (const std::uint64_t count : counts) {
        const double difference = static_cast<double>(count) - mean;
        test.chi_square += difference * difference / mean;
    }
    test.p_value = boost::math::gamma_q(0.5 * static_cast<double>(counts.size() - 1), 0.5 * test.chi_square);
    return test;
}

std::vector<std::uint64_t> color_counts(const ColorField& field)
{
    std::vector<std::uint64_t> counts(field.colors);
    for (const std::uint8_t color : field.values) ++counts.at(color);
    return counts;
}

ColorAutocorrelation color_autocorrelation(const ColorField& field, int lags)
{
    const auto reach = static_cast<std::size_t>(lags);
    if (lags < 0 || reach >= field.width || reach >= field.height())
        throw std::invalid_argument("color_autocorrelation: lags must be below width and height");
    const AgreementGrid agreement(field, lags);
    const double share = 1.0 / field.colors;
    ColorAutocorrelation result;
    result.lags = lags;
    result.largest_at = {0, 0};
    for (int dy = -lags; dy <= lags; ++dy)
        for (int dx = -lags; dx <= lags; ++dx) {
            const double n = static_cast<double>(field.width - static_cast<std::size_t>(std::abs(dx))) *
                             static_cast<double>(field.height() - static_cast<std::size_t>(std::abs(dy)));
            const bool middle = dx == 0 && dy == 0;
            const double z = middle ? 0 : (agreement.pairs(dx, dy) - n * share) / std::sqrt(n * share * (1 - share));
            result.z.push_back(z);
            if (dy >= 0 && std::abs(z) > result.largest) {
                result.largest = std::abs(z);
                result.largest_at = {dx, dy};
            }
        }
    // Opposite displacements have the same value.
    const double displacements = 0.5 * (static_cast<double>(result.z.size()) - 1);
    if (displacements > 0) {
        const double p = -std::expm1(std::log1p(-0.01) / displacements);
        result.bound = boost::math::quantile(boost::math::complement(boost::math::normal(), p / 2));
    }
    return result;
}

}
