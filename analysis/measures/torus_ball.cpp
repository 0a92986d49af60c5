#include "analysis/measures/torus_ball.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {

namespace {

using std::numbers::pi;
constexpr double h = 0.5;

double root(double x) { return std::sqrt(std::max(x, 0.0)); }

double disk_in_square(double r)
{
    if (r <= h) return pi * r * r;
    return pi * r * r - 4 * (r * r * std::acos(h / r) - h * root(r * r - h * h));
}

/// F: the antiderivative in z of disk_in_square(sqrt(r^2 - z^2)), 0 at z = 0; |z| <= h, r > h.
double slices(double r, double z)
{
    const double squared = r * r;
    const double s2 = squared - h * h;
    const double q = root(s2 - z * z);    // sqrt(rho^2 - h^2)
    const double turn = std::atan2(z, q); // asin(z / s)
    const double disks = squared * z - z * z * z / 3;
    const double integral_q = (z * q + s2 * turn) / 2;

    // The integral of rho^2 acos(h / rho), by parts.
    const double atan_term = 2.0 / 3.0 * squared * squared * std::atan2(h * z, r * q) / (r * h);
    const double rest = -2.0 / 3.0 * squared * turn + (s2 * turn - z * q) / 6;
    const double acos_term = disks * std::acos(std::min(h / std::hypot(h, q), 1.0)) + h * (atan_term + rest);
    return pi * disks - 4 * acos_term + 4 * h * integral_q;
}

double ball_in_cube(double r)
{
    if (r <= h) return 4.0 / 3.0 * pi * r * r * r;
    if (r * r <= 2 * h * h) {
        return 4.0 / 3.0 * pi * r * r * r - 2 * pi * (r - h) * (r - h) * (2 * r + h);
    }
    const double full = root(r * r - 2 * h * h);
    return 2 * (full + slices(r, h) - slices(r, full));
}

}

double largest_toroidal_distance(int dimension) { return h * std::sqrt(static_cast<double>(dimension)); }

double torus_ball_volume(double radius, int dimension)
{
    if (!(radius > 0)) return 0;
    if (radius >= largest_toroidal_distance(dimension)) return 1;
    return dimension == 2 ? disk_in_square(radius) : ball_in_cube(radius);
}

double torus_ball_volume(double radius, int dimension, const PeriodicBox& box)
{
    if (box.is_unit()) return torus_ball_volume(radius, dimension);
    if (!(radius > 0)) return 0;
    return dimension == 2 ? pi * radius * radius : 4.0 / 3.0 * pi * radius * radius * radius;
}

double window_pair_volume(double distance, int dimension)
{
    const double r = distance;
    if (dimension == 2) return r * r * (pi + r * (-8.0 / 3 + r / 2));
    return r * r * r * (4 * pi / 3 + r * (-1.5 * pi + r * (1.6 - r / 6)));
}

}
