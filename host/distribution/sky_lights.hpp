// Environment maps as lights: pictures of all directions, longitude to the right, the pole at the top. z is up.
//
// Photographs are seen from inside, from the middle of the sphere: columns to the right turn clockwise seen from +z.
// The middle column is +x, a quarter to the left of it +y, the left border -x. So Blender takes environment textures
// (equirectangular; u = 1/2 - atan2(y, x) / (2 pi)). Globes are seen from outside: columns to the right turn
// counterclockwise seen from +z, as longitudes do, from +x at the left border over +y a quarter to the right. So
// pbrt-v3 takes them. Who takes one for the other has the mirror image of the light.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.2, which leaves the weights open: here those of
// pixels are luminance times their exact solid angle, and a row's places are even in the cosine of the polar angle, so
// that an even sky has even lights.
#pragma once

#include "base/densities/density.hpp"
#include "host/sampling/warp/warp.hpp"
#include "host/settings/distributions/distribution_config.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

struct SkyLight
{
    std::array<double, 3> direction{}; ///< a unit vector
    std::vector<double> power;         ///< radiance times solid angle, of each colour of the picture
};

/// The environment map of a picture's name, or of a formula in x, from -1 at the left border to 1 at the right one, and
/// y, the latitude from -1/2 to 1/2: grey, its largest value 1. Throws InputError for what is neither.
LinearPicture sky_map(const std::string& text);

/// The cosine of the polar angle of the border above this row of a map, row 0 at the top.
double border_cosine(int row, int height);

/// The solid angle of a pixel in this row of a map, row 0 at the top.
double solid_angle(int row, int width, int height);

/// The luminance of a map's pixels times their solid angles; clamp_rounding() is in force, and the density has its
/// note. Throws InputError, one line with the map's name, where it is not twice as wide as high, and for what
/// density_of_picture() refuses.
Density sky_density(const LinearPicture& map, const std::string& name);

/// The sum of luminance times solid angle over a map's pixels but for those below 0.
double sky_luminance(const LinearPicture& map);

/// A light at each place of the map. All have the same luminance, and together that of the map; each has the colour of
/// its pixel, where colours below 0 are 0.
std::vector<SkyLight> sky_lights(const LinearPicture& map, std::span<const std::uint64_t> places, SeenFrom seen_from);

/// Lights as lines of numbers under the names of their columns: direction, then power.
std::string lights_text(const std::vector<SkyLight>& lights);

}
