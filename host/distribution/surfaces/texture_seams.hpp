// Charts of texture coordinates, and what the seams between them do to distances of points.
#pragma once

#include "host/distribution/surfaces/laid_tiles.hpp"
#include "host/distribution/surfaces/texture_plane.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

/// Triangles of the plane that have edges in common, in space and in the plane, are of one chart.
struct Charts
{
    std::vector<std::uint32_t> chart; ///< of each triangle of the plane
    std::size_t count = 0;
};
Charts charts_of(const TriangleMesh& mesh, const FixedSurface& surface, const TexturePlane& plane);

/// A seam lies between two points of different charts, or whose texture coordinates are farther from each other than
/// twice their distance in space over the least stretch of their triangles: no short way on the surface leads there.
struct SeamDistances
{
    std::optional<double> least; ///< of points that see each other and have no seam between them, in the mesh's units
    std::size_t broken = 0;      ///< points that are nearer than that to one beyond a seam
};

/// `points` with their texture coordinates. Points farther than twice the mean distance from all others are
/// not looked at.
SeamDistances seam_distances(const FixedSurface& surface, const TexturePlane& plane,
                             const std::vector<Stretch>& stretch, const Charts& charts,
                             const std::vector<SurfacePoint>& points, const std::vector<TexturePoint>& texture,
                             std::int32_t least_cosine);

}
