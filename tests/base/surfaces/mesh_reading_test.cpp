// Meshes read from files of four formats, polygons as triangles, and what is refused.
#include "base/files/whole_file.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class MeshFiles : public testing::Test
{
protected:
    TriangleMesh read(const std::string& name, const std::string& text)
    {
        write_whole_file(folder_.path() / name, text);
        return read_triangle_mesh(folder_.path() / name);
    }

    std::string refusal(const std::string& name, const std::string& text)
    {
        return message_of([&] { read(name, text); });
    }

    TemporaryFolder folder_;
};

/// Twice the area of a triangle, whose corners lie in a plane z = constant, with the sign of its direction.
double twice_area(const TriangleMesh& mesh, const MeshTriangle& t)
{
    const MeshPoint &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

TEST_F(MeshFiles, AreTheSameInFourFormats)
{
    const std::vector<MeshTriangle> expected{{0, 1, 2}, {0, 2, 3}};
    const TriangleMesh obj = read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1/1/1 3/2/1 4\n");
    EXPECT_EQ(obj.triangles, expected);
    EXPECT_EQ(obj.vertices, (std::vector<MeshPoint>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2\nf -4 -2 -1\n").triangles, expected);
    EXPECT_EQ(read("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n").triangles, expected);
    EXPECT_EQ(read("a.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                            "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n")
                  .triangles,
              expected);
    const TriangleMesh stl = read("a.STL", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                           "vertex 1 1 0\nendloop\nendfacet\nendsolid s\n");
    EXPECT_EQ(stl.triangles.size(), 1U);
}

TEST_F(MeshFiles, HavePolygonsAsTriangles)
{
    // A square, and an arrow head with a corner that points inwards: its area is 1, a fan from the first corner has
    // more.
    const TriangleMesh mesh =
        read("a.off", "OFF\n8 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 0\n5 1 0\n3 2 0\n4 1 0\n4 0 1 2 3\n4 4 5 6 7\n");
    EXPECT_EQ(mesh.divided, 2U);
    ASSERT_EQ(mesh.triangles.size(), 4U);
    double area = 0;
    for (const MeshTriangle& t : mesh.triangles) {
        EXPECT_GT(twice_area(mesh, t), 0);
        area += twice_area(mesh, t) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 2);
}

TEST_F(MeshFiles, SayWhatIsWrong)
{
    EXPECT_THAT(refusal("a.txt", "x"), HasSubstr("a mesh is a file of OFF, OBJ, PLY, STL or glTF"));
    EXPECT_THAT(refusal("a.obj", ""), EndsWith("a.obj: cannot be read as a mesh: it is damaged, or has no faces"));
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1 0 0\n"), HasSubstr("has no faces"));
    EXPECT_THAT(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 7\n"), HasSubstr("a.off: "));
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n"),
                EndsWith("face 1 has a vertex that is not there: there are 3 vertices"));
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 -9\n"), HasSubstr("a.obj: "));
    EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1 nan 0\nv 1 1 0\nf 1 2 3\n"), HasSubstr("a.obj: "));
    EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\n"
                                 "property float y\nproperty float z\nend_header\n0 0 0\n"),
                HasSubstr("a.ply: "));
    EXPECT_THAT(refusal("a.stl", "words"), HasSubstr("a.stl: "));
    EXPECT_THAT(message_of([&] { read_triangle_mesh(folder_.path() / "none.obj"); }),
                EndsWith("must be a file that is there"));
    EXPECT_THAT(message_of([&] { read_triangle_mesh("/dev/zero"); }), HasSubstr("a mesh is a file"));
}

}
}
