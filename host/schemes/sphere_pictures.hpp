// Pictures of the sphere, its points and tilings: a globe from two sides, and maps.
#pragma once

#include "base/images/png_file.hpp"
#include "results/pictures/mark_picture.hpp"
#include "tiles/sphere/healpix.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// The way in which directions become places of a picture.
enum class SphereProjection
{
    globe,          ///< orthographic, twice: from the front above, and from the other side
    mollweide,      ///< equal areas; the middle is longitude 0, east is to the right
    equirectangular ///< longitude and latitude, as textures of spheres have them; the middle and right as before
};

/// The colour of a place of the sphere, and a number that differs from that of places across a line.
struct GroundPlace
{
    std::array<std::uint8_t, 3> color{};
    std::uint32_t part = 0;
};

/// A picture twice as wide as high, white around the sphere, with lines between places of different parts. A globe may
/// stand in light from the upper left, in which lines are darker.
PngPixels sphere_ground(SphereProjection projection, const std::function<GroundPlace(const SpherePlace& place)>& ground,
                        bool is_lit = false);

/// The points as dots over that picture, whose file is `ground`; `radius` is that of dots on the unit sphere.
MarkPicture sphere_dots(SphereProjection projection, const std::vector<SpherePlace>& points, double radius,
                        const std::string& color, const std::string& ground);

}
