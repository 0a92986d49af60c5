// Vectors of space, as meshes hold them.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <cmath>

namespace poissonlab {

inline MeshPoint difference(const MeshPoint& a, const MeshPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

inline double dot(const MeshPoint& a, const MeshPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline MeshPoint cross(const MeshPoint& a, const MeshPoint& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The vector of length 1 in this direction; along z for the vector of length 0.
inline MeshPoint unit(const MeshPoint& a)
{
    const double length = std::hypot(a[0], a[1], a[2]);
    return length > 0 ? MeshPoint{a[0] / length, a[1] / length, a[2] / length} : MeshPoint{0, 0, 1};
}

}
