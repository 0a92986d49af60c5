// Darts of several classes by distances along a surface, and the distances that classes have along it. The distance of
// two points is the length of the shortest path between them, see host/distribution/surfaces/along_surface.hpp: there
// are no kernels, and no second program with the same bytes.
#pragma once

#include "host/distribution/surfaces/surface_pairs.hpp"
#include "host/sampling/surfaces/class_surface_darts.hpp"

#include <memory>
#include <vector>

namespace poissonlab {

/// Makes an engine that throws the darts of throw_class_surface_darts() by distances along the surface. Normals do not
/// matter.
std::unique_ptr<ClassSurfaceEngine> path_class_engine(const ClassSurfaceRequest& request);

/// Measures all pairs of classes, as surface_pairs() does, along the surface. Points that reach none of the other class
/// within some sixteen mean distances of it count as alone.
std::vector<SurfacePair> pairs_along(const FixedSurface& surface,
                                     const std::vector<std::vector<SurfacePoint>>& by_class);

}
