// Even points over a rectangle, for densities to be put on: a toroidal tiling, or the point set of any method.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.2, takes tilings of square tiles, as many along each
// side as its length asks for.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/sampling/sampler.hpp"
#include "host/sampling/warp/warp.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <variant>

namespace poissonlab {

/// The tiles of a rectangle: columns, rows.
struct EvenTileGrid
{
    std::uint32_t columns = 1;
    std::uint32_t rows = 1;

    std::uint64_t tiles() const { return std::uint64_t{columns} * rows; }
};

/// The grid over a rectangle of these proportions whose number of points is near `points` and whose tiles are nearly
/// square: the least sum of what both are wrong by, as ratios. Throws InputError for more than 65,536 tiles along a
/// side.
EvenTileGrid tile_grid(std::size_t points, std::uint32_t points_per_tile, double width, double height);

/// The method that points come from: a tile set that is there, or a sampler with its parameters.
using EvenMethod = std::variant<PoissonTileSet, SamplerChoice>;

/// Corner tiles of 3 colours and 32 points, the method where none is chosen.
SamplerChoice default_even_method();

/// The left and the right border of a rectangle: strangers, or the same line, as in a map of all longitudes.
enum class Seam
{
    open,
    closed
};

/// Points over a rectangle of these proportions, coordinates in parts of its sides. Tilings give exactly `points` of
/// them. Where tile_grid() has so many, the rectangle is that torus; else it is the part of a tiling from a corner that
/// holds so many, and with a closed seam as wide as whole tiles. The sets of other methods are made for a square, of
/// which the rectangle is the part from the lowest corner: they close along the longer side, and have about `points`.
/// Throws InputError where the method cannot make them.
SquarePoints even_points(const EvenMethod& method, std::size_t points, int width, int height, std::uint64_t seed,
                         const DistributionPlace& place, Seam seam = Seam::open);

/// Warps points by the engine of the workplace. Throws InputError where its device has no memory for that.
PixelPlaces warp_points(const Density& density, const SquarePoints& points, const DistributionPlace& place);

}
