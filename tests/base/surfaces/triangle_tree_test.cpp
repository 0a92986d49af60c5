// The nearest triangle is compared with CGAL's distance to every triangle.
#include "base/surfaces/triangle_tree.hpp"

#include "tests/support/meshes.hpp"

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

using TreeKernel = CGAL::Simple_cartesian<double>;

TreeKernel::Point_3 cgal_point(const MeshPoint& p) { return {p[0], p[1], p[2]}; }

double least_squared_by_cgal(const TriangleMesh& mesh, const MeshPoint& place)
{
    double least = INFINITY;
    for (const MeshTriangle& t : mesh.triangles)
        least = std::min(
            least, CGAL::squared_distance(cgal_point(place), TreeKernel::Triangle_3(cgal_point(mesh.vertices[t[0]]),
                                                                                    cgal_point(mesh.vertices[t[1]]),
                                                                                    cgal_point(mesh.vertices[t[2]]))));
    return least;
}

TEST(TriangleTrees, FindTheNearestPlace)
{
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> anywhere(-1.5, 1.5);
    for (const TriangleMesh& mesh : {square_mesh(), square_mesh(7), sphere_mesh(9), sheet_mesh(0.01)}) {
        const TriangleTree tree(mesh);
        for (int i = 0; i < 500; ++i) {
            const MeshPoint place{anywhere(engine), anywhere(engine), anywhere(engine)};
            const MeshPosition on = tree.nearest(place);
            const MeshPoint off = difference(place_of(mesh, on), place);
            EXPECT_NEAR(std::sqrt(dot(off, off)), std::sqrt(least_squared_by_cgal(mesh, place)), 1e-12);
            EXPECT_NEAR(on.shares[0] + on.shares[1] + on.shares[2], 1, 1e-12);
            for (const double share : on.shares) EXPECT_GE(share, 0);
        }
    }
}

TEST(TriangleTrees, PutPlacesOfTheMeshWhereTheyAre)
{
    const TriangleMesh mesh = sphere_mesh(12);
    const TriangleTree tree(mesh);
    for (const MeshPoint& vertex : mesh.vertices) {
        const MeshPoint off = difference(place_of(mesh, tree.nearest(vertex)), vertex);
        EXPECT_LT(std::sqrt(dot(off, off)), 1e-15);
    }
}

}
}
