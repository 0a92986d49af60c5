// Regions that are drawn: pictures and formulas as polygons.
#pragma once

#include "base/regions/plane_region.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// Cells of the lattice along the longest side of a formula's rectangle.
inline constexpr int formula_cells = 1024;

/// A picture's pixels that are brighter than half, 128 of 255 in sRGB, and whose alpha, if there is one, is more than
/// half: squares of side 1, from (0, 0) at the picture's lower left on. Exact. Throws InputError where none is, or the
/// file is no picture.
PlaneRegion region_of_picture(const std::string& file);

/// The part of a rectangle where a formula in x and y is above 0: polygons by marching squares on a lattice of
/// `formula_cells`, with corners where the formula would be 0 if it were linear between nodes. Throws InputError, which
/// names the formula, where it is nowhere positive or cannot be understood.
PlaneRegion region_of_formula(const std::string& formula, const std::array<double, 2>& low,
                              const std::array<double, 2>& high);

/// Does the place lie within the ring?
bool encloses(const RegionRing& ring, const std::array<double, 2>& place);

/// The polygons of rings that do not cross: outlines go round to the left, holes to the right and into the smallest
/// outline around them.
PlaneRegion region_of_rings(std::vector<RegionRing> rings);

/// A piece of a boundary that has the region on its left; nodes are numbers of places.
struct BoundaryPiece
{
    std::uint32_t from = 0, to = 0;
};

/// The region with this boundary. As many pieces end at each place as begin there, two at most: places where two of
/// them begin are corners in which rings touch.
PlaneRegion region_of_pieces(const std::vector<BoundaryPiece>& pieces,
                             const std::vector<std::array<double, 2>>& places);

}
