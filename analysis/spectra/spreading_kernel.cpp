#include "analysis/spectra/spreading_kernel.hpp"

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
static_assert(degree % 2 == 0);

/// Coefficients of powers of x of the polynomial that interpolates `values` at Chebyshev's nodes of [-1, 1].
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
    : width_(width), beta_(0.976 * std::numbers::pi * (1 - 0.5 / oversampling) * width)
{
    if (width < min_width || width > max_width || width % 2 != 0 || !(oversampling > 1))
        throw std::invalid_argument("SpreadingKernel: width or oversampling");
    make_polynomials();
    make_nodes();
}

void SpreadingKernel::make_polynomials()
{
    const int half = width_ / 2;
    coefficients_.resize(static_cast<std::size_t>(nodes * half));
    for (int i = 0; i < half; ++i) {
        std::array<double, nodes> values{};
        for (int k = 0; k < nodes; ++k) {
            const double offset = 0.5 + 0.5 * std::cos(std::numbers::pi * (2 * k + 1) / (2.0 * nodes));
            values[k] = at((i + offset) * 2 / width_ - 1);
        }
        const auto polynomial = interpolating_polynomial(values);
        for (int p = 0; p < nodes; ++p) coefficients_[p * half + i] = polynomial[p];
    }
    slopes_.resize(coefficients_.size());
    for (int p = 0; p < degree; ++p)
        for (int i = 0; i < half; ++i) slopes_[p * half + i] = 2 * (p + 1) * coefficients_[(p + 1) * half + i];
}

/// Gauss's quadrature from the kernel's middle to its end; t = sin a makes the integrand smooth there. All
/// but a cosine is the same for all frequencies.
void SpreadingKernel::make_nodes()
{
    using Quadrature = boost::math::quadrature::gauss<double, 60>;
    constexpr double middle = std::numbers::pi / 4;
    for (std::size_t k = 0; k < Quadrature::abscissa().size(); ++k) {
        for (const double sign : {-1, 1}) {
            const double a = middle * (1 + sign * Quadrature::abscissa()[k]);
            const double weight = middle * Quadrature::weights()[k] * width_;
            nodes_.push_back({width_ * std::sin(a) / 2, weight * std::exp(beta_ * (std::cos(a) - 1)) * std::cos(a)});
        }
    }
}

double SpreadingKernel::at(double t) const { return std::exp(beta_ * (std::sqrt(1 - t * t) - 1)); }

/// Even and odd powers apart: the left half is their sum, the right half their difference.
template <int width>
void SpreadingKernel::evaluate(const double* coefficients, double x, double* result)
{
    constexpr int half = width / 2;
    const double square = x * x;
    double even[half], odd[half];
    for (int i = 0; i < half; ++i) even[i] = coefficients[degree * half + i];
    for (int i = 0; i < half; ++i) odd[i] = coefficients[(degree - 1) * half + i];
    for (int p = degree - 2; p >= 0; p -= 2) {
        for (int i = 0; i < half; ++i) even[i] = even[i] * square + coefficients[p * half + i];
        if (p == 0) break;
        for (int i = 0; i < half; ++i) odd[i] = odd[i] * square + coefficients[(p - 1) * half + i];
    }
    for (int i = 0; i < half; ++i) result[i] = even[i] + odd[i] * x;
    for (int i = 0; i < half; ++i) result[width - 1 - i] = even[i] - odd[i] * x;
}

void SpreadingKernel::evaluate_all(const std::vector<double>& coefficients, double x, double* result) const
{
    // Loops of known length are several times faster.
    constexpr std::array evaluate_width = {&evaluate<4>,  &evaluate<6>,  &evaluate<8>, &evaluate<10>,
                                           &evaluate<12>, &evaluate<14>, &evaluate<16>};
    static_assert(evaluate_width.size() == (max_width - min_width) / 2 + 1);
    evaluate_width[(width_ - min_width) / 2](coefficients.data(), x, result);
}

void SpreadingKernel::values(double offset, double* result) const
{
    evaluate_all(coefficients_, 2 * offset - 1, result);
}

/// The right half mirrors the left one, and its derivatives change their sign by that.
void SpreadingKernel::slopes(double offset, double* result) const
{
    evaluate_all(slopes_, 2 * offset - 1, result);
    for (int i = width_ / 2; i < width_; ++i) result[i] = -result[i];
}

double SpreadingKernel::transform(double frequency) const
{
    double sum = 0;
    for (const Node& node : nodes_) sum += node.weight * std::cos(2 * std::numbers::pi * frequency * node.place);
    return sum;
}

}
