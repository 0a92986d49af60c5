// Points that move over a surface: by Lloyd's method, and along the forces of Gaussians.
//
// Lloyd's method moves each point to the place of the surface that is nearest to the centroid of its cell. Gaussian
// blue noise (Ahmed, Ren, Wonka, ACM Transactions on Graphics 41(6), 2022) moves it along the force of all others. The
// surface itself attracts points by the same Gaussians, so that forces are in balance where points are equally dense,
// also beside open edges and where the surface bends. A force is what lies in the plane of the point's triangle, by
// distances straight through space; pairs of triangles that do not see each other have none.
//
// Voronoi cells of points on a surface: each place belongs to the nearest, straight through space, of the points that
// its triangle sees, whose normals are near enough to its own.
//
// Yan, Levy, Liu, Sun, Wang, Isotropic remeshing with fast and exact computation of restricted Voronoi diagram,
// Computer Graphics Forum 28(5), 2009: triangles are cut by the bisectors of near points. Cells are exact but for the
// rounding of doubles, and of places by a unit of the grid.
#pragma once

#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
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

/// The most pieces, nearly, into which the surface is divided that attracts so many points.
double gaussian_charges(const FixedSurface& surface, double points);

/// Integrals over a cell, in units of the grid.
struct SurfaceCell
{
    double area = 0;
    MeshPoint moment{}; ///< of places minus the point
    double energy = 0;  ///< of their squared distances from the point
};

class SurfaceCells
{
public:
    /// Divides the triangles into pieces that are no larger than a few of so many cells. The surface must outlive it.
    SurfaceCells(const FixedSurface& surface, std::size_t points, double normal_angle);

    /// Returns the cells of the points, of which there is one or more. The result does not depend on the number of
    /// threads.
    std::vector<SurfaceCell> of(const std::vector<SurfacePoint>& points) const;

private:
    const FixedSurface& surface_;
    std::vector<SurfacePiece> pieces_;
    std::int32_t least_cosine_;
    std::uint64_t reach_; ///< neighbours within are listed
};

}
