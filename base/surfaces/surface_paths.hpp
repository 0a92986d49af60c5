// Shortest paths along a mesh from a place to all targets within reach, and the directions in which they begin.
//
// Paths are exact but for the rounding of doubles. Windows, bundles of straight lines that are unfolded triangle by
// triangle, leave the source and the vertices at which shortest paths may bend: those with an angle of more than 2 pi
// and those of open or branching edges (Mitchell, Mount, Papadimitriou, The discrete geodesic problem, SIAM J. Comput.
// 16(4), 1987). Windows that a known path to a vertex beats are dropped (Xin, Wang, Improving Chen and Han's algorithm
// on the discrete geodesic problem, ACM Transactions on Graphics 28(4), 2009, theorem 3.2). Paths need not go through
// a vertex in which two parts of a surface only touch.
#pragma once

#include "base/surfaces/triangle_tree.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

namespace paths {
class PathSearch;
}

struct SurfacePath
{
    std::uint32_t target = 0; ///< its number
    double length = 0;        ///< in the mesh's units
    MeshPoint way{};          ///< the vector of this length, in the plane of the source's triangle, in which it begins
};

class SurfacePaths
{
public:
    /// Triangles that meet share the numbers of their corners, and have areas. The mesh must outlive this.
    SurfacePaths(const TriangleMesh& mesh, const std::vector<MeshPosition>& targets);

    /// Replaces the targets.
    void aim_at(const std::vector<MeshPosition>& targets);

    /// Calls visit(number of the source, paths) once for each source, from several threads: the shortest path to each
    /// target that is no farther than `reach` along the surface, in the order of targets. Sources in corners and on
    /// edges, with a share below 1e-9, are moved inwards, by 1e-9 of the distance to the triangle's centre.
    void from_each(const std::vector<MeshPosition>& sources, double reach,
                   const std::function<void(std::size_t, std::span<const SurfacePath>)>& visit) const;

private:
    friend class paths::PathSearch;

    /// Returns the vertex at the beginning of a side; sides of a triangle are numbered 3 t, 3 t + 1, 3 t + 2.
    std::uint32_t start_of(std::uint32_t side) const { return mesh_.triangles[side / 3][side % 3]; }
    static std::uint32_t next_of(std::uint32_t side) { return side - side % 3 + (side + 1) % 3; }
    double along_first_side(const MeshPosition& target) const;
    void link_sides();
    void find_bends();

    const TriangleMesh& mesh_;
    std::vector<std::array<double, 2>>
        tops_;                         ///< of each side: its opposite corner, where the side is from 0, 0 to 1, 0
    std::vector<std::uint32_t> sides_; ///< in groups that lie on one edge
    std::vector<std::uint32_t> group_starts_;      ///< in sides_
    std::vector<std::uint32_t> group_of_;          ///< of each side
    std::vector<bool> may_bend_;                   ///< at each vertex
    std::vector<std::uint32_t> fan_starts_, fans_; ///< of each vertex: the sides opposite to it
    std::vector<MeshPosition> targets_;
    std::vector<std::uint32_t> target_starts_, target_order_; ///< of each triangle: its targets, by `target_along_`
    std::vector<double> target_along_; ///< of these: the foot on the first side, in lengths of that side
};

}
