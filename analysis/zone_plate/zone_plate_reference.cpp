#include "analysis/zone_plate/zone_plate_reference.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <complex>
#include <stdexcept>
#include <utility>

namespace poissonlab {
namespace {

constexpr int gauss_nodes = 16;
/// If phases change by at most 2 a over a panel, the relative error of 16 nodes is about
/// a^32 2^33 16!^4 / (33 32!^3) < 1e-25 for a = 4; the cubic weight adds a few powers of 32 / a.
constexpr double most_phase_of_a_panel = 8;

struct Quadrature
{
    std::array<double, gauss_nodes> at; ///< in [-1, 1]
    std::array<double, gauss_nodes> weights;
};

/// Gauss-Legendre: roots of the Legendre polynomial, by Newton's method from Tricomi's approximation.
Quadrature gauss_legendre()
{
    Quadrature rule{};
    for (int k = 0; k < gauss_nodes; ++k) {
        double x = std::cos(std::numbers::pi * (k + 0.75) / (gauss_nodes + 0.5));
        double slope = 1;
        for (int step = 0; step < 8; ++step) {
            double before = 1;
            double p = x;
            for (int n = 2; n <= gauss_nodes; ++n) {
                const double next = ((2 * n - 1) * x * p - (n - 1) * before) / n;
                before = std::exchange(p, next);
            }
            slope = gauss_nodes * (before - x * p) / (1 - x * x);
            x -= p / slope;
        }
        rule.at[static_cast<std::size_t>(k)] = x;
        rule.weights[static_cast<std::size_t>(k)] = 2 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

/// The integral of weight(|x / pixel - centre|) exp(i x^2) over [from, to] pixels, where the weight is a
/// cubic.
std::complex<double> piece(const Quadrature& rule, double from, double to, double centre, double pixel)
{
    const double steepest = 2 * to * pixel * pixel; // change of the phase a pixel
    const int panels = 1 + static_cast<int>(steepest * (to - from) / most_phase_of_a_panel);
    const double half = (to - from) / panels / 2;
    std::complex<double> sum = 0;
    for (int panel = 0; panel < panels; ++panel)
        for (std::size_t k = 0; k < gauss_nodes; ++k) {
            const double u = from + half * (2 * panel + 1 + rule.at[k]);
            const double x = u * pixel;
            sum += rule.weights[k] * mitchell_weight(std::abs(u - centre)) * std::polar(1.0, x * x);
        }
    return half * sum;
}

/// The integral of the weight alone over [from, to] pixels, exact for a cubic.
double weight_between(const Quadrature& rule, double from, double to, double centre)
{
    double sum = 0;
    for (std::size_t k = 0; k < gauss_nodes; ++k) {
        const double u = from + (to - from) / 2 * (1 + rule.at[k]);
        sum += rule.weights[k] * mitchell_weight(std::abs(u - centre));
    }
    return (to - from) / 2 * sum;
}

/// The mean of exp(i x^2) around the centre of pixel number `index`, weighted by the filter, on the plate.
std::complex<double> filtered_wave(const Quadrature& rule, int index, int size)
{
    const double centre = index + 0.5;
    std::complex<double> sum = 0;
    double weights = 0;
    for (int knot = -2; knot < 2; ++knot) {
        const double from = std::max(centre + knot, 0.0);
        const double to = std::min(centre + knot + 1, static_cast<double>(size));
        if (from >= to) continue;
        sum += piece(rule, from, to, centre, plate_side / size);
        weights += weight_between(rule, from, to, centre);
    }
    return sum / weights;
}

}

SquareImage zone_plate_reference(int size)
{
    const Quadrature rule = gauss_legendre();
    std::vector<std::complex<double>> waves;
    for (int i = 0; i < size; ++i) waves.push_back(filtered_wave(rule, i, size));
    SquareImage image{size, {}};
    image.pixels.reserve(waves.size() * waves.size());
    for (const auto& up : waves)
        for (const auto& across : waves)
            image.pixels.push_back(0.5 + 0.5 * (up.real() * across.imag() + up.imag() * across.real()));
    return image;
}

SquareImage zone_plate_image(const PointSet& points)
{
    if (points.dimension != 2) throw std::invalid_argument("the zone plate is sampled by 2D sets");
    std::vector<double> values(points.size());
    tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t k) {
        values[k] = zone_plate(plate_side * points[k][0], plate_side * points[k][1]);
    });
    return reconstruct(points, values, one_sample_a_pixel(points.size()));
}

}
