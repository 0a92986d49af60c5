// How a parametrisation stretches a surface: by the singular values of the map from texture coordinates to space.
//
// Sander, Snyder, Gortler, Hoppe, Texture mapping progressive meshes, SIGGRAPH 2001, section 3.
#pragma once

#include "host/distribution/surfaces/texture_plane.hpp"

#include <vector>

namespace poissonlab {

/// The singular values of a triangle's map: how long a unit of texture coordinates becomes in space, in the mesh's
/// units, where it becomes shortest and longest.
struct Stretch
{
    double least = 0;
    double greatest = 0;
};

/// Returns the singular values of a triangle with these corners in space.
Stretch stretch_of(const std::array<MeshPoint, 3>& places, const TextureTriangle& triangle, double tiles_per_unit);

/// Returns the singular values of the plane's triangles, in their order.
std::vector<Stretch> stretches_of(const FixedSurface& surface, const TexturePlane& plane);

/// The stretch of all triangles with an area in the plane.
struct StretchOfAll
{
    Stretch extremes;            ///< the least and the greatest of all
    double area_distortion = 1;  ///< the greatest area in space of an area in the plane, over the least
    double root_mean_square = 1; ///< Sander's L2, of equal areas in both: 1 where all lengths are kept
};
StretchOfAll stretch_of_all(const FixedSurface& surface, const TexturePlane& plane, const std::vector<Stretch>& each);

}
