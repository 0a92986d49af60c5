// Points that move over a surface: each comes to the place that is nearest to where it would go in space.
#pragma once

#include "base/surfaces/triangle_tree.hpp"
#include "host/distribution/surfaces/given_points.hpp"

namespace poissonlab {

/// Moves points by vectors in units of the grid. A point comes only to triangles whose normals are near enough to its
/// own, so that it does not change the side of a thin sheet.
class SurfaceMoves
{
public:
    /// The surface must outlive this.
    SurfaceMoves(const FixedSurface& surface, double normal_angle)
        : surface_(surface), mesh_(triangles_on_grid(surface)), tree_(mesh_), least_cosine_(least_cosine(normal_angle))
    {}

    SurfacePoint moved(const SurfacePoint& point, const MeshPoint& by) const
    {
        MeshPoint place{};
        for (std::size_t k = 0; k < 3; ++k) place[k] = point.place[k] + by[k];
        const SurfaceTriangle& own = surface_.triangles[point.triangle];
        const MeshPosition nearest = tree_.nearest(place, [&](std::uint32_t triangle) {
            return cosine_between(own, surface_.triangles[triangle]) >= least_cosine_;
        });
        return surface_point(surface_, nearest, place);
    }

private:
    const FixedSurface& surface_;
    TriangleMesh mesh_;
    TriangleTree tree_;
    std::int32_t least_cosine_;
};

}
