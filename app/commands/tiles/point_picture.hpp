// The points of a toroidal tiling as a picture: a pixel a point, with its place in the pixel and its place in an order
// whose first parts are good sets.
//
// Barrett, Progressive tiling 2D blue noise point sets encoded as images, nothings.org/gamedev/blue_noise, 2021: pixels
// with alpha have a point, red and green say where in the pixel. The order is by rank, and among the tiles by Roberts'
// R2 sequence, as in runtime/point_distribution.hpp.
#pragma once

#include "base/images/png_file.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <cstdint>

namespace poissonlab {

/// Red, green, blue, alpha, rows from y = 0 on. The point of pixel (i, j) is at (i + red / 255, j + green / 255)
/// pixels, rounded; it is number (alpha - 1) 256 + blue of the order. Pixels without points are 0.
///
/// `pixels`: of a side; 0: the least power of two, from 8 on, whose pixels hold one point each in any tiling, which
/// follows from the set's proven distance. Throws InputError, a line without place, for sets that are not ranked, not
/// in the plane, or without a proven distance where it is needed, for more points than alpha and blue can number
/// (65,280), and where two points are in one pixel.
PngPixels point_picture(const PoissonTileSet& tiles, const PoissonTiling& tiling, int pixels = 0);

}
