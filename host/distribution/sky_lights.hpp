// Environment maps as lights: pictures of all directions, longitude to the right, the pole at the top.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.2, which leaves the weights open: here those of
// pixels are luminance times their exact solid angle, and a row's places are even in the cosine of the polar angle, so
// that an even sky has even lights.
#pragma once

#include "base/densities/density.hpp"
#include "host/sampling/warp/warp.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

struct SkyLight
{
    std::array<double, 3> direction{}; ///< a unit vector: x at longitude 0, in the middle of the left border; z up
    std::vector<double> power;         ///< radiance times solid angle, of each colour of the picture
};

/// The environment map of a picture's name, or of a formula in x, the longitude from -1 to 1, and y, the latitude from
/// -1/2 to 1/2: grey, its largest value 1. Throws InputError for what is neither.
LinearPicture sky_map(const std::string& text);

/// The solid angle of a pixel in this row of a map, row 0 at the top.
double solid_angle(int row, int width, int height);

/// The luminance of a map's pixels times their solid angles. Throws InputError, one line with the map's name, where it
/// is not twice as wide as high, and for what density_of_picture() refuses.
Density sky_density(const LinearPicture& map, const std::string& name);

/// The sum of luminance times solid angle over a map's pixels.
double sky_luminance(const LinearPicture& map);

/// A light at each place of the map. All have the same luminance, and together that of the map; each has the colour of
/// its pixel.
std::vector<SkyLight> sky_lights(const LinearPicture& map, std::span<const std::uint64_t> places);

/// Lights as lines of numbers under the names of their columns: direction, then power.
std::string lights_text(const std::vector<SkyLight>& lights);

}
