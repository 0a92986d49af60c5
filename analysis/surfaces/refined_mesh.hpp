// Meshes whose triangles are small enough for functions that vary over a given length.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <cstddef>

namespace poissonlab {

/// Halves all edges that are longer than `longest`, until none is. The surface stays the same, and triangles that share
/// an edge share its middle.
TriangleMesh with_edges_up_to(TriangleMesh mesh, double longest);

struct MeshShape
{
    double area = 0;
    std::size_t parts = 0;           ///< that no edge and no vertex connects
    std::size_t open_edges = 0;      ///< with one triangle
    std::size_t branching_edges = 0; ///< with more than two
};

/// Counts parts and edges. Triangles share a corner only if its number is the same in both.
MeshShape shape_of(const TriangleMesh& mesh);

double area_of(const TriangleMesh& mesh, const MeshTriangle& triangle);

}
