// These functions stand in for triangulations in 3D where a program lacks them: a run of sets in 3D asks for the
// module.
#include "base/errors/missing_module.hpp"
#include "base/geometry/torus_delaunay.hpp"

namespace poissonlab {

void need_triangulations_3d() { throw MissingModule("space"); }

void visit_tetrahedra(const PointSet& /*points*/, const std::function<void(const DelaunaySimplex<3>&)>& /*visit*/)
{
    need_triangulations_3d();
}

void visit_voronoi_cells_3d(const PointSet& /*points*/, const std::function<void(const TorusCell<3>&)>& /*visit*/)
{
    need_triangulations_3d();
}

}
