// This makes quads of a mesh, for tiles to lie on: its own faces, or squares of a cube or polycube that it is mapped
// to.
//
// Tarini, Hormann, Cignoni, Montani, PolyCube-maps, SIGGRAPH 2004: a mesh of any genus, mapped to the surface of unit
// cubes, whose squares are its quads.
#pragma once

#include "host/distribution/surfaces/texture_plane.hpp"
#include "host/settings/distributions/quad_config.hpp"
#include "host/settings/keys/keys.hpp"
#include "results/pictures/distribution_result.hpp"
#include "tiles/quads/quad_mesh.hpp"

namespace poissonlab {

struct QuadSurface
{
    QuadMesh mesh;
    QuadTopology topology;
    std::size_t coarse = 0; ///< quads before each was divided into parts x parts
};

/// Reads the keys of `settings` but for the mesh. `applies` says whether other keys, which `when` names, allow any.
void quad_keys(Keys& keys, QuadSettings& settings, bool applies, const std::string& when);

/// Makes the surface, unless the settings have it, or throws InputError, a line that names the file.
std::shared_ptr<const QuadSurface> quad_surface(const QuadSettings& settings);

/// Has the surface as triangles, four of each quad, in the order of their sides.
struct QuadTriangles
{
    TriangleMesh mesh;
    FixedSurface surface;
    std::vector<std::uint32_t> number_of; ///< of each triangle of the mesh, that of the surface; UINT32_MAX: it is flat

    /// Returns the point of the surface at a place of a quad; the triangle is UINT32_MAX where that one is flat.
    SurfacePoint point(std::uint32_t quad, double u, double v) const;
};
QuadTriangles triangles_of(const QuadMesh& mesh);

/// Measures what lengths the sides of quads have in space.
StretchOfAll stretch_of_quads(const QuadTriangles& triangles);

/// Returns counts of quads, vertices and edges, the Euler characteristic, and the stretch.
std::vector<DistributionNumber> quad_numbers(const QuadSurface& surface, const StretchOfAll& stretch);

}
