// Structured aliasing in pictures of the zone plate: rings around places where there are none.
//
// Where the spectrum of a set has a spike at an integer frequency k, the picture shows a second plate, as
// sin(|x|^2) cos(2 pi k.x / 48) = (sin(|x + c|^2 - |c|^2) + sin(|x - c|^2 - |c|^2)) / 2 with c = pi k / 48. Times
// exp(-i |x|^2), a plate around c is a plane wave, which a Fourier transform finds whatever its phase ("dechirping" of
// radar signals); the noise of stochastic sets has no such place. The error over all pixels cannot tell one from the
// other.
#pragma once

#include "analysis/zone_plate/reconstruction.hpp"

#include <cstddef>

namespace poissonlab {

struct FalseRings
{
    double strength = 0; ///< power of the strongest over the mean of its neighbourhood: noise alone gives 12 or so
    double x = 0, y = 0; ///< its centre, in units of the plate [0, 48)
    /// The strength of false rings that look like the plate itself: samples on a lattice of the pixels' own spacing
    /// fold onto it, and rings may come out a little too strong or too weak.
    double at_the_plate = 0;
};

/// The strength that the noise of a picture of so many pixels exceeds once in a hundred: powers are exponential, and
/// the largest of n is above ln(n / 0.01) with probability 0.01.
double false_rings_bound(std::size_t pixels);

/// Pixels along each axis that a picture needs at least.
inline constexpr int smallest_false_rings_picture = 64;

/// The strongest false plate of a picture of the zone plate, but for those around
/// places within 1 of the origin, which are the plate itself. `reference` is
/// zone_plate_reference of its size. Throws std::invalid_argument for smaller pictures and other references.
FalseRings strongest_false_rings(const SquareImage& picture, const SquareImage& reference);

}
