// The bricks of cells in which dart throwing finds a region.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/darts/dart_request.hpp"

#include <cstddef>
#include <memory>

namespace poissonlab {

/// The bricks of level 0 cells that are not outside of a region; empty where there are more than `most` of them. Time
/// is that of the bricks and of the boundary, whatever the box is.
std::shared_ptr<const DartBricks> bricks_of(const FixedRegion& region, const CellHierarchy& cells, std::size_t most);
std::shared_ptr<const DartBricks> bricks_of(const FixedSpace& space, const CellHierarchy& cells, std::size_t most);

}
