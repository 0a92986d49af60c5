#include "analysis/spreading_kernel.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace poissonlab {
namespace {

/// Degree of the polynomials: pieces one grid spacing long are smooth.
constexpr int degree = 10;
constexpr int nodes = degree + 1;

/// Coefficients of powers of x of the polynomial that interpolates `values` at the Chebyshev nodes of [-1, 1].
std::array<double, nodes> interpolating_polynomial(const std::array<double, nodes>& values)
{
    std::array<double, nodes> previous{}, current{}, result{};
    // Chebyshev polynomials as powers, one after the other: T_0 = 1, T_1 = x, T_k+1 = 2 x T_k - T_k-1.
    current[0] = 1;
    for (int k = 0; k < nodes; ++k) {
        double coefficient = 0;
        for (int i = 0; i < nodes; ++i) {
            coefficient += values[i] * std::cos(std::numbers::pi * k * (2 * i + 1) / (2.0 * nodes));
        }
        coefficient *= (k == 0 ? 1.0 : 2.0) / nodes;
        for (int p = 0; p < nodes; ++p) result[p] += coefficient * current[p];
        std::array<double, nodes> next{};
        for (int p = 0; p < nodes; ++p) {
            next[p] = (p > 0 ? (k == 0 ? 1 : 2) * current[p - 1] : 0.0) - (k == 0 ? 0.0 : previous[p]);
        }
        previous = current;
        current = next;
    }
    return result;
}

}

SpreadingKernel::SpreadingKernel(int width, double oversampling)
    : width_(width), beta_(0.976 * std::numbers::pi * (1 - 0.5 / oversampling) * width),
      coefficients_(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(width))
{
    if (width < min_width || width > max_width || width % 2 != 0 || !(oversampling > 1))
        throw std::invalid_argument("SpreadingKernel: width or oversampling");
    for (int i = 0; i < width; ++i) {
        std::array<double, nodes> values{};
        for (int k = 0; k < nodes; ++k) {
            const double offset = 0.5 + 0.5 * std::cos(std::numbers::pi * (2 * k + 1) / (2.0 * nodes));
            values[k] = at((i + offset) * 2 / width - 1);
        }
        const auto polynomial = interpolating_polynomial(values);
        for (int p = 0; p < nodes; ++p) coefficients_[p * width + i] = polynomial[p];
    }
}

double SpreadingKernel::at(double t) const { return std::exp(beta_ * (std::sqrt(1 - t * t) - 1)); }

void SpreadingKernel::values(double offset, double* result) const
{
    const double x = 2 * offset - 1;
    std::array<double, max_width> sums;
    for (int i = 0; i < width_; ++i) sums[i] = coefficients_[degree * width_ + i];
    for (int p = degree - 1; p >= 0; --p) {
        const double* row = coefficients_.data() + p * width_;
        for (int i = 0; i < width_; ++i) sums[i] = sums[i] * x + row[i];
    }
    for (int i = 0; i < width_; ++i) result[i] = sums[i];
}

double SpreadingKernel::transform(double frequency) const
{
    // t = sin a makes the integrand smooth at the kernel's ends.
    const auto integrand = [&](double a) {
        return std::exp(beta_ * (std::cos(a) - 1)) *
               std::cos(std::numbers::pi * width_ * frequency * std::sin(a)) * std::cos(a);
    };
    return width_ * boost::math::quadrature::gauss<double, 60>::integrate(integrand, 0.0, std::numbers::pi / 2);
}

}
