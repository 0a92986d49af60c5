// Normals, colours and other numbers of vertices are read from files of each format; wrong files are refused.
#include "base/files/whole_file.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/gltf_files.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class FilesWithColumns : public testing::Test
{
protected:
    TriangleMesh read(const std::string& name, const std::string& text, MeshParts parts = MeshParts::all)
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

TEST_F(FilesWithColumns, OfObjHaveColorsAfterPlacesAndNormalsAtCorners)
{
    const std::string text = "v 0 0 0\nv 1 0 0 0.5 0.25 1\nv 1 1 0 1 0 0\nv 0 1 0 2\nvn 0 0 2\nvn 1 0 0\n"
                             "f 1//1 2//-1 3\nf 1 3 4\n";
    const TriangleMesh mesh = read("a.obj", text);
    EXPECT_THAT(mesh.columns.names, ElementsAre("red", "green", "blue"));
    ASSERT_EQ(mesh.columns.values.size(), 12U);
    EXPECT_TRUE(std::isnan(mesh.columns.at(0, 0)));
    EXPECT_EQ(mesh.columns.at(1, 0), 0.5);
    EXPECT_EQ(mesh.columns.at(1, 1), 0.25);
    EXPECT_EQ(mesh.columns.at(2, 0), 1);
    EXPECT_TRUE(std::isnan(mesh.columns.at(3, 2)));
    EXPECT_EQ(mesh.normals, (std::vector<MeshPoint>{{0, 0, 2}, {1, 0, 0}}));
    EXPECT_EQ(
        mesh.normal_triangles,
        (std::vector<MeshTriangle>{{0, 1, no_texture_point}, {no_texture_point, no_texture_point, no_texture_point}}));
    EXPECT_THAT(mesh.faces, ElementsAre(0U, 1U));
    EXPECT_TRUE(read("a.obj", text, MeshParts::faces_and_texture).normals.empty());
    EXPECT_THAT(refusal("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0\nf 1 2 3\n"), HasSubstr("b.obj:4: a normal has"));
    EXPECT_THAT(refusal("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2 3\n"),
                HasSubstr("c.obj:4: \"1//1\": there is no such normal among the 0 before this line"));
}

TEST_F(FilesWithColumns, OfPlyHaveAllNumbersOfTheirVertices)
{
    const TriangleMesh mesh =
        read("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty uchar red\nproperty float x\n"
                      "property float y\nproperty float nx\nproperty float z\nproperty float ny\nproperty float nz\n"
                      "property double quality\nproperty float s\nproperty float t\nelement face 1\n"
                      "property list uchar int vertex_indices\nend_header\n"
                      "255 0 0 1 0 0 0 nan 0.5 0\n7 1 0 0 0 1 0 -3 1 0\n0 0 1 0 0 0 1 1e300 0 1\n3 0 1 2\n");
    EXPECT_THAT(mesh.columns.names, ElementsAre("red", "quality"));
    EXPECT_THAT(mesh.columns.are_bytes, ElementsAre(true, false));
    EXPECT_EQ(mesh.columns.at(0, 0), 255);
    EXPECT_TRUE(std::isnan(mesh.columns.at(0, 1)));
    EXPECT_EQ(mesh.columns.at(1, 1), -3);
    EXPECT_EQ(mesh.columns.at(2, 1), 1e300);
    EXPECT_EQ(mesh.normals, (std::vector<MeshPoint>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_EQ(mesh.normal_triangles, mesh.triangles);
    EXPECT_EQ(mesh.texture_points, (std::vector<TexturePoint>{{0.5, 0}, {1, 0}, {0, 1}}));
}

TEST_F(FilesWithColumns, OfPlyHaveWholeNumbersInColumnsOfBytes)
{
    const auto file = [](const std::string& red) {
        return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
               "0 0 0 255\n1 0 0 " +
               red + "\n0 1 0 0\n3 0 1 2\n";
    };
    EXPECT_THAT(read("a.ply", file("255.0")).columns.values, ElementsAre(255, 255, 0));
    for (const std::string red : {"300", "-5", "nan", "0.5", "256"}) {
        EXPECT_THAT(refusal("a.ply", file(red)),
                    EndsWith("a.ply:12: row 2 of the element `vertex`: " + red +
                             ": a number of the property `red` must be a whole number from 0 to 255, since its type is "
                             "uchar"));
        EXPECT_EQ(read("a.ply", file(red), MeshParts::faces_and_texture).vertices.size(), 3U);
    }
}

TEST_F(FilesWithColumns, OfOffHaveWhatTheirKeywordSays)
{
    const TriangleMesh mesh = read("a.off", "STCNOFF\n3 1 0\n0 0 0  0 0 1  255 0 9  0.5 1\n1 0 0  0 1 0  1 2 3  0 0\n"
                                            "0 1 0  1 0 0  4 5 6  1 1\n3 0 1 2\n");
    EXPECT_THAT(mesh.columns.names, ElementsAre("red", "green", "blue"));
    EXPECT_THAT(mesh.columns.values, ElementsAre(255, 0, 9, 1, 2, 3, 4, 5, 6));
    EXPECT_EQ(mesh.normals, (std::vector<MeshPoint>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_THAT(refusal("b.off", "COFF\n3 1 0\n0 0 0 1 2 3 4\n1 0 0 1 2 3\n0 1 0 1 2 3 4\n3 0 1 2\n"),
                HasSubstr("b.off:4: vertex 1 has 3 numbers after its coordinates, and must have 4"));
    EXPECT_THAT(refusal("c.off", "NOFF\n3 1 0\n0 0 0 1 2\n1 0 0 1 2 3\n0 1 0 1 2 3 4\n3 0 1 2\n"),
                HasSubstr("c.off:3: vertex 0 has 2 numbers after its coordinates, and must have 3"));
    // Further words than the keyword announces are ignored, as in files without columns.
    EXPECT_TRUE(read("d.off", "OFF\n3 1 0\n0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2\n").columns.names.empty());
    std::string binary = "COFF BINARY\n";
    const auto put = [&binary](auto value) {
        const auto word = std::bit_cast<std::uint32_t>(value);
        for (int shift = 24; shift >= 0; shift -= 8) binary += static_cast<char>(word >> shift & 255);
    };
    for (const std::int32_t count : {3, 1, 0}) put(count);
    for (const double number : {0., 0., 0., 1., .5, 0., 1., 1., 0., 0., 0., 0., 1., 1., 0., 1., 0., 0., .25, .5, 1.})
        put(static_cast<float>(number));
    for (const std::int32_t number : {3, 0, 1, 2, 0}) put(number);
    const TriangleMesh of_binary = read("e.off", binary);
    EXPECT_TRUE(read("e.off", binary, MeshParts::faces_and_texture).columns.names.empty());
    EXPECT_THAT(of_binary.columns.names, ElementsAre("red", "green", "blue", "alpha"));
    EXPECT_THAT(of_binary.columns.values, ElementsAre(1, .5, 0, 1, 0, 0, 1, 1, 0, .25, .5, 1));
}

/// The first of two parts has no colours. A node mirrors and stretches them: normals stay normals on the same side.
TEST_F(FilesWithColumns, OfGltfAreMovedWithTheirNodes)
{
    std::string bytes;
    for (const double c : {0., 0., 0., 1., 0., 0., 0., 1., 1.}) test::append_bytes(bytes, static_cast<float>(c));
    for (const float c : {0.F, -0.6F, 0.8F, 0.F, 1.F, 0.F, 0.F, 0.F, 0.F}) test::append_bytes(bytes, c);
    for (const int c : {255, 0, 51, 0, 255, 102, 0, 0, 0, 0, 0, 0}) bytes += static_cast<char>(c);
    write_whole_file(folder_.path() / "a.bin", bytes);
    // A movement whose determinant is below the least double mirrors as well.
    for (const std::string scale : {"[-1, 2, 1]", "[-1e-120, 2e-120, 1e-120]"}) {
        const TriangleMesh mesh =
            read("a.gltf", R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0, "scale": )" + scale +
                               R"(}], "meshes": [{"primitives": [
            {"attributes": {"POSITION": 0}}, {"attributes": {"POSITION": 0, "NORMAL": 1, "COLOR_0": 2}}]}],
           "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC3"}],
           "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36},
            {"buffer": 0, "byteOffset": 72, "byteLength": 12, "byteStride": 4}],
           "buffers": [{"uri": "a.bin", "byteLength": 84}]})");
        ASSERT_EQ(mesh.normals.size(), 3U);
        // The triangle's slope is 1 of 2 then. All normals have length 1 again, but for that of length 0.
        const double length = std::hypot(0.3, 0.8);
        const std::vector<MeshPoint> expected{{0, -0.3 / length, 0.8 / length}, {0, 1, 0}, {0, 0, 0}};
        for (std::size_t n = 0; n < 3; ++n)
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(mesh.normals[n][k], expected[n][k], 1e-7);
        EXPECT_EQ(mesh.normal_triangles[0][0], no_texture_point);
        EXPECT_THAT(mesh.columns.names, ElementsAre("red", "green", "blue", "alpha"));
        EXPECT_TRUE(std::isnan(mesh.columns.at(2, 0)));
        EXPECT_EQ(mesh.columns.at(3, 0), 1);
        EXPECT_NEAR(mesh.columns.at(3, 2), 0.2, 1e-15);
        EXPECT_NEAR(mesh.columns.at(4, 1), 0.4, 1e-15);
        EXPECT_EQ(mesh.columns.at(4, 3), 1);
    }
}

/// Each face of the file counts once, also if it becomes several triangles or is left out.
TEST_F(FilesWithColumns, NumberFacesAsTheFileDoes)
{
    const TriangleMesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2\nf 1 2 3 4\nf 1 1 2\nf 1 2 3\n");
    EXPECT_THAT(mesh.faces, ElementsAre(1U, 1U, 3U));
}

}
}
