// Texture coordinates of OBJ, PLY and OFF files: whose corners they are, and what is refused.
#include "base/files/whole_file.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/number_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class TexturedFiles : public testing::Test
{
protected:
    TriangleMesh read(const std::string& name, const std::string& text, MeshParts parts = MeshParts::faces_and_texture)
    {
        write_whole_file(folder_.path() / name, text);
        return read_triangle_mesh(folder_.path() / name, parts);
    }

    std::string refusal(const std::string& name, const std::string& text)
    {
        return message_of([&] { read(name, text); });
    }

    TemporaryFolder folder_;
};

const std::string square_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(TexturedFiles, OfObjHaveOneCoordinateACorner)
{
    const TriangleMesh mesh =
        read("a.obj", square_vertices +
                          "vt 0 0\nvt 0.5 0 7\nf 1/1/9 2/2/9 3/-1/9 # words\nvt 0.25 1\nf 1/1 3/-1 4/2\nf 1 3 4\n");
    EXPECT_EQ(mesh.texture_points, (std::vector<TexturePoint>{{0, 0}, {0.5, 0}, {0.25, 1}}));
    EXPECT_EQ(
        mesh.texture_triangles,
        (std::vector<MeshTriangle>{{0, 1, 1}, {0, 2, 1}, {no_texture_point, no_texture_point, no_texture_point}}));
    EXPECT_TRUE(read("a.obj", square_vertices + "f 1 2 3\n").texture_triangles.empty());
}

/// A quadrangle, one of whose corners is there twice: its triangles have the coordinates of their own corners.
TEST_F(TexturedFiles, OfObjFollowPolygonsIntoTriangles)
{
    const TriangleMesh mesh =
        read("a.obj", square_vertices + "vt 0 0\nvt 9 9\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 1/2 2/3 3/4 4/5\n");
    ASSERT_EQ(mesh.texture_triangles.size(), 2U);
    for (std::size_t t = 0; t < 2; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const MeshPoint& place = mesh.vertices[mesh.triangles[t][k]];
            EXPECT_EQ(mesh.texture_points[mesh.texture_triangles[t][k]], (TexturePoint{place[0], place[1]}));
        }
}

TEST_F(TexturedFiles, OfPlyHaveOneCoordinateAVertex)
{
    for (const auto& [u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
        const TriangleMesh mesh =
            read("a.ply", std::string("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n") +
                              "property float z\nproperty float " + v + "\nproperty uchar red\nproperty float " + u +
                              "\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
                              "0 0 0 0 9 -5\n1 0 0 0 9 1.5\n1 1 0 1 9 1.5\n0 1 0 1 9 -5\n3 0 1 2\n3 0 2 3\n");
        EXPECT_EQ(mesh.texture_points, (std::vector<TexturePoint>{{-5, 0}, {1.5, 0}, {1.5, 1}, {-5, 1}}));
        EXPECT_EQ(mesh.texture_triangles, mesh.triangles);
    }
}

TEST_F(TexturedFiles, OfPlyMayHaveListsBesideThem)
{
    const TriangleMesh mesh =
        read("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar int near\nproperty float x\n"
                      "property float y\nproperty float z\nproperty float u\nproperty float v\nelement face 1\n"
                      "property list uchar int vertex_indices\nend_header\n"
                      "1 7 0 0 0 5 6\n0 1 0 0 7 8\n2 1 2 0 1 0 9 10\n3 0 1 2\n");
    EXPECT_EQ(mesh.texture_points, (std::vector<TexturePoint>{{5, 6}, {7, 8}, {9, 10}}));
    EXPECT_EQ(mesh.texture_triangles, mesh.triangles);
}

/// Corners at one vertex share a texture point unless a seam parts them; those of vertices are left alone then.
TEST_F(TexturedFiles, OfPlyMayBeListsOfFaces)
{
    const std::string begin = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                              "property float z\nproperty float s\nproperty float t\nelement face 3\n"
                              "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
                              "0 0 0 9 9\n1 0 0 9 9\n1 1 0 9 9\n0 1 0 9 9\n";
    const TriangleMesh mesh =
        read("a.ply", begin + "3 0 1 2 6 0 0 0.5 0 0.5 1\n3 0 2 3 6 0.25 0 0.5 1 0 1\n3 0 1 3 0\n");
    EXPECT_EQ(mesh.texture_points, (std::vector<TexturePoint>{{0, 0}, {0.5, 0}, {0.5, 1}, {0.25, 0}, {0, 1}}));
    EXPECT_EQ(
        mesh.texture_triangles,
        (std::vector<MeshTriangle>{{0, 1, 2}, {3, 2, 4}, {no_texture_point, no_texture_point, no_texture_point}}));
    EXPECT_THAT(refusal("a.ply", begin + "3 0 1 2 5 0 0 0.5 0 0.5\n3 0 2 3 0\n3 0 1 3 0\n"),
                HasSubstr("texcoord: has 5 numbers, and must have two for each of 3 corners"));
}

/// They come last in the row of a vertex, after its normal and its colour.
TEST_F(TexturedFiles, OfOffHaveOneCoordinateAVertex)
{
    const std::string text = "STCNOFF\n3 1 0\n0 0 0  0 0 1  9 9 9 1  5 6\n1 0 0  0 0 1  9 9 9 1  7 8\n"
                             "0 1 0  0 0 1  9 9 9 1  -9 0.5\n3 0 2 1\n";
    const auto binary = [](float last) {
        std::string bytes = "STNOFF BINARY\n" + test::number_bytes(std::endian::big, 3, 1, 0);
        bytes += test::number_bytes(std::endian::big, 0.F, 0.F, 0.F, 0.F, 0.F, 1.F, 5.F, 6.F);
        bytes += test::number_bytes(std::endian::big, 1.F, 0.F, 0.F, 0.F, 0.F, 1.F, 7.F, 8.F);
        bytes += test::number_bytes(std::endian::big, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, -9.F, last);
        return bytes + test::number_bytes(std::endian::big, 3, 0, 2, 1, 0);
    };
    for (const std::string& bytes : {text, binary(0.5F)}) {
        for (const MeshParts parts : {MeshParts::faces_and_texture, MeshParts::all}) {
            const TriangleMesh mesh = read("a.off", bytes, parts);
            EXPECT_EQ(mesh.texture_points, (std::vector<TexturePoint>{{5, 6}, {7, 8}, {-9, 0.5}}));
            EXPECT_EQ(mesh.texture_triangles, (std::vector<MeshTriangle>{{0, 2, 1}}));
            EXPECT_EQ(mesh.normals.size(), parts == MeshParts::all ? 3U : 0U);
        }
        EXPECT_TRUE(read("a.off", bytes, MeshParts::faces).texture_points.empty());
        EXPECT_TRUE(read("a.off", bytes, MeshParts::faces).texture_triangles.empty());
    }
    EXPECT_THAT(refusal("a.off", binary(NAN)),
                EndsWith("a.off: vertex 2 has a texture coordinate that is not a finite number"));
    EXPECT_THAT(refusal("a.off", "STOFF\n3 1 0\n0 0 0 0 1\n1 0 0 5\n0 1 0 0 0\n3 0 1 2\n"),
                EndsWith("a.off:4: vertex 1 has 1 numbers after its coordinates, and must have 2"));
}

TEST_F(TexturedFiles, SayWhatIsWrong)
{
    EXPECT_THAT(refusal("a.obj", square_vertices + "vt 0 0\nvt 1 0\nf 1/1 2/2 3/3\n"),
                EndsWith("a.obj:7: \"3/3\": there is no such texture coordinate among the 2 before this line"));
    EXPECT_THAT(refusal("a.obj", square_vertices + "vt 0 0\nf 1/1 2/-2 3/1\n"),
                HasSubstr("a.obj:6: \"2/-2\": there is no such"));
    EXPECT_THAT(refusal("a.obj", square_vertices + "vt 0 nan\nf 1/1 2/1 3/1\n"),
                EndsWith("a.obj:5: \"nan\": a texture coordinate must be a finite number"));
    EXPECT_THAT(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                 "property float z\nproperty float s\nproperty float t\nelement face 1\n"
                                 "property list uchar int vertex_indices\nend_header\n"
                                 "0 0 0 0 0\n1 0 0 1 inf\n1 1 0 1 1\n3 0 1 2\n"),
                EndsWith("a.ply:13: row 2 of the element `vertex`: inf: a texture coordinate must be a finite "
                         "number"));
}

}
}
