// Points on a torus of 2^32 units a side, sorted by the cells of a grid, for methods that ask for many nearest points
// before they add any.
#pragma once

#include "host/sampling/classics/torus_cells.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

class SortedTorus
{
public:
    SortedTorus(std::span<const TorusPosition> points, int dimension);

    /// The squared distance of the nearest point, or that of any one that is at most `enough`; UINT64_MAX without
    /// points.
    std::uint64_t squared_nearest(const TorusPosition& position, std::uint64_t enough = 0) const;

    /// Positions that are asked for in the order of their cells find in caches what the ones before them have looked
    /// at.
    const TorusCells& cells() const { return cells_; }

private:
    std::uint64_t nearest_within(const TorusPosition& position, std::uint64_t reach) const;

    TorusCells cells_;
    std::vector<std::uint32_t> starts_; ///< the first point of each cell, and the end of the last
    std::vector<TorusPosition> points_; ///< sorted
};

}
