// Lloyd's method on a surface: each point moves to the place of the surface that is nearest to the centroid of its
// cell, see surface_cells.hpp. Only triangles that a point sees are near to it: it does not change the side of a thin
// sheet.
#pragma once

#include "host/distribution/surfaces/surface_set.hpp"

#include <functional>
#include <vector>

namespace poissonlab {

struct RelaxedSurface
{
    std::vector<SurfacePoint> points;
    std::vector<double> energies; ///< before each step and after the last one, as results have them
};

/// Lloyd's method. An energy is the mean squared distance of the surface's places from the points of their cells, over
/// that of the hexagons of a triangular lattice in a plane of the same area.
RelaxedSurface relax_on_surface(const FixedSurface& surface, std::vector<SurfacePoint> points,
                                const MeshPointSettings& settings, const std::function<void(std::size_t)>& on_step);

}
