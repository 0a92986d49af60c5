#include "host/sampling/reference/voronoi_cells.hpp"

namespace poissonlab::reference {

VoronoiCells voronoi_cells(const PointSet& points)
{
    return points.dimension == 2 ? voronoi_cells_2d(points) : voronoi_cells_3d(points);
}

}
