// The edges of a region in the unit square, in a grid of cells: how far away they are, and the share of a circle that
// lies within them.
#pragma once

#include "base/regions/plane_region.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// An edge from one corner to the next: the region is on its left.
struct RegionEdge
{
    std::array<double, 2> from{};
    std::array<double, 2> to{};
};

class BoundaryEdges
{
public:
    /// Takes polygons in [0, 1) x [0, 1) whose outlines go round against the clock and whose holes with it.
    explicit BoundaryEdges(const PlaneRegion& polygons);

    const std::vector<RegionEdge>& edges() const { return edges_; }

    /// The distance of a place from the nearest edge, or `most` if that is less.
    double distance(const std::array<double, 2>& place, double most) const;

    /// All edges that are no farther from a place than `reach`, in their order.
    std::vector<RegionEdge> edges_near(const std::array<double, 2>& place, double reach) const;

private:
    std::size_t cell_along(double coordinate) const;
    void list(std::uint32_t number);

    std::vector<RegionEdge> edges_;
    std::size_t cells_ = 1;                         ///< along each axis
    std::vector<std::vector<std::uint32_t>> lists_; ///< of each cell, x fastest: the edges that touch it
};

/// The share of the circle of that radius around a place of the region that lies in the region, from 0 to 1: Ripley's
/// weight is one over it. `edges` has all that are no farther from the place than the radius.
double share_of_circle(const std::array<double, 2>& place, double radius, std::span<const RegionEdge> edges);

}
