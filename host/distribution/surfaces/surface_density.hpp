// Points on a surface that follow a density, by sample elimination.
//
// Yuksel, Sample elimination for generating Poisson disk sample sets, 2015, section 4.3 (adaptive sampling), as in
// host/sampling/varied/varied_elimination.hpp: candidates are random points of that density, and distances of pairs
// are divided by the smaller of the distances that densest packings of the densities at the two points have.
#pragma once

#include "base/densities/density.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/random/random.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

/// A density over a surface: a formula in x, y and z in the mesh's units, numbers of its vertices, or a picture over
/// its texture coordinates, which repeats beyond 0 and 1.
class SurfaceDensity
{
public:
    /// `text` is a column of the mesh, a formula, or the name of a picture, whose channel is `from`. Throws
    /// InputError.
    SurfaceDensity(const std::string& text, const std::string& from, const TriangleMesh& mesh);

    /// The density at a point, in any unit. Throws InputError, with the place, where it is negative or not finite.
    double at(const FixedSurface& surface, const SurfacePoint& point);

private:
    double value_at(const FixedSurface& surface, const SurfacePoint& point);

    std::string name_;
    const TriangleMesh& mesh_;
    std::size_t column_ = 0;
    Density picture_;
    std::unique_ptr<SpaceFormula> formula_;
};

/// Random points of a density, with the density at each.
struct DensityCandidates
{
    std::vector<SurfacePoint> points;
    std::vector<double> densities;
    double integral = 0; ///< the density's integral over the surface, from some 10^5 places
};

/// Returns `count` independent points. Peaks that none of these places meets are flattened. Throws InputError if the
/// density is 0 everywhere, or nearly.
DensityCandidates density_candidates(const FixedSurface& surface, SurfaceDensity& density, std::size_t count,
                                     const StreamKey& stream);

/// Returns `kept` of the candidates in progressive order. Uses a heap on the host.
std::vector<SurfacePoint> eliminate_by_density(const FixedSurface& surface, const DensityCandidates& candidates,
                                               std::size_t kept, double angle);

}
