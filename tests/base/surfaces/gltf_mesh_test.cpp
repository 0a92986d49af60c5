// Meshes of glTF beside the same in OBJ, nodes that move them, and damaged files.
#include "base/files/whole_file.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/gltf_files.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

/// A bent sheet whose coordinates are floats.
TriangleMesh bent_sheet()
{
    return textured_mesh(8, 4, [](double u, double v) {
        return MeshPoint{u, v, static_cast<double>(static_cast<float>(std::sin(3 * u + v)))};
    });
}

class GltfFiles : public testing::Test
{
protected:
    TriangleMesh read(const std::string& name)
    {
        return read_triangle_mesh(folder_.path() / name, MeshParts::faces_and_texture);
    }

    std::string refusal(const std::string& name, const std::string& text)
    {
        write_whole_file(folder_.path() / name, text);
        return message_of([&] { read(name); });
    }

    TemporaryFolder folder_;
};

std::string obj_of(const TriangleMesh& mesh)
{
    std::string text;
    for (const auto& [x, y, z] : mesh.vertices) text += fmt::format("v {} {} {}\n", x, y, z);
    for (const auto& [u, v] : mesh.texture_points) text += fmt::format("vt {} {}\n", u, v);
    for (const auto& [a, b, c] : mesh.triangles)
        text += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", a + 1, b + 1, c + 1);
    return text;
}

TEST_F(GltfFiles, AreTheSameAsObj)
{
    const TriangleMesh mesh = bent_sheet();
    write_whole_file(folder_.path() / "a.obj", obj_of(mesh));
    test::write_gltf(folder_.path() / "a.gltf", mesh);
    write_whole_file(folder_.path() / "a.GLB", test::glb_bytes(mesh));
    EXPECT_EQ(files_beside_mesh(folder_.path() / "a.gltf"), std::vector{folder_.path() / "a.bin"});
    const TriangleMesh obj = read("a.obj");
    for (const char* name : {"a.gltf", "a.GLB"}) {
        const TriangleMesh gltf = read(name);
        EXPECT_EQ(gltf.vertices, obj.vertices);
        EXPECT_EQ(gltf.triangles, obj.triangles);
        EXPECT_EQ(gltf.texture_points, obj.texture_points);
        EXPECT_EQ(gltf.texture_triangles, obj.texture_triangles);
    }
}

TEST_F(GltfFiles, AreJoinedWhereNodesPutThem)
{
    TriangleMesh mesh = bent_sheet();
    mesh.texture_points.clear();
    // The second one is moved by its own node after that around it; the third is mirrored, and stays counterclockwise
    // seen from outside.
    test::write_gltf(folder_.path() / "a.gltf", mesh,
                     R"([{"mesh": 0}, {"scale": [2, 2, 2], "children": [2]}, {"mesh": 0, "translation": [1, 0, 5]},
                   {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}])",
                     "[0, 1, 3]");
    const TriangleMesh read_mesh = read("a.gltf");
    const std::size_t vertices = mesh.vertices.size(), triangles = mesh.triangles.size();
    ASSERT_EQ(read_mesh.vertices.size(), 3 * vertices);
    ASSERT_EQ(read_mesh.triangles.size(), 3 * triangles);
    EXPECT_TRUE(read_mesh.texture_triangles.empty());
    for (std::size_t i = 0; i < vertices; ++i) {
        const auto& [x, y, z] = mesh.vertices[i];
        EXPECT_EQ(read_mesh.vertices[i], mesh.vertices[i]);
        EXPECT_EQ(read_mesh.vertices[vertices + i], (MeshPoint{2 * (x + 1), 2 * y, 2 * (z + 5)}));
        EXPECT_EQ(read_mesh.vertices[2 * vertices + i], (MeshPoint{-x, y, z}));
    }
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const auto second = static_cast<std::uint32_t>(vertices), third = 2 * second;
        EXPECT_EQ(read_mesh.triangles[triangles + t], (MeshTriangle{a + second, b + second, c + second}));
        EXPECT_EQ(read_mesh.triangles[2 * triangles + t], (MeshTriangle{c + third, b + third, a + third}));
    }
}

/// A .gltf file of the bent sheet in which a piece of text is another.
class ChangedGltf : public GltfFiles
{
protected:
    std::string refusal_with(const std::string& from, const std::string& to)
    {
        const TriangleMesh mesh = bent_sheet();
        test::write_gltf(folder_.path() / "a.gltf", mesh);
        std::string text = read_whole_file(folder_.path() / "a.gltf");
        const std::size_t at = text.find(from);
        EXPECT_NE(at, text.npos) << from;
        return refusal("a.gltf", text.replace(std::min(at, text.size()), from.size(), to));
    }
};

TEST_F(GltfFiles, SayWhatIsWrong)
{
    EXPECT_THAT(refusal("a.gltf", "words"), HasSubstr("a.gltf:1: is not JSON: "));
    EXPECT_THAT(refusal("a.gltf", R"({"asset": {"version": "2.0"}})"),
                EndsWith("a.gltf: has no faces: no node of its scene has a mesh of triangles"));
    EXPECT_THAT(refusal("a.gltf", R"({"asset": {"version": "1.0"}})"),
                EndsWith("a.gltf: asset.version = \"1.0\": only glTF 2 is read"));
    EXPECT_THAT(refusal("a.gltf", R"({"asset": {"version": "2.1", "minVersion": "2.1"}})"),
                EndsWith("a.gltf: asset.minVersion = \"2.1\": only glTF 2.0 is read"));
    EXPECT_THAT(refusal("a.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                                      "nodes": [{"translation": [1, 2, 3]}]})"),
                EndsWith("a.gltf: has no faces: no node of its scene has a mesh of triangles"));
    EXPECT_THAT(refusal("a.gltf", R"({"asset": {"version": "2.0"}, "nodes": [{"scale": [1, 2]}]})"),
                EndsWith("a.gltf: nodes[0].scale: must have 3 numbers"));
    EXPECT_THAT(refusal("a.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
                                      "nodes": [{"children": [1]}, {"children": [0]}]})"),
                EndsWith("a.gltf: nodes[0] comes twice: a node is below one other, or none"));
    EXPECT_THAT(refusal("a.gltf", test::gltf_json(bent_sheet(), R"([{"mesh": 0}])", "[0]", R"("uri": "none.bin", )")),
                AllOf(HasSubstr("a.gltf: buffers[0].uri = \"none.bin\": "), EndsWith("must be a file that is there")));
    EXPECT_THAT(refusal("a.gltf", test::gltf_json(bent_sheet(), R"([{"mesh": 0}])", "[0]", R"("uri": "data:,a", )")),
                EndsWith("a.gltf: buffers[0].uri = \"data:,a\": must be base64 after `data:...;base64,`"));
    TriangleMesh mesh = bent_sheet();
    mesh.vertices[3][1] = NAN;
    EXPECT_THAT(refusal("a.glb", test::glb_bytes(mesh)),
                EndsWith("a.glb: meshes[0].primitives[0].attributes.POSITION = 0: row 4 has a coordinate that is not a "
                         "finite number"));
    mesh = bent_sheet();
    mesh.triangles[2][1] = 1000;
    EXPECT_THAT(refusal("a.glb", test::glb_bytes(mesh)),
                EndsWith("a.glb: meshes[0].primitives[0].indices = 1: corner 7 has vertex 1000, which is not there: "
                         "they are 0 to 44"));
}

TEST_F(ChangedGltf, SaysWhereItIsWrong)
{
    const std::string after_asset = R"("asset": {"version": "2.0"}, )";
    for (const char* name : {"EXT_meshopt_compression", "KHR_draco_mesh_compression", "ABC_unheard_of"})
        EXPECT_THAT(refusal_with(after_asset, after_asset + "\"extensionsRequired\": [\"" + name + "\"], "),
                    EndsWith(std::string("a.gltf: extensionsRequired: ") + name +
                             " is not known here, and without it the file cannot be read right: store it without this "
                             "extension"));
    EXPECT_THAT(refusal_with("\"scene\": 0", "\"scene\": 1"), EndsWith("a.gltf: scene = 1: is not there: there are 1"));
    EXPECT_THAT(refusal_with("[{\"mesh\": 0}]", "[{\"mesh\": 3}]"),
                EndsWith("a.gltf: nodes[0].mesh = 3: is not there: there are 1"));
    EXPECT_THAT(refusal_with("\"nodes\": [0]", "\"nodes\": [5]"), EndsWith("a.gltf: nodes[5] is named and not there"));
    EXPECT_THAT(refusal_with("\"componentType\": 5126", "\"componentType\": 5130"),
                EndsWith("a.gltf: accessors[0].componentType = 5130: must be 5120 to 5123, 5125 or 5126"));
    EXPECT_THAT(refusal_with("\"type\": \"VEC3\"", "\"type\": \"VEC2\""),
                EndsWith("a.gltf: accessors[0].type = \"VEC2\": must be VEC3"));
    EXPECT_THAT(
        refusal_with("\"count\": 45", "\"count\": 46"),
        EndsWith("a.gltf: accessors[0].bufferView = 0: has 540 bytes, in which 46 rows of 12 bytes from 0 on do "
                 "not fit"));
    EXPECT_THAT(refusal_with("\"count\": 192", "\"count\": 191"),
                EndsWith("a.gltf: meshes[0].primitives[0].indices = 1: are 191 corners: triangles have three each"));
    EXPECT_THAT(refusal_with("\"byteLength\": 540", "\"byteLength\": 5400"),
                EndsWith("a.gltf: bufferViews[0].byteLength = 5400: ends after its buffer, which has 1668 bytes"));
    EXPECT_THAT(refusal_with("\"byteLength\": 1668", "\"byteLength\": 1669"),
                EndsWith("a.gltf: buffers[0].byteLength = 1669: there are 1668 bytes"));
}

TEST_F(GltfFiles, NameFilesBesideThemWithBlanks)
{
    const TriangleMesh mesh = bent_sheet();
    write_whole_file(folder_.path() / "my numbers%.bin", test::gltf_numbers(mesh));
    write_whole_file(folder_.path() / "a.gltf",
                     test::gltf_json(mesh, R"([{"mesh": 0}])", "[0]", R"("uri": "my%20numbers%.bin", )"));
    EXPECT_EQ(read("a.gltf").vertices, mesh.vertices);
    EXPECT_EQ(files_beside_mesh(folder_.path() / "a.gltf"), std::vector{folder_.path() / "my numbers%.bin"});
}

/// Files that end early, or with bits that fell over: an error of one line, or a mesh.
TEST_F(GltfFiles, MayBeDamaged)
{
    const std::string whole = test::glb_bytes(bent_sheet());
    for (std::size_t i = 0; i < 150; ++i) {
        std::string damaged = whole;
        const std::size_t at = i * 7919 % whole.size();
        if (i % 3 == 0)
            damaged.resize(at);
        else
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << i % 8));
        write_whole_file(folder_.path() / "a.glb", damaged);
        try {
            const TriangleMesh mesh = read("a.glb");
            for (const MeshTriangle& triangle : mesh.triangles)
                for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh.vertices.size());
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("a.glb:"));
            EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
        }
    }
}

}
}
