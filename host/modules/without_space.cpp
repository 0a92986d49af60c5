// What the core calls of triangulations in 3D, for programs without them: the first set that is measured asks for the
// module.
#include "base/errors/missing_module.hpp"
#include "base/geometry/torus_delaunay.hpp"

namespace poissonlab {

void visit_tetrahedra(const PointSet& /*points*/, const std::function<void(const DelaunaySimplex<3>&)>& /*visit*/)
{
    throw MissingModule("space");
}

void visit_voronoi_cells_3d(const PointSet& /*points*/, const std::function<void(const TorusCell<3>&)>& /*visit*/)
{
    throw MissingModule("space");
}

}
