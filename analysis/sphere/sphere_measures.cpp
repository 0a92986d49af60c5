#include "analysis/sphere/sphere_measures.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace poissonlab {
namespace {

constexpr std::size_t lanes = 8;
using Lanes = std::array<double, lanes>;

/// The harmonics of one order m in eight points: (x + i y)^m times a polynomial in z, which grows by its degree.
struct HarmonicLanes
{
    Lanes z{}, real{}, imaginary{}, last{}, now{};
};

std::complex<double> power_of(std::complex<double> base, std::uint32_t exponent)
{
    std::complex<double> result = 1;
    for (; exponent > 0; exponent /= 2, base *= base)
        if (exponent % 2 == 1) result *= base;
    return result;
}

std::vector<HarmonicLanes> harmonics_of_order(std::span<const std::array<double, 3>> points, std::uint32_t order)
{
    double first = (2.0 * order + 1) / (4 * std::numbers::pi) * (order > 0 ? 2 : 1);
    for (std::uint32_t k = 1; k <= order; ++k) first *= (2.0 * k - 1) / (2.0 * k);
    std::vector<HarmonicLanes> all((points.size() + lanes - 1) / lanes);
    for (std::size_t i = 0; i < points.size(); ++i) {
        HarmonicLanes& of = all[i / lanes];
        const std::complex<double> power = power_of({points[i][0], points[i][1]}, order);
        of.z[i % lanes] = points[i][2];
        of.real[i % lanes] = power.real();
        of.imaginary[i % lanes] = power.imag();
        of.now[i % lanes] = std::sqrt(first);
    }
    return all;
}

/// The sums over all points, cosine and sine.
std::array<double, 2> harmonic_sums(const std::vector<HarmonicLanes>& all)
{
    Lanes real{}, imaginary{};
    for (const HarmonicLanes& of : all)
        for (std::size_t k = 0; k < lanes; ++k) {
            real[k] += of.now[k] * of.real[k];
            imaginary[k] += of.now[k] * of.imaginary[k];
        }
    std::array<double, 2> sums{};
    for (std::size_t k = 0; k < lanes; ++k) sums = {sums[0] + real[k], sums[1] + imaginary[k]};
    return sums;
}

/// From degree l - 1 to l: the recurrence of normalised Legendre functions.
void raise_degree(std::vector<HarmonicLanes>& all, double degree, double order)
{
    const double by = std::sqrt((4 * degree * degree - 1) / (degree * degree - order * order));
    const double below = degree - 1, less = std::sqrt((below * below - order * order) / (4 * below * below - 1));
    for (HarmonicLanes& of : all)
        for (std::size_t k = 0; k < lanes; ++k) {
            const double next = by * (of.z[k] * of.now[k] - less * of.last[k]);
            of.last[k] = of.now[k];
            of.now[k] = next;
        }
}

}

std::vector<double> harmonic_powers(std::span<const std::array<double, 3>> points, std::uint32_t highest)
{
    // Degree l begins at l^2 - 1: order 0, then cosine and sine of each further order.
    std::vector<double> powers((highest + 1) * (highest + 1) - 1);
    const double scale = 4 * std::numbers::pi / static_cast<double>(points.size());
    tbb::parallel_for(std::uint32_t{0}, highest + 1, [&](std::uint32_t order) {
        std::vector<HarmonicLanes> all = harmonics_of_order(points, order);
        for (std::uint32_t degree = order; degree <= highest; ++degree) {
            if (degree > order) raise_degree(all, degree, order);
            if (degree == 0) continue;
            const auto [cosine, sine] = harmonic_sums(all);
            const std::size_t begin = std::size_t{degree} * degree - 1;
            if (order > 0) powers[begin + 2 * order] = sine * sine * scale;
            powers[begin + (order > 0 ? 2 * order - 1 : 0)] = cosine * cosine * scale;
        }
    });
    return powers;
}

std::vector<double> harmonic_eigenvalues(std::uint32_t highest)
{
    std::vector<double> eigenvalues;
    for (std::uint32_t degree = 1; degree <= highest; ++degree)
        eigenvalues.insert(eigenvalues.end(), 2 * degree + 1, static_cast<double>(degree) * (degree + 1.0));
    return eigenvalues;
}

SpherePairs sphere_pairs(std::span<const std::array<double, 3>> points)
{
    struct OfPoint
    {
        double sum = 0, nearest = 4;
    };
    std::vector<OfPoint> of_points(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        OfPoint& of = of_points[i];
        for (std::size_t j = 0; j < points.size(); ++j) {
            const double x = points[i][0] - points[j][0], y = points[i][1] - points[j][1],
                         z = points[i][2] - points[j][2], squared = x * x + y * y + z * z;
            of.sum += std::sqrt(squared);
            if (j != i) of.nearest = std::min(of.nearest, squared);
        }
    });
    const auto angle = [](double squared) { return 2 * std::asin(std::min(1.0, std::sqrt(squared) / 2)); };
    const auto count = static_cast<double>(points.size());
    SpherePairs pairs;
    double nearest = 4, sum = 0;
    for (const OfPoint& of : of_points) {
        nearest = std::min(nearest, of.nearest);
        pairs.mean_nearest += angle(of.nearest) / count;
        sum += of.sum / count;
    }
    pairs.least = angle(nearest);
    pairs.cap_discrepancy = 3 * count * (4.0 / 3 - sum / count) / 4;
    return pairs;
}

}
