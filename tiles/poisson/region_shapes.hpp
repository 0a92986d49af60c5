// The regions of tiles as shapes: convex polygons in 2D, convex polyhedra in 3D.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.3, 4.30, 4.31 and 4.33. The modified
// regions of corners are regular octagons and great rhombicuboctahedra, those of 3D edges octagonal prisms,
// those of faces slabs without their corners.
#pragma once

#include "tiles/poisson/tile_regions.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// A position or a direction; units of tile_regions.hpp. In 2D the last coordinate is 0.
using ShapeVector = std::array<double, 3>;

/// The positions p with normal . p <= limit.
struct ShapeHalfSpace
{
    ShapeVector normal{};
    double limit = 0;
};

struct ShapeFace
{
    std::vector<ShapeVector> corners; ///< counterclockwise as seen from where the normal points to
    ShapeVector normal{};             ///< outwards, of any length; of a polygon: upwards
};

/// A convex polygon has one face, a convex polyhedron at least four; none: empty.
struct RegionShape
{
    std::vector<ShapeFace> faces;
};

/// The box from `low` to `high`.
RegionShape box_shape(int dimension, const ShapeVector& low, const ShapeVector& high);

/// The part of a shape that lies in a half space.
RegionShape clipped(const RegionShape& shape, const ShapeHalfSpace& half);

/// The part of a shape that lies in a box.
RegionShape clipped_to_box(RegionShape shape, int dimension, const ShapeVector& low, const ShapeVector& high);

/// The whole region of a cell whose lowest corner is the lattice point `base`; of the interior, that of one
/// tile.
RegionShape region_shape(const TileRegions& regions, std::uint8_t axes, const std::array<std::int32_t, 3>& base);

}
