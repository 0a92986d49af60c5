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
    EXPECT_THAT(message_of([&] { read_triangle_mesh(folder_.path() / "none.obj"); }),
                EndsWith("must be a file that is there"));
    EXPECT_THAT(message_of([&] { read_triangle_mesh("/dev/zero"); }), HasSubstr("a mesh is a file"));
    for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.gltf", "a.glb"})
        EXPECT_THAT(refusal(name, ""), EndsWith(name + std::string(": is empty")));
}

struct WrongMesh
{
    const char* file;
    std::string text;
    const char* message; ///< its end, after the name of the file
};

/// Each is wrong in one way, and the message says in which and where.
class WrongMeshes : public MeshFiles
{
protected:
    void expect_refused(const std::vector<WrongMesh>& meshes)
    {
        for (const WrongMesh& wrong : meshes)
            EXPECT_THAT(refusal(wrong.file, wrong.text), EndsWith(std::string(wrong.file) + wrong.message))
                << wrong.text;
    }
};

const std::string obj_triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";

TEST_F(WrongMeshes, OfObj)
{
    expect_refused({
        {"a.obj", "words\n", ": has no faces: no line begins with f"},
        {"a.obj", obj_triangle, ": has no faces: no line begins with f"},
        {"a.obj", obj_triangle + "f 1 2 9\n", ":4: \"9\": there is no such vertex: the file has 3"},
        {"a.obj", "f 1 2 9\nf 1 2 8\n" + obj_triangle, ":1: \"9\": there is no such vertex: the file has 3"},
        {"a.obj", obj_triangle + "f 1 2 -9\n", ":4: \"-9\": there is no such vertex among the 3 before this line"},
        {"a.obj", obj_triangle + "f 0 1 2\n", ":4: \"0\": vertices are counted from 1"},
        {"a.obj", obj_triangle + "f 1 2 c\n",
         ":4: \"c\": a corner of a face is a whole number, or several with slashes between them, as in 3, 3/1 and "
         "3/1/2"},
        {"a.obj", obj_triangle + "f 1,2,3\n",
         ":4: \"1,2,3\": a corner of a face is a whole number, or several with slashes between them, as in 3, 3/1 and "
         "3/1/2"},
        {"a.obj", "v 0 0 0\nv 1 nan 0\n", ":2: \"nan\": a coordinate must be a finite number"},
        {"a.obj", "v 0 0 0\nv 1 1e999 0\n", ":2: \"1e999\": a coordinate must be a finite number"},
        {"a.obj", "v 0 0 0\nv 0,5 0 0\n",
         ":2: \"0,5\": a coordinate must be a finite number; the comma of \"0,5\" is no decimal point: must be 0.5"},
        {"a.obj", "v 0 0\n", ":1: a vertex has three coordinates, this one 2"},
        {"a.obj", "v 0 \\\n0\n", ":2: a vertex has three coordinates, this one 2"},
        {"a.obj", obj_triangle + "surf 0 1 0 1 1 2 3\n",
         ":4: surf: only vertices and faces of OBJ are read, no free forms and no other files: store the surface as "
         "polygons"},
        {"a.obj", "\xff\xfev\0", ": is in UTF-16, which some programs call \"Unicode\": save it as UTF-8"},
    });
}

TEST_F(WrongMeshes, OfOff)
{
    const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n";
    expect_refused({
        {"a.off", "OBJ\n", ":1: \"OBJ\": a file of OFF begins with the word OFF"},
        {"a.off", "OFFx 3 1 0\n", ":1: \"OFFx\": a file of OFF begins with the word OFF"},
        {"a.off", "OFF\n3 0 0\n" + vertices, ": has no faces: by its head"},
        {"a.off", "OFF\n3 one 0\n", ":2: \"one\": the number of faces must be a whole number"},
        {"a.off", "OFF\n-3 1 0\n", ":2: -3: the number of vertices must be from 0 to 1073741823"},
        {"a.off", "4nOFF\n4\n", ":2: 4: vertices of nOFF must have three coordinates"},
        {"a.off", "OFF\n4 1 0\n" + vertices, ":5: the file ends after 3 of 4 vertices, which its head announces"},
        {"a.off", "OFF\n3 2 0\n" + vertices + "3 0 1 2\n",
         ":6: the file ends after 1 of 2 faces, which its head announces"},
        {"a.off", "OFF\n3 1 0\n" + vertices + "3 0 1 2\n3 0 2 1\n",
         ":7: \"3\": stands after the last of 3 vertices and 1 face, which the head announces"},
        {"a.off", "OFF\n3 1 0\n" + vertices + "3 0 1 7\n", ":6: \"7\": there is no such vertex: they are 0 to 2"},
        {"a.off", "OFF\n3 1 0\n" + vertices + "3 0 1\n", ":6: the file ends before corner 3 of 3 of a face"},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 inf 0\n", ":4: \"inf\": a coordinate must be a finite number"},
        {"a.off", "4OFF\n3 1 0\n1 0 0 0\n", ":3: the first three coordinates over the fourth are no finite numbers"},
        {"a.off", "OFF\n999999999 999999999 0\n0 0 0\n",
         ":3: the file ends after 1 of 999999999 vertices, which its head announces"},
    });
}

TEST_F(WrongMeshes, OfPly)
{
    const std::string begin = "ply\nformat ascii 1.0\n", end = "end_header\n",
                      vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n",
                      face = "element face 1\nproperty list uchar int vertex_indices\n", rows = "0 0 0\n1 0 0\n1 1 0\n",
                      head = begin + vertex + face + end;
    expect_refused({
        {"a.ply", "plymouth\n", ": is no PLY: its first line must be the word ply"},
        {"a.ply", begin + vertex, ": PLY header: must end with a line `end_header`"},
        {"a.ply", begin + face + end, ": has no element `vertex`"},
        {"a.ply", begin + vertex + end + rows, ": has no faces: it has neither an element `face` nor `tristrips`"},
        {"a.ply", begin + vertex + "element face 0\nproperty list uchar int vertex_indices\n" + end + rows,
         ": has no faces: the element `face` has no rows"},
        {"a.ply", begin + "element vertex 1\nproperty float x\nproperty float y\n" + face + end,
         ": the element `vertex` must have the properties x, y and z"},
        {"a.ply", begin + vertex + "element face 1\nproperty list uchar int edges\n" + end,
         ": the element `face` must have a list `vertex_indices` or `vertex_index`"},
        {"a.ply", begin + vertex + "element face 1\nproperty list uchar long vertex_indices\n" + end,
         ":8: long: must be a type of PLY, such as float or double"},
        {"a.ply", head + rows + "3 0 1 7\n",
         ": row 1 of the element `face` has vertex 7, which is not there: they are 0 to 2"},
        {"a.ply", head + rows + "3 0 1 -2\n", ":13: row 1 of the element `face`: -2: there is no such vertex"},
        {"a.ply", head + rows + "3 0 1 1.5\n", ":13: row 1 of the element `face`: 1.5: there is no such vertex"},
        {"a.ply", head + rows + "-3 0 1 2\n",
         ":13: row 1 of the element `face`: -3: a list must have a whole number of entries"},
        {"a.ply", head + rows + "3 0 1\n",
         ":13: row 1 of the element `face`: has fewer numbers than the header announces"},
        {"a.ply", head + rows + "3 0 1 2 9\n",
         ":13: row 1 of the element `face`: \"9\": is more than the properties that the header announces"},
        {"a.ply", head + rows + "3 0 1 2\n3 0 2 1\n",
         ":14: \"3\": stands after the last row that the header announces"},
        {"a.ply", head + "0 0 0\n1 0,5 0\n1 1 0\n3 0 1 2\n",
         ":11: row 2 of the element `vertex`: \"0,5\": must be a number; the comma of \"0,5\" is no decimal point: "
         "must "
         "be 0.5"},
        {"a.ply", head + "0 0 0\n1 nan 0\n1 1 0\n3 0 1 2\n",
         ":11: row 2 of the element `vertex`: nan: a coordinate must be a finite number"},
        {"a.ply", head + rows + "\n",
         ":13: row 1 of the element `face`: the file ends before it: the header announces 1 row"},
        {"a.ply",
         begin + "element vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\n" + face + end +
             rows,
         ": the file ends before the 2000000000 rows of the element `vertex`, which its header announces"},
    });
}

TEST_F(WrongMeshes, OfStl)
{
    const std::string corner = "vertex 0 0 0\n", begin = "solid\nfacet normal 0 0 1\nouter loop\n" + corner,
                      end = "endloop\nendfacet\nendsolid\n";
    expect_refused({
        {"a.stl", "words",
         ": is no STL: it does not begin with `solid`, and has 5 bytes, of which a binary file has 84 at least"},
        {"a.stl", "solid a\nendsolid a\n", ": has no faces: there are no facets"},
        {"a.stl", begin + corner + corner + "endloop\nendfacet\n",
         ":8: the file ends before `endsolid`: a part of it is missing"},
        {"a.stl", begin + "vertex 1 0\n" + corner + end, ":6: \"vertex\": a coordinate must be a finite number"},
        {"a.stl", begin + "vertx 1 0 0\n" + corner + end, ":5: \"vertx\": must be `vertex` or `endloop`"},
        {"a.stl", "solid a\nouter loop\n", ":2: \"outer\": must be `facet` or `endsolid`"},
        {"a.stl", "solid a\nfacet normals 0 0 1\n", ":2: \"normals\": must be `normal`"},
        {"a.stl", "solid a\nendsolid a\nmore\n", ":3: \"more\": must be `solid`"},
    });
}

}
}
