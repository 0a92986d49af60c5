#include "analysis/measures/set_mark.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Rounding makes 1e-10 of it for a million points.
constexpr double mark_tolerance = 1e-8;

using Frequency = std::array<int, 3>;

/// Low ones, and not the multiples of one: tilings of a few tiles differ there.
constexpr std::array<Frequency, 6> plane_frequencies{
    {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, -1, 0}, {2, 1, 0}, {1, 2, 0}}};
constexpr std::array<Frequency, 6> space_frequencies{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 1, 1}}};

/// A number of modulus 1, or a sum of these: std::complex looks for infinities at every product.
struct Wave
{
    double real = 1, imaginary = 0;

    Wave operator*(const Wave& other) const
    {
        return {real * other.real - imaginary * other.imaginary, real * other.imaginary + imaginary * other.real};
    }
};

Wave wave_of(double turns)
{
    const double angle = -2 * std::numbers::pi * turns;
    return {std::cos(angle), std::sin(angle)};
}

Wave power_of(const Wave& wave, int exponent)
{
    switch (exponent) {
    case -1:
        return {wave.real, -wave.imaginary};
    case 0:
        return {};
    case 1:
        return wave;
    default:
        return wave * wave;
    }
}

bool are_near(double a, double b)
{
    return a == b || std::abs(a - b) <= mark_tolerance * std::max(1.0, std::abs(a)); // == where they are infinite
}

}

void SetMarkSums::add(const PointSet& points)
{
    const auto dimension = static_cast<std::size_t>(points.dimension);
    const auto& frequencies = dimension == 2 ? plane_frequencies : space_frequencies;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::array<Wave, 3> waves;
        for (std::size_t k = 0; k < dimension; ++k) waves[k] = wave_of(points.coordinates[i * dimension + k]);
        for (std::size_t j = 0; j < frequencies.size(); ++j) {
            const Frequency& f = frequencies[j];
            const Wave wave = power_of(waves[0], f[0]) * power_of(waves[1], f[1]) * power_of(waves[2], f[2]);
            real_[j] += wave.real;
            imaginary_[j] += wave.imaginary;
        }
    }
    points_ += points.size();
}

SetMark SetMarkSums::mark(double min_distance, double mean_nearest) const
{
    SetMark mark{points_, min_distance, mean_nearest, {}};
    const double root = std::sqrt(static_cast<double>(points_));
    for (std::size_t j = 0; j < real_.size(); ++j) mark.amplitudes[j] = std::hypot(real_[j], imaginary_[j]) / root;
    return mark;
}

bool are_same_set(const SetMark& a, const SetMark& b)
{
    if (a.points != b.points) return false;
    for (std::size_t j = 0; j < a.amplitudes.size(); ++j)
        if (!are_near(a.amplitudes[j], b.amplitudes[j])) return false;
    return are_near(a.min_distance, b.min_distance) && are_near(a.mean_nearest, b.mean_nearest);
}

}
