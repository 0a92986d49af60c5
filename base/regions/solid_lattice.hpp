// Solids as whole numbers at the nodes of a lattice, linear in the tetrahedra between them.
//
// A cell has six tetrahedra, one for each order of the axes (Kuhn): its nodes are the cell's lowest corner and those
// that one comes to by steps along the axes in that order.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

struct SolidLattice
{
    std::array<std::uint32_t, 3> cells{}; ///< along each axis
    std::vector<std::int32_t> values{};   ///< a node each, x fastest: something is inside where they are above 0

    std::size_t nodes() const { return std::size_t{cells[0] + 1} * (cells[1] + 1) * (cells[2] + 1); }
    std::size_t node(std::uint32_t x, std::uint32_t y, std::uint32_t z) const
    {
        return (std::size_t{z} * (cells[1] + 1) + y) * (cells[0] + 1) + x;
    }
};

/// The largest size of values.
inline constexpr std::int32_t most_solid_value = 1 << 30;

/// The orders of the axes.
inline constexpr std::array<std::array<std::size_t, 3>, 6> axis_orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// Makes a lattice of values of any unit: they are multiplied by a factor, and cut off where no node beside them has
/// the other sign, so that those beside the surface have many digits. Infinite values are cut off as well.
SolidLattice solid_of_values(const std::array<std::uint32_t, 3>& cells, const std::vector<double>& exact);

/// Reads a formula in x, y and z at nodes: node 0 lies at `low`, others by steps of `step` away. Places where the
/// formula has no value are outside. Throws InputError where it is nowhere positive or cannot be understood.
SolidLattice solid_of_formula(const std::string& formula, const std::array<double, 3>& low, double step,
                              const std::array<std::uint32_t, 3>& cells);

/// The distance, in cells, that is added to one from the surface so that nothing nearer is taken for inside. Let d
/// be the distance of a place p from what is outside. It is the least of |p - q| over places q outside, and, as
/// |v - q| <= |p - q| + u . (v - p) + |v - p|^2 / (2 |p - q|) with u the direction from q to p, the mean of the
/// distances of a tetrahedron's corners v with p's weights exceeds d by the mean of |v - p|^2 / (2 d) at most; and by
/// that of |v - p|. The corners lie on a sphere of radius sqrt(3) / 2, so that the mean of |v - p|^2 is 3 / 4 at most:
/// the excess is at most the smaller of 0.375 / d and 0.867.
double spare_distance(double distance);

/// The places that are so far from what is outside, and spare_distance() farther, at least: in cells. Throws
/// InputError, a line that begins with `name`, where the surface has more than four million triangles.
SolidLattice inset_solid(const SolidLattice& solid, double distance, const std::string& name);

/// Calls visit(corners) for the triangles of the surface, in cells.
using SurfaceTriangle = std::array<std::array<double, 3>, 3>;
void for_each_surface_triangle(const SolidLattice& solid, const std::function<void(const SurfaceTriangle&)>& visit);

/// The part of a cell that is inside, of the values at its corners (x fastest).
double part_inside(const std::array<std::int64_t, 8>& corners);

}
