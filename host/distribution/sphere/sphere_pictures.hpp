// Pictures of points on the sphere: a globe from two sides, and a map of equal areas.
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
    globe,    ///< orthographic, twice: from the front above, and from the other side
    mollweide ///< equal areas; the middle is longitude 0, east is to the right
};

/// The colour of a place of the sphere, and a number that differs from that of places across a line.
struct GroundPlace
{
    std::array<std::uint8_t, 3> color{};
    std::uint32_t part = 0;
};

/// A picture twice as wide as high, white around the sphere, with lines between places of different parts.
PngPixels sphere_ground(SphereProjection projection,
                        const std::function<GroundPlace(const SpherePlace& place)>& ground);

/// The points as dots over that picture, whose file is `ground`; `radius` is that of dots on the unit sphere.
MarkPicture sphere_dots(SphereProjection projection, const std::vector<SpherePlace>& points, double radius,
                        const std::string& color, const std::string& ground);

}
