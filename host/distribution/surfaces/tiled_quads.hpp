// This lays Poisson disk tiles on a surface of quads, where they fit everywhere, because there are no charts.
#pragma once

#include "host/distribution/surfaces/quad_surface.hpp"
#include "host/distribution/surfaces/surface_set.hpp"

namespace poissonlab {

/// Returns the surface of the settings' quads as triangles.
std::shared_ptr<const SurfaceMesh> mesh_of_quads(const MeshPointSettings& settings);

/// Returns the distance at which saturated darts are about so many points on quads, in sides of these.
double quad_distance(std::size_t points, std::size_t quads);

/// Throws InputError, a sentence, where tiles of so few points do not exist, or are too large.
void check_quad_points(std::size_t points, std::size_t quads);

/// Lays the tiles; there are about as many points as settings ask for.
SurfaceSet tiled_quads(const MeshPointSettings& settings, std::shared_ptr<const SurfaceMesh> mesh, std::uint64_t seed);

}
