// A surface whose points are those of a Poisson disk tiling in the plane of its texture coordinates.
//
// Li, Lo, Leung, Fu, Dual Poisson-disk tiling: an efficient method for distributing features on arbitrary surfaces,
// TVCG 14(5), 2008, lay tiles on surfaces by a parametrisation as well, of quadrangles that are nearly squares. Here it
// is whatever the mesh has, and what it makes of distances is measured.
//
// This lays Poisson disk tiles on a surface of quads, where they fit everywhere, because there are no charts.
#pragma once

#include "host/distribution/surfaces/quad_surface.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/distribution/surfaces/texture_plane.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The facts of a tiling on a surface, beside its points.
struct SurfaceTiling
{
    double tiles_per_unit = 1;
    double tile_distance = 0;    ///< that the tile set is proven to keep, in texture coordinates; 0: none is
    std::size_t laid = 0;        ///< points of the tiling on the surface, of which some may be left out
    std::size_t repetitions = 0; ///< of points, where texture coordinates overlap
    double covered_area = 0;     ///< of what has texture coordinates, in squares of the mesh's units
    StretchOfAll stretch;
    std::size_t charts = 0;
    std::optional<double> least_without_seams; ///< see SeamDistances
    std::size_t broken = 0;
};

/// Reads the tile set, unless the settings have it, or builds the default one. Throws InputError.
std::shared_ptr<const PoissonTileSet> surface_tiles(const MeshPointSettings& settings, const DistributionPlace& place);

/// Returns the name of the tiles in facts and labels.
std::string words_for_tiles(const MeshPointSettings& settings);

/// Throws InputError, a line that names the file, where the mesh has no texture coordinates, or no area in them.
void check_texture(const MeshPointSettings& settings, const SurfaceMesh& mesh);

/// Throws InputError, a sentence, where settings ask for more tiles or points than there can be.
void check_tiled_surface(const MeshPointSettings& settings, const SurfaceMesh& mesh);

/// Lays the tiles; with settings.min_distance, points are left out that are nearer to one of lower
/// rank, or, in sets without ranks, to one that chance prefers.
SurfaceSet tiled_surface(const MeshPointSettings& settings, std::shared_ptr<const SurfaceMesh> mesh, std::uint64_t seed,
                         const DistributionPlace& place);

/// The numbers of its tiling, beside those that all sets have.
std::vector<DistributionNumber> tiling_numbers(const SurfaceSet& set);

/// Returns the surface of the settings' quads as triangles.
std::shared_ptr<const SurfaceMesh> mesh_of_quads(const MeshPointSettings& settings);

/// Returns the distance at which saturated darts are about so many points on quads, in sides of these.
double quad_distance(std::size_t points, std::size_t quads);

/// Throws InputError, a sentence, where tiles of so few points do not exist, or are too large.
void check_quad_points(std::size_t points, std::size_t quads);

/// Lays the tiles; there are about as many points as settings ask for.
SurfaceSet tiled_quads(const MeshPointSettings& settings, std::shared_ptr<const SurfaceMesh> mesh, std::uint64_t seed);

}
