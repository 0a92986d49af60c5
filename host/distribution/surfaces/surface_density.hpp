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
#include <cstdint>
#include <functional>
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

    /// The value of the text there, which may be negative or not finite.
    double value_at(const FixedSurface& surface, const SurfacePoint& point);

    const std::string& name() const { return name_; }

private:
    std::string name_;
    const TriangleMesh& mesh_;
    std::size_t column_ = 0;
    Density picture_;
    std::unique_ptr<SpaceFormula> formula_;
};

/// Random points of a density, with the density at each, as a part of the largest one.
struct DensityCandidates
{
    std::vector<SurfacePoint> points;
    std::vector<double> densities;
    double integral = 0;              ///< of those parts over the surface, from some 10^5 places
    std::uint64_t darts = 0;          ///< random places from which the points were chosen
    std::uint64_t larger = 0;         ///< of these: places with a larger density than the largest of some 10^5
    std::uint64_t larger_corners = 0; ///< corners of triangles where the density is more than a tenth larger than it
};

/// Returns `count` independent points. Peaks that none of some 10^5 places meets are flattened; candidates and corners
/// of triangles that lie on such peaks are counted, and others stay unknown. Throws InputError, with
/// the density's name, if the density is 0 everywhere, or nearly, or large in too small a part of the surface.
DensityCandidates density_candidates(const FixedSurface& surface, SurfaceDensity& density, std::size_t count,
                                     const StreamKey& stream,
                                     const std::function<void(const std::string& what)>& on_step = {});

/// Returns `kept` of the candidates in progressive order. Uses a heap on the host.
std::vector<SurfacePoint> eliminate_by_density(const FixedSurface& surface, const DensityCandidates& candidates,
                                               std::size_t kept, double angle);

}
