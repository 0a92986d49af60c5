// A region of space in whole numbers: exact and fast answers to what lies inside.
//
// As for regions of the plane (fixed_region.hpp) positions are a corner of the unit torus' fixed-point coordinates,
// 2^31 along the region's longest side. Boxes are those of positions, and balls are held against squared distances from
// a middle that lies between positions, in halves of them. A solid is read at the nodes of a lattice, 128 cells along
// the longest side. Between them it is what is linear in each of a cell's six tetrahedra (those of Kuhn: coordinates in
// a cell, in order of size, say which), in whole numbers, and a position is inside where that is above 0.
//
// With a margin positions that are nearer than it to the surface are outside as well: boxes and balls are smaller by
// it. Nodes of solids have the distance from the surface, less the margin, then. Distances that are linear between
// nodes are too large, by what solid_lattice.hpp says, and the margin is enlarged by that: whole balls are inside for
// sure, but one may be left out that would touch the surface.
//
// kernels/common/regions/inside_space.clh does the same.
#pragma once

#include "base/geometry/torus.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/space_region.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// Positions low, low + 1, ..., high along each axis.
struct FixedSpaceBox
{
    TorusPoint<3> low{};
    TorusPoint<3> high{};
};

class FixedSpace
{
public:
    static constexpr int coordinate_bits = 31;
    static constexpr int lattice_shift = 24; ///< cells of a solid's lattice are 2^lattice_shift positions wide

    /// The side of the torus in units of a region in this box.
    static double torus_side(const SpaceBox& box) { return box.longest() / ((1u << coordinate_bits) - 1) * 0x1p32; }

    /// `margin` in unit lengths of the torus, from 0 to 1/2. Throws InputError for solids that are nowhere, and for
    /// formulas that cannot be understood.
    explicit FixedSpace(const SpaceRegion& region, double margin = 0);

    bool contains(const TorusPoint<3>& position) const;
    RegionSide side_of(const FixedSpaceBox& box) const;

    /// A box that has the region inside: the least one, but of solids that of the cells in which something is.
    const FixedSpaceBox& extent() const { return extent_; }

    /// A position in the region's own units: its lowest corner and `unit` times the position, rounded once each.
    std::array<double, 3> own(const TorusPoint<3>& position) const;

    double unit() const { return unit_; }
    double volume() const { return volume_; }    ///< in cubes of its own units, margins aside
    const SpaceBox& box() const { return box_; } ///< in its own units

    // Kernels are told this.
    SpaceShape shape() const { return shape_; }
    const FixedSpaceBox& limits() const { return limits_; }              ///< empty where low is above high
    std::uint64_t squared_radius() const { return squared_radius_; }     ///< of a ball, in halves of positions
    const std::array<std::uint32_t, 3>& cells() const { return cells_; } ///< of a solid's lattice, along each axis
    std::span<const std::int32_t> values() const { return values_; }     ///< at its nodes, x fastest
    /// The number of cells below each node, along all axes, in which something is inside.
    std::span<const std::uint32_t> filled() const { return filled_; }

private:
    using Cell = std::array<std::uint32_t, 3>;

    void set_lattice(const SpaceRegion& region, double margin);
    void count_filled();
    void shrink_extent();
    double volume_of_lattice() const;
    std::size_t node(const Cell& cell) const
    {
        return (std::size_t{cell[2]} * (cells_[1] + 1) + cell[1]) * (cells_[0] + 1) + cell[0];
    }
    std::array<std::int64_t, 8> corners_of(const Cell& cell) const;
    bool is_within_limits(const TorusPoint<3>& position) const;
    RegionSide side_of_ball(const FixedSpaceBox& box) const;
    RegionSide side_of_solid(const FixedSpaceBox& box) const;

    SpaceShape shape_;
    SpaceBox box_;
    double unit_ = 1, volume_ = 0;
    FixedSpaceBox extent_, limits_;
    std::uint64_t squared_radius_ = 0;
    Cell cells_{};
    std::vector<std::int32_t> values_;
    std::vector<std::uint32_t> filled_;
};

}
