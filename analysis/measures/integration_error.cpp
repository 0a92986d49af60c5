#include "analysis/measures/integration_error.hpp"

#include "analysis/statistics/jackknife.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <Random123/philox.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <numbers>

namespace poissonlab {

namespace {

using std::numbers::pi;
using std::numbers::sqrt2;
using std::numbers::sqrt3;
using Position = std::span<const double>;

constexpr double disk_radius = 0.3;
constexpr double gaussian_width = 0.2;

// Values.

double squared_from_centre(Position x)
{
    double sum = 0;
    for (const double c : x) sum += (c - 0.5) * (c - 0.5);
    return sum;
}

double disk(Position x) { return squared_from_centre(x) < disk_radius * disk_radius ? 1 : 0; }

double step(Position x)
{
    if (x.size() == 2) return x[1] < 0.2 + x[0] / std::numbers::phi ? 1 : 0;
    return x[2] < 0.15 + (sqrt2 - 1) * x[0] + (sqrt3 - 1.5) * x[1] ? 1 : 0;
}

double gaussian(Position x) { return std::exp(-squared_from_centre(x) / (2 * gaussian_width * gaussian_width)); }

double cosine(Position x)
{
    double product = 1;
    for (const double c : x) product *= 1 + std::cos(2 * pi * c);
    return product;
}

double bilinear(Position x)
{
    double product = 1;
    for (const double c : x) product *= c;
    return product;
}

// Integrals. An indicator of volume v has variance v (1 - v); products of functions of one coordinate have
// powers of one-dimensional integrals.

Integrand indicator(const char* name, double volume, double (*value)(Position))
{
    return {name, volume, volume * (1 - volume), value};
}

Integrand product(const char* name, int dimension, double integral, double square, double (*value)(Position))
{
    const double whole = std::pow(integral, dimension);
    return {name, whole, std::pow(square, dimension) - whole * whole, value};
}

/// The integral of exp(-(x - 1/2)^2 / (2 w^2)) over [0, 1].
double gaussian_integral(double w) { return w * std::sqrt(2 * pi) * std::erf(1 / (2 * sqrt2 * w)); }

std::vector<Integrand> integrands_in(int dimension)
{
    const bool plane = dimension == 2;
    const double disk_volume =
        plane ? pi * disk_radius * disk_radius : 4.0 / 3.0 * pi * disk_radius * disk_radius * disk_radius;
    // The line and the plane stay between 0 and 1: the volume below is their height at the centre.
    const double step_volume = plane ? 0.2 + 0.5 / std::numbers::phi : 0.15 + 0.5 * (sqrt2 - 1) + 0.5 * (sqrt3 - 1.5);
    return {indicator(plane ? "disk" : "ball", disk_volume, disk), indicator("step", step_volume, step),
            // The square of a Gaussian of width w is one of width w / sqrt 2.
            product("gaussian", dimension, gaussian_integral(gaussian_width), gaussian_integral(gaussian_width / sqrt2),
                    gaussian),
            product("cosine", dimension, 1, 1.5, cosine),
            product(plane ? "bilinear" : "trilinear", dimension, 0.5, 1.0 / 3.0, bilinear)};
}

// Shifts.

/// Multiples of 2^-32. The last counter word, the letters "shif", keeps this stream apart from all others.
std::array<double, 3> shift_of(std::uint64_t seed, std::size_t set, std::size_t shift)
{
    const philox4x32_ctr_t counter = {
        {static_cast<std::uint32_t>(set), static_cast<std::uint32_t>(shift), 0, 0x73686966}};
    const philox4x32_key_t key = {{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
    const philox4x32_ctr_t words = philox4x32(counter, key);
    return {words.v[0] * 0x1p-32, words.v[1] * 0x1p-32, words.v[2] * 0x1p-32};
}

/// Adds the values of all integrands at points that are shifted.
void add_values(const PointSet& points, const std::array<double, 3>& shift, std::vector<double>& sums)
{
    const auto& functions = integrands(points.dimension);
    sums.resize(functions.size());
    std::array<double, 3> x{};
    const Position position(x.data(), static_cast<std::size_t>(points.dimension));
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < position.size(); ++k) {
            const double moved = points[i][k] + shift[k];
            x[k] = moved < 1 ? moved : moved - 1;
        }
        for (std::size_t f = 0; f < functions.size(); ++f) sums[f] += functions[f].value(position);
    }
}

}

const std::vector<Integrand>& integrands(int dimension)
{
    static const std::vector<Integrand> plane = integrands_in(2);
    static const std::vector<Integrand> space = integrands_in(3);
    if (dimension != 2 && dimension != 3) throw InputError("integration error: the dimension must be 2 or 3");
    return dimension == 2 ? plane : space;
}

IntegrationErrorEstimate::IntegrationErrorEstimate(int dimension, std::uint64_t seed, int shifts, std::size_t first)
    : dimension_(dimension), seed_(seed), shifts_(shifts), first_(first)
{
    integrands(dimension);
    if (shifts < 1) throw InputError("integration error: the number of shifts must be at least 1");
}

/// Adds a set, or a part of it, to the sums of the set that comes next.
void IntegrationErrorEstimate::sum(const PointSet& points, Sums& sums) const
{
    sums.resize(static_cast<std::size_t>(shifts_));
    tbb::parallel_for(std::size_t{0}, sums.size(), [&](std::size_t s) {
        add_values(points, shift_of(seed_, first_ + squares_.size(), s), sums[s]);
    });
}

void IntegrationErrorEstimate::add_sums(const Sums& sums, std::uint64_t points)
{
    const auto& functions = integrands(dimension_);
    const auto n = static_cast<double>(points);
    std::vector<double> squares(functions.size());
    for (const auto& of_shift : sums) {
        for (std::size_t f = 0; f < squares.size(); ++f) {
            const double error = of_shift[f] / n - functions[f].integral;
            squares[f] += error * error / shifts_;
        }
    }
    squares_.push_back(std::move(squares));
    sizes_.push_back(n);
}

void IntegrationErrorEstimate::add(const PointSet& points)
{
    if (points.dimension != dimension_) throw InputError("integration error: sets differ in their dimension");
    if (points.size() == 0) throw InputError("integration error: a set must have at least one point");
    Sums sums;
    sum(points, sums);
    add_sums(sums, points.size());
}

void IntegrationErrorEstimate::add(const PointStrips& points)
{
    if (points.dimension() != dimension_) throw InputError("integration error: sets differ in their dimension");
    if (points.size() == 0) throw InputError("integration error: a set must have at least one point");
    Sums sums;
    for (std::size_t strip = 0; strip < points.count(); ++strip) {
        stop_if_interrupted();
        sum(points.strip(strip), sums);
    }
    add_sums(sums, points.size());
}

void IntegrationErrorEstimate::append(const IntegrationErrorEstimate& other)
{
    squares_.insert(squares_.end(), other.squares_.begin(), other.squares_.end());
    sizes_.insert(sizes_.end(), other.sizes_.begin(), other.sizes_.end());
}

std::vector<IntegrationError> IntegrationErrorEstimate::mean(const std::vector<std::size_t>& groups) const
{
    if (squares_.empty()) return {};
    const auto sets = static_cast<double>(squares_.size());
    const std::vector<double> errors = errors_of_mean(squares_, groups);
    std::vector<IntegrationError> result;
    for (std::size_t f = 0; f < integrands(dimension_).size(); ++f) {
        const Integrand& function = integrands(dimension_)[f];
        double mean = 0, relative = 0;
        for (std::size_t k = 0; k < squares_.size(); ++k) {
            mean += squares_[k][f] / sets;
            relative += sizes_[k] * squares_[k][f] / function.variance / sets;
        }
        const double rms = std::sqrt(mean);
        // The error of the root is that of the mean square over twice the root.
        const double error = !errors.empty() && rms > 0 ? errors[f] / (2 * rms) : 0;
        result.push_back({function.name, function.integral, rms, error, relative});
    }
    return result;
}

}
