// Pictures of corner cubes, Wang cubes, their tilings and Poisson sphere tile regions, in isometric projection.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, section 4.6, figures 4.28, 4.29 and 4.32. Seen
// from the south-east and above, unlike the cubes of spectra: x to the lower right, y to the upper right, z
// upwards. So the faces in sight are the top, the south on the left, and the east on the right, and each has
// its own axes to the right and upwards.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "tiles/tilings/tile_set.hpp"

#include <array>
#include <cstddef>
#include <numbers>
#include <vector>

namespace poissonlab {

/// Corner cubes or Wang cubes: a block of a tiling, or a set.
struct CubeGrid
{
    Color colors = 2;
    std::array<std::size_t, 3> size{1, 1, 1}; ///< in x, y and z
    std::vector<TileIndex> cubes;             ///< x fastest, then y, then z upwards; a set may have fewer
    bool has_gaps = false;                    ///< a set: cubes apart, size[0] in a row, rows downwards
    TileKind kind = TileKind::cube;           ///< or wang_cube
};

/// The outer faces in sight, with a disk at each of their lattice points. In a set each cube shows seven
/// corners; the eighth, hidden exactly behind the nearest, is the ring around it. Of Wang cubes the faces have their
/// colours; in a set, the field in the middle of a face has that of the hidden face behind it. Edges are 32 units long.
/// Throws std::logic_error for a block with more or fewer cubes than its size says.
Drawing draw_cubes(const CubeGrid& grid);

/// The largest Poisson sphere radius for which the regions fit in a unit cube.
constexpr double max_sphere_region_radius = 1 / (2 * (1 + 2 * std::numbers::sqrt2));

/// The faces in sight of the cubes with the Poisson sphere tile regions that they cut, for a radius r, half the
/// minimum distance, in units of the cube's side: octagons in the colours of the corners, strips half and half in
/// the colours of their ends, but paler, and the rest of the faces in white. Throws InputError unless
/// 0 < radius <= max_sphere_region_radius, std::logic_error as above.
Drawing draw_cube_regions(const CubeGrid& grid, double radius);

}
