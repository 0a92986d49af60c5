#include "analysis/surfaces/refined_mesh.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace poissonlab {
namespace {

using MeshEdge = std::pair<std::uint32_t, std::uint32_t>;

constexpr std::uint32_t no_middle = UINT32_MAX;

MeshEdge edge_between(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

double squared_length(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b)
{
    const MeshPoint edge = difference(mesh.vertices[a], mesh.vertices[b]);
    return dot(edge, edge);
}

/// Adds the middles of all edges longer than a limit to the mesh's vertices, and returns their numbers.
std::map<MeshEdge, std::uint32_t> middles_of_long_edges(TriangleMesh& mesh, double longest)
{
    std::map<MeshEdge, std::uint32_t> middles;
    for (const MeshTriangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            if (squared_length(mesh, a, b) <= longest * longest) continue;
            const auto number = static_cast<std::uint32_t>(mesh.vertices.size());
            if (!middles.try_emplace(edge_between(a, b), number).second) continue;
            const MeshPoint &p = mesh.vertices[a], &q = mesh.vertices[b];
            mesh.vertices.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
        }
    return middles;
}

/// Adds the parts of a triangle. middles[k] is the middle of the edge from corner k to the next one, or no_middle.
void add_parts(TriangleMesh& mesh, MeshTriangle t, MeshTriangle middles, std::vector<MeshTriangle>& parts)
{
    const auto halved = 3 - std::ranges::count(middles, no_middle);
    // The corners are rotated until the first edge is a halved one, and, if two are halved, the second edge as well.
    const auto is_turned = [&] { return middles[0] != no_middle && (halved == 1 || middles[1] != no_middle); };
    for (int turn = 0; turn < 3 && !is_turned(); ++turn) {
        std::ranges::rotate(t, t.begin() + 1);
        std::ranges::rotate(middles, middles.begin() + 1);
    }
    const auto [a, b, c] = t;
    const auto [m, n, o] = middles;
    if (halved == 0)
        parts.push_back(t);
    else if (halved == 1)
        parts.insert(parts.end(), {{a, m, c}, {m, b, c}});
    else if (halved == 3)
        parts.insert(parts.end(), {{a, m, o}, {m, b, n}, {o, n, c}, {m, n, o}});
    else if (squared_length(mesh, a, n) < squared_length(mesh, m, c))
        parts.insert(parts.end(), {{m, b, n}, {a, m, n}, {a, n, c}});
    else
        parts.insert(parts.end(), {{m, b, n}, {a, m, c}, {m, n, c}});
}

}

TriangleMesh with_edges_up_to(TriangleMesh mesh, double longest)
{
    for (;;) {
        const auto middles = middles_of_long_edges(mesh, longest);
        if (middles.empty()) return mesh;
        std::vector<MeshTriangle> parts;
        for (const MeshTriangle& t : mesh.triangles) {
            MeshTriangle of{};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto found = middles.find(edge_between(t[k], t[(k + 1) % 3]));
                of[k] = found == middles.end() ? no_middle : found->second;
            }
            add_parts(mesh, t, of, parts);
        }
        mesh.triangles = std::move(parts);
    }
}

double area_of(const TriangleMesh& mesh, const MeshTriangle& triangle)
{
    const MeshPoint& a = mesh.vertices[triangle[0]];
    const MeshPoint normal =
        cross(difference(mesh.vertices[triangle[1]], a), difference(mesh.vertices[triangle[2]], a));
    return std::sqrt(dot(normal, normal)) / 2;
}

MeshShape shape_of(const TriangleMesh& mesh)
{
    MeshShape shape{.parts = mesh.vertices.size()};
    std::vector<std::uint32_t> above(mesh.vertices.size());
    std::iota(above.begin(), above.end(), 0u);
    const auto top = [&](std::uint32_t vertex) {
        while (above[vertex] != vertex) vertex = above[vertex] = above[above[vertex]];
        return vertex;
    };
    std::map<MeshEdge, std::size_t> triangles_at;
    for (const MeshTriangle& t : mesh.triangles) {
        shape.area += area_of(mesh, t);
        for (std::size_t k = 0; k < 3; ++k) {
            ++triangles_at[edge_between(t[k], t[(k + 1) % 3])];
            const std::uint32_t a = top(t[k]), b = top(t[(k + 1) % 3]);
            if (a != b) above[a] = b, --shape.parts;
        }
    }
    for (const auto& [edge, count] : triangles_at) {
        shape.open_edges += count == 1 ? 1 : 0;
        shape.branching_edges += count > 2 ? 1 : 0;
    }
    return shape;
}

}
