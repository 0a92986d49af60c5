// Triangles are divided so that the surface stays the same and neighbours keep their common edges.
#include "analysis/surfaces/refined_mesh.hpp"

#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace poissonlab {
namespace {

double longest_edge(const TriangleMesh& mesh)
{
    double longest = 0;
    for (const MeshTriangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const MeshPoint edge = difference(mesh.vertices[t[k]], mesh.vertices[t[(k + 1) % 3]]);
            longest = std::max(longest, std::sqrt(dot(edge, edge)));
        }
    return longest;
}

TriangleMesh tetrahedron()
{
    return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(RefinedMeshes, KeepTheirAreaTheirBordersAndTheirWays)
{
    for (const double longest : {2.0, 1.2, 0.5, 0.11, 0.03}) {
        const TriangleMesh mesh = with_edges_up_to(square_mesh(), longest);
        EXPECT_LE(longest_edge(mesh), longest);
        const MeshShape shape = shape_of(mesh);
        EXPECT_NEAR(shape.area, 1, 1e-12);
        EXPECT_EQ(shape.parts, 1U);
        EXPECT_EQ(shape.branching_edges, 0U);
        // Each side is halved until it is short enough. An inner edge that is not shared would count as open.
        std::size_t of_a_side = 1;
        while (1.0 / static_cast<double>(of_a_side) > longest) of_a_side *= 2;
        EXPECT_EQ(shape.open_edges, 4 * of_a_side) << longest;
        for (const MeshTriangle& t : mesh.triangles) {
            const MeshPoint& a = mesh.vertices[t[0]];
            EXPECT_GT(cross(difference(mesh.vertices[t[1]], a), difference(mesh.vertices[t[2]], a))[2], 0);
        }
    }
}

TEST(RefinedMeshes, OfOneLongAndManyShortTrianglesFitTogether)
{
    // A triangle with one, two or three long edges beside each other.
    TriangleMesh mesh{.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 1, 0}, {10, 1, 0}, {0.5, 2, 0}},
                      .triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}};
    const double area = shape_of(mesh).area;
    for (const double longest : {9.0, 3.0, 1.01, 0.4, 0.07}) {
        const TriangleMesh fine = with_edges_up_to(mesh, longest);
        EXPECT_LE(longest_edge(fine), longest);
        EXPECT_NEAR(shape_of(fine).area, area, 1e-11);
        const std::set<MeshPoint> places(fine.vertices.begin(), fine.vertices.end());
        EXPECT_EQ(places.size(), fine.vertices.size()) << "a middle is there twice";
        // Euler: a disk has V - E + F = 1, and 3 F = 2 E - open edges.
        const std::size_t faces = fine.triangles.size(), edges = (3 * faces + shape_of(fine).open_edges) / 2;
        EXPECT_EQ(fine.vertices.size() + faces, edges + 1);
    }
}

TEST(MeshShapes, CountPartsAndEdges)
{
    EXPECT_EQ(shape_of(tetrahedron()).open_edges, 0U);
    EXPECT_EQ(shape_of(with_edges_up_to(tetrahedron(), 0.2)).open_edges, 0U);
    EXPECT_EQ(shape_of(sheet_mesh(0.1)).parts, 2U);
    // Three triangles meet at one edge.
    const TriangleMesh book{.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                            .triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
    EXPECT_EQ(shape_of(book).branching_edges, 1U);
    EXPECT_EQ(shape_of(book).open_edges, 6U);
    EXPECT_EQ(shape_of(book).parts, 1U);
}

}
}
