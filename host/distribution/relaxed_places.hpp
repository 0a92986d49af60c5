// Points that follow a density and lie evenly there: warped points, moved on by Gaussian blue noise.
//
// Ahmed, Ren, Wonka, Gaussian blue noise, 2022, see host/sampling/optimized/gaussian_blue_noise.hpp: warping puts as
// many points as the density asks for into each row and each part of it, but stretches their distances; points that
// then repel each other by Gaussians, which the density holds against, get even at every tone and keep the density. The
// torus of that method is the square around the picture. Along the shorter side of a picture that is not square, the
// density and the points are continued by their mirror images.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/sampling/warp/warp.hpp"

#include <cstddef>
#include <string>

namespace poissonlab {

/// Fewer places stay where they are: their Gaussians would reach around the torus.
inline constexpr std::size_t least_relaxed_places = 135;

/// Places after so many iterations, by the engine of the workplace; the same by both. Throws InputError where the
/// device has no memory for that, and for pictures so long that the square around them has more than 2^26 pixels.
/// `purpose` is said with the step.
PixelPlaces relaxed_places(const Density& density, const PixelPlaces& places, std::size_t iterations,
                           const DistributionPlace& place, const std::string& purpose = "");

}
