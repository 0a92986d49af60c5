// The sides of a torus that is a rectangle or a box instead of a square or a cube.
//
// Points stay on the unit torus, each coordinate over its side. Lengths are in roots of the box's area (volume), which
// is 1 by that: N points have the mean spacing that they have in a square, and disks the largest radius. Frequency
// (u, v) of the unit torus is (u / a, v / b) of the box with the sides a and b: its reciprocal lattice.
#pragma once

#include <array>
#include <span>

namespace poissonlab {

struct PeriodicBox
{
    std::array<double, 3> sides{1, 1, 1}; ///< along x, y and z, of product 1; in 2D the last one is 1

    bool is_unit() const { return sides == std::array<double, 3>{1, 1, 1}; }

    double shortest() const; ///< at most 1
    double longest() const;  ///< at least 1

    bool operator==(const PeriodicBox&) const = default;
};

/// The longest side of a box may be so many times the shortest one.
inline constexpr double longest_to_shortest = 100;

/// The root of the area (volume) of the box with these sides, in any unit, two or three of them.
double root_of_volume(std::span<const double> sides);

/// The box with sides in this proportion, positive numbers, two or three of them. The unit square (cube) where all are
/// the same, or there are none.
PeriodicBox periodic_box(std::span<const double> sides);

}
