#include "analysis/tilings/color_statistics.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numeric>
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

/// A colour field in random order: how many of its pairs of places agree.
class RandomOrder
{
public:
    explicit RandomOrder(const std::vector<std::uint64_t>& counts)
    {
        double places = 0;
        for (const std::uint64_t count : counts) places += static_cast<double>(count);
        double of_two = 0, of_three = 0, corrections = 0;
        for (const std::uint64_t count : counts) {
            const auto c = static_cast<double>(count);
            of_two += c * (c - 1);
            of_three += c * (c - 1) * (c - 2);
            corrections += c * (c - 1) * (4 * c - 6);
        }
        const double two = places * (places - 1), three = two * (places - 2), four = three * (places - 3);
        if (two > 0) one_pair_ = of_two / two;
        if (three > 0) sharing_ = of_three / three;
        if (four > 0) {
            excess_ = (of_two * of_two / two * (4 * places - 6) - corrections) / four;
            apart_ = one_pair_ * one_pair_ + excess_;
        }
    }

    /// The probability that a pair agrees: the sum of squared frequencies, but for a place with itself.
    double chance() const { return one_pair_; }

    /// The variance of the number of `pairs` that agree, where `chains` places are in two of them, and no pair shares
    /// both of its places with another.
    double variance(double pairs, double chains) const
    {
        return pairs * (one_pair_ - apart_) + 2 * chains * (sharing_ - apart_) + pairs * pairs * excess_;
    }

private:
    double one_pair_ = 0;
    double sharing_ = 0; ///< the probability that two pairs that share a place agree both
    double apart_ = 0;   ///< of two that share none
    double excess_ = 0;  ///< apart_ - one_pair_^2, which subtracting would round away
};

/// The number of places whose both neighbours at a displacement are in the field.
double chains_of(const ColorField& field, int dx, int dy)
{
    const auto along = [](std::size_t size, int d) {
        return std::max(0.0, static_cast<double>(size) - 2.0 * std::abs(d));
    };
    return along(field.width, dx) * along(field.height(), dy);
}

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
    const RandomOrder order(color_counts(field));
    ColorAutocorrelation result;
    result.lags = lags;
    result.chance = order.chance();
    result.largest_at = {0, 0};
    for (int dy = -lags; dy <= lags; ++dy)
        for (int dx = -lags; dx <= lags; ++dx) {
            const double n = static_cast<double>(field.width - static_cast<std::size_t>(std::abs(dx))) *
                             static_cast<double>(field.height() - static_cast<std::size_t>(std::abs(dy)));
            const double pairs = agreement.pairs(dx, dy), variance = order.variance(n, chains_of(field, dx, dy));
            // Rounding leaves less where all orders have as many pairs that agree.
            const bool is_certain = (dx == 0 && dy == 0) || variance < 1e-12 * n;
            const double z = is_certain ? 0 : (pairs - n * order.chance()) / std::sqrt(variance);
            result.z.push_back(z);
            if (dy >= 0 && std::abs(z) > result.largest) {
                result.largest = std::abs(z);
                result.largest_at = {dx, dy};
                result.agreement = pairs / n;
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
