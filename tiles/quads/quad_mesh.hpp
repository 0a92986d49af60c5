// Tiles are laid on closed surfaces of quadrilaterals, of any genus, where the plane is not enough.
//
// Fu and Leung, Texture tiling on arbitrary topological surfaces using Wang tiles, EGSR 2005. Faces are quads and not
// triangles, because a tile is a square; 3, 5 or more may meet in a vertex.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Numbers of vertices, counterclockwise as seen from outside. Side i leads from corner i to corner i + 1, and the unit
/// square of a quad has its corners 0, 1, 2, 3 at (0, 0), (1, 0), (1, 1), (0, 1).
using Quad = std::array<std::uint32_t, 4>;

struct QuadMesh
{
    std::vector<MeshPoint> vertices;
    std::vector<Quad> quads;
};

/// This is a corner of a quad, or the side that begins there.
struct QuadCorner
{
    std::uint32_t quad = 0;
    std::uint32_t corner = 0;

    bool operator==(const QuadCorner&) const = default;
};

/// Knows how the quads of a mesh are connected.
class QuadTopology
{
public:
    /// Throws InputError, a sentence: there are no quads, a quad has a corner twice, an edge has a quad on one side
    /// only, more than two meet at it, two are turned differently, or quads meet at a vertex alone.
    explicit QuadTopology(const QuadMesh& mesh);

    /// Returns the quad beyond a side, and its own side there.
    QuadCorner across(QuadCorner side) const { return across_[number_of(side)]; }

    /// Returns the number of a side's edge, which leads from the start to the end of its forward side, one of its two.
    std::uint32_t edge_of(QuadCorner side) const { return edges_[number_of(side)]; }
    bool is_forward(QuadCorner side) const { return number_of(side) < number_of(across(side)); }

    /// Returns the corners of quads at a vertex, counterclockwise, the one with the lowest number first.
    const std::vector<QuadCorner>& around(std::uint32_t vertex) const { return around_[vertex]; }
    std::uint32_t valence(std::uint32_t vertex) const { return static_cast<std::uint32_t>(around_[vertex].size()); }
    /// Returns the place of a corner among those at its vertex.
    std::uint32_t wedge_of(QuadCorner corner) const { return wedges_[number_of(corner)]; }

    std::size_t edges() const { return edge_count_; }
    std::size_t vertices() const { return vertex_count_; } ///< that quads have
    std::size_t irregular() const;                         ///< vertices where other than four quads meet
    /// Returns vertices less edges plus quads, which is 2 - 2 genus for each part of the surface.
    std::int64_t euler() const;

private:
    static std::size_t number_of(QuadCorner corner) { return std::size_t{corner.quad} * 4 + corner.corner; }
    void join_sides(const QuadMesh& mesh);
    void order_corners(const QuadMesh& mesh);

    std::vector<QuadCorner> across_;
    std::vector<std::uint32_t> edges_, wedges_;
    std::vector<std::vector<QuadCorner>> around_;
    std::size_t edge_count_ = 0, vertex_count_ = 0;
};

/// Divides each quad into parts x parts, which lie on its bilinear patch. Those of quad i come one after another, rows
/// along its side 0 from below, and have their corners in its order.
QuadMesh refined(const QuadMesh& mesh, const QuadTopology& topology, std::uint32_t parts);

/// Makes a step of Catmull and Clark's subdivision (1978): each quad becomes four, and the surface smoother.
QuadMesh smoothed(const QuadMesh& mesh, const QuadTopology& topology);

/// Returns the place of (u, v) of a quad, on the four triangles between its sides and the mean of its corners, which
/// are the same for all turns of the quad.
MeshPoint place_on(const QuadMesh& mesh, std::uint32_t quad, double u, double v);

/// This is the number of the side whose triangle has (u, v), and the shares there of the end of the side and of the
/// mean; the share of the side's start is the rest.
struct FanPlace
{
    std::uint32_t side = 0;
    double end = 0, middle = 0;
};
FanPlace fan_place(double u, double v);

/// Returns the mean of a quad's corners.
MeshPoint middle_of(const QuadMesh& mesh, std::uint32_t quad);

/// Returns the triangles of all quads, four of each, in the order of its sides; means follow the vertices.
TriangleMesh fans_of(const QuadMesh& mesh);

/// Returns (u, v) of a square after quarters of a turn, counterclockwise: corner i comes to corner i + quarters.
std::array<double, 2> turned_place(double u, double v, std::uint32_t quarters);

}
