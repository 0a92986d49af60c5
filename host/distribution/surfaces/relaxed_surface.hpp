// Points on a surface that move until they are even.
//
// Lloyd's method moves each point to the place of the surface that is nearest to the centroid of its cell; see
// surface_cells.hpp. Gaussian blue noise (Ahmed, Ren, Wonka, ACM Transactions on Graphics 41(6), 2022) moves all points
// at once along the forces that Gaussians of their distances exert, in the plane of each point's triangle, and then to
// the nearest place. Only triangles that a point sees are near to it: it does not change the side of a thin sheet.
#pragma once

#include "host/distribution/surfaces/surface_set.hpp"

#include <functional>
#include <vector>

namespace poissonlab {

/// The number of steps that are made where settings do not say it.
std::uint32_t usual_iterations(SurfaceMethod method);

struct RelaxedSurface
{
    std::vector<SurfacePoint> points;
    std::vector<double> energies; ///< before each step and after the last one, as results have them
};

/// Lloyd's method. An energy is the mean squared distance of the surface's places from the points of their cells, over
/// that of the hexagons of a triangular lattice in a plane of the same area.
RelaxedSurface relax_on_surface(const FixedSurface& surface, std::vector<SurfacePoint> points,
                                const MeshPointSettings& settings, const std::function<void(std::size_t)>& on_step);

/// Gaussian blue noise. An energy is gaussian_energy(): random points have 1 on average. A step that raises it, as may
/// happen at edges of the mesh, is taken back, and the next ones are shorter.
RelaxedSurface descend_on_surface(const FixedSurface& surface, std::vector<SurfacePoint> points,
                                  const MeshPointSettings& settings, const std::function<void(std::size_t)>& on_step);

}
