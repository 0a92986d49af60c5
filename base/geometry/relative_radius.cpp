#include "base/geometry/relative_radius.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab {

double max_min_distance(std::size_t points, int dimension)
{
    const auto n = static_cast<double>(points);
    return dimension == 2 ? 2.0 * std::sqrt(1.0 / (2.0 * std::numbers::sqrt3 * n))
                          : 2.0 * std::cbrt(1.0 / (4.0 * std::numbers::sqrt2 * n));
}

double relative_radius(double min_distance, std::size_t points, int dimension)
{
    return min_distance / max_min_distance(points, dimension);
}

double min_distance_for(double relative_radius, std::size_t points, int dimension)
{
    return relative_radius * max_min_distance(points, dimension);
}

double principal_frequency(std::size_t points, int dimension)
{
    const auto n = static_cast<double>(points);
    return dimension == 2 ? std::sqrt(2 / std::numbers::sqrt3 * n) : std::numbers::sqrt3 * std::cbrt(n / 4);
}

double covered_fraction(double min_distance, std::size_t points, int dimension)
{
    const double r = 0.5 * min_distance;
    const double disk = dimension == 2 ? std::numbers::pi * r * r : 4.0 / 3.0 * std::numbers::pi * r * r * r;
    return static_cast<double>(points) * disk;
}

double saturation_covered_fraction(int dimension) { return dimension == 2 ? 0.5470735 : 0.3841307; }

double saturation_relative_radius(int dimension)
{
    // Covered fraction over packing density, and the power that turns area or volume into length.
    return dimension == 2
               ? std::sqrt(saturation_covered_fraction(2) / (std::numbers::pi / (2.0 * std::numbers::sqrt3)))
               : std::cbrt(saturation_covered_fraction(3) / (std::numbers::pi / (3.0 * std::numbers::sqrt2)));
}

}
