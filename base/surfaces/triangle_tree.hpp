// Finds the triangle of a mesh that is nearest to a place, by a tree of boxes.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// A place on a mesh.
struct MeshPosition
{
    std::uint32_t triangle = 0;
    std::array<double, 3> shares{}; ///< of its corners, from 0 to 1, with the sum 1
};

MeshPoint place_of(const TriangleMesh& mesh, const MeshPosition& position);

class TriangleTree
{
public:
    /// The mesh must have at least one triangle, and must outlive the tree.
    explicit TriangleTree(const TriangleMesh& mesh);

    /// Returns the position nearest to a place; if several are, the first one in the tree's order.
    MeshPosition nearest(const MeshPoint& place) const
    {
        return nearest(place, [](std::uint32_t) { return true; });
    }

    /// Looks only at triangles for which the function is true, of which there is one or more.
    MeshPosition nearest(const MeshPoint& place, const std::function<bool(std::uint32_t triangle)>& counts) const;

private:
    struct Node
    {
        MeshPoint low, high;
        std::uint32_t begin, end; ///< of the triangles in order_
        std::uint32_t right;      ///< the second half; the first one is the next node. 0: a leaf
    };

    std::uint32_t add_node(std::uint32_t begin, std::uint32_t end);

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}
