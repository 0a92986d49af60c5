// Measures of how well points follow a density, and how evenly.
#pragma once

#include "host/sampling/warp/warp.hpp"

namespace poissonlab {

/// Windows along each axis of which points are counted.
inline constexpr int density_windows = 16;

inline constexpr const char* density_error_meaning =
    "mean of (count - expected)² / expected over windows of 1/16 of each side: 1 for random points";

/// The mean of (count - expected)^2 / expected over windows of 1/16 of each side in which more than one point is
/// expected: 1 for random points, less for even ones. Nothing expected anywhere: 0.
double density_error(const Density& density, const PixelPlaces& places);

/// The distances of points from their nearest ones in parts of the largest possible one at the density there, that of
/// the hexagonal lattice: mean and least. In a constant density the least is the relative radius of D 2.4 without the
/// torus.
struct LocalSpacing
{
    double mean = 0;
    double least = 0;
};

/// The spacing needs at least two points.
LocalSpacing local_spacing(const Density& density, const PixelPlaces& places);

}
