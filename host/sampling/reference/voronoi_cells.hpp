// The two halves of reference::voronoi_cells().
#pragma once

#include "host/sampling/voronoi_cells.hpp"

namespace poissonlab::reference {

VoronoiCells voronoi_cells_2d(const PointSet& points);
VoronoiCells voronoi_cells_3d(const PointSet& points);

}
