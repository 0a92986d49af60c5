// Points that move over a surface: by Lloyd's method, and along the forces of Gaussians.
//
// Lloyd's method moves each point to the place of the surface that is nearest to the centroid of its cell, see
// surface_cells.hpp. Gaussian blue noise (Ahmed, Ren, Wonka, ACM Transactions on Graphics 41(6), 2022) moves it along
// the force of all others. The surface itself attracts points by the same Gaussians, so that forces are in balance
// where points are equally dense, also beside open edges and where the surface bends. A force is what lies in the plane
// of the point's triangle, by distances straight through space; pairs of triangles that do not see each other have
// none.
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

/// Gaussian blue noise, with Gaussians as wide as a mean distance. An energy is the mean over points of the Gaussians
/// of all points, themselves among them, less those of the surface: random points have 1 on average.
RelaxedSurface descend_on_surface(const FixedSurface& surface, std::vector<SurfacePoint> points,
                                  const MeshPointSettings& settings, const std::function<void(std::size_t)>& on_step);

}
