// Binary files of meshes, written byte by byte: PLY and OFF of either byte order, STL, and glTF in .glb.
#include "base/files/whole_file.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/gltf_files.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/number_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace poissonlab {
namespace {

using std::endian;
using test::number_bytes;
using testing::EndsWith;
using testing::HasSubstr;

const std::vector<MeshPoint> square_corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<MeshTriangle> square_halves{{0, 1, 2}, {0, 2, 3}};

class BinaryMeshes : public testing::Test
{
protected:
    TriangleMesh read(const std::string& name, const std::string& bytes, MeshParts parts = MeshParts::faces)
    {
        write_whole_file(folder_.path() / name, bytes);
        return read_triangle_mesh(folder_.path() / name, parts);
    }

    std::string refusal(const std::string& name, const std::string& bytes)
    {
        return message_of([&] { read(name, bytes); });
    }

    void expect_square(const std::string& name, const std::string& bytes)
    {
        const TriangleMesh mesh = read(name, bytes);
        EXPECT_EQ(mesh.vertices, square_corners);
        EXPECT_EQ(mesh.triangles, square_halves);
    }

    TemporaryFolder folder_;
};

/// Vertices with a colour and a list, faces with a number before and a list after, and an element that is no mesh.
std::string binary_ply(endian order, const std::string& line_end = "\n")
{
    std::string bytes = "ply\nformat binary_" + std::string(order == endian::big ? "big" : "little") +
                        "_endian 1.0\ncomment by hand\nelement vertex 4\nproperty double x\nproperty float y\n"
                        "property uchar red\nproperty list uchar short near\nproperty short z\nelement other 1\n"
                        "property int number\nelement face 2\nproperty ushort group\n"
                        "property list uint uchar vertex_indices\nproperty list uchar float texcoord\nend_header\n";
    for (std::size_t at = 0; (at = bytes.find('\n', at)) != bytes.npos; at += line_end.size())
        bytes.replace(at, 1, line_end);
    for (const MeshPoint& p : square_corners)
        bytes += number_bytes(order, p[0], static_cast<float>(p[1]), std::uint8_t{200}, std::uint8_t{2},
                              std::int16_t{-7}, std::int16_t{9}, static_cast<std::int16_t>(p[2]));
    bytes += number_bytes(order, std::int32_t{1});
    for (const MeshTriangle& t : square_halves) {
        bytes += number_bytes(order, std::uint16_t{5}, std::uint32_t{3});
        for (const std::uint32_t corner : t) bytes += number_bytes(order, static_cast<std::uint8_t>(corner));
        bytes += number_bytes(order, std::uint8_t{1}, 0.5F);
    }
    return bytes;
}

TEST_F(BinaryMeshes, OfPlyHaveEitherByteOrder)
{
    for (const endian order : {endian::little, endian::big})
        for (const char* line_end : {"\n", "\r\n", "\r"}) expect_square("a.ply", binary_ply(order, line_end));
}

TEST_F(BinaryMeshes, OfPlyAreHeldAgainstTheirHeader)
{
    const std::string whole = binary_ply(endian::little);
    EXPECT_THAT(refusal("a.ply", whole + "12"), EndsWith("a.ply: has 2 bytes after the last row that its header "
                                                         "announces"));
    EXPECT_THAT(refusal("a.ply", whole.substr(0, whole.size() - 3)),
                EndsWith("a.ply: row 2 of the element `face`: the file ends before the 1 entry of a list"));
    EXPECT_THAT(refusal("a.ply", whole.substr(0, whole.find("end_header\n") + 20)),
                EndsWith("a.ply: the file ends before the 4 rows of the element `vertex`, which its header announces"));
    std::string wrong = whole;
    wrong[wrong.size() - 6] = 4; // the last corner
    EXPECT_THAT(refusal("a.ply", wrong),
                EndsWith("a.ply: row 2 of the element `face` has vertex 4, which is not there: they are 0 to 3"));
}

/// "solid" in the head makes no text of it.
std::string binary_stl(const std::string& head, std::uint32_t announced = 2, float first = 0)
{
    std::string bytes = head;
    bytes.resize(80, ' ');
    bytes += number_bytes(endian::little, announced);
    for (const MeshTriangle& t : square_halves) {
        bytes += number_bytes(endian::little, 0.F, 0.F, 1.F);
        for (const std::uint32_t corner : t)
            for (const double c : square_corners[corner])
                bytes += number_bytes(endian::little, corner == 0 ? first : static_cast<float>(c));
        bytes += number_bytes(endian::little, std::uint16_t{0});
    }
    return bytes;
}

TEST_F(BinaryMeshes, OfStlMayBeginWithSolid)
{
    expect_square("a.stl", binary_stl("by hand"));
    expect_square("a.stl", binary_stl("solid by hand"));
    EXPECT_THAT(refusal("a.stl", binary_stl("solid by hand", 3)),
                EndsWith("a.stl: is no STL: it is no text that begins with `solid`, and a binary file of 3 triangles, "
                         "as its head has it, has 234 bytes, this one 184"));
    EXPECT_THAT(refusal("a.stl", binary_stl("", 2, std::numeric_limits<float>::infinity())),
                EndsWith("a.stl: triangle 1 has a coordinate that is not a finite number"));
}

TEST_F(BinaryMeshes, OfOffAreBigEndian)
{
    std::string head = "CN4OFF BINARY\n" + number_bytes(endian::big, 4, 2, 0), bytes = head;
    for (const MeshPoint& p : square_corners)
        bytes += number_bytes(endian::big, static_cast<float>(2 * p[0]), static_cast<float>(2 * p[1]), 0.F, 2.F, 0.F,
                              0.F, 1.F, 1.F, 1.F, 0.F, 1.F);
    const std::string vertices = bytes;
    for (const auto& [a, b, c] : square_halves) bytes += number_bytes(endian::big, 3, a, b, c, 3, 0.5F, 0.5F, 0.5F);
    expect_square("a.off", bytes);
    EXPECT_TRUE(read("a.off", bytes).normals.empty());
    EXPECT_TRUE(read("a.off", bytes).columns.names.empty());
    EXPECT_EQ(read("a.off", bytes, MeshParts::all).normals, (std::vector<MeshPoint>(4, {0, 0, 1})));
    EXPECT_EQ(read("a.off", bytes, MeshParts::all).columns.names.size(), 4U);
    EXPECT_THAT(refusal("a.off", head), EndsWith("a.off: ends within vertex or face 0"));
    EXPECT_THAT(refusal("a.off", vertices), EndsWith("a.off: ends before the number of corners"));
    EXPECT_THAT(refusal("a.off", vertices + number_bytes(endian::big, 3, 0, 1, 4)),
                EndsWith("a.off: face 0 has vertex 4, which is not there: they are 0 to 3"));
    EXPECT_THAT(refusal("a.off", bytes + "1"),
                EndsWith("a.off: has 1 byte after the last of 4 vertices and 2 faces, which its head announces"));
}

TEST_F(BinaryMeshes, OfGltfSayWhereTheyEnd)
{
    const TriangleMesh mesh = square_mesh();
    const std::string whole = test::glb_bytes(mesh);
    const TriangleMesh read_mesh = read("a.glb", whole);
    EXPECT_EQ(read_mesh.vertices, mesh.vertices);
    EXPECT_EQ(read_mesh.triangles, mesh.triangles);
    EXPECT_THAT(refusal("a.glb", whole.substr(0, 10)), EndsWith("a.glb: ends within its head"));
    EXPECT_THAT(refusal("a.glb", whole.substr(0, whole.size() - 4)), HasSubstr(" by its head"));
    std::string first = whole;
    first[4] = 1;
    EXPECT_THAT(refusal("a.glb", first), EndsWith("a.glb: is a file of glTF 1: only version 2 is read"));
}

}
}
