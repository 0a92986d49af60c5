// Files of meshes: each input as OBJ, OFF, PLY, STL and glTF. What is read has finite vertices, which its triangles
// name.
#include "base/surfaces/triangle_mesh.hpp"
#include "tests/fuzz/fuzz_support.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab::fuzz {
namespace {

void check_mesh(const TriangleMesh& mesh)
{
    const auto is_finite = [](const auto& point) {
        return std::ranges::all_of(point, [](double c) { return std::isfinite(c); });
    };
    require(std::ranges::all_of(mesh.vertices, is_finite), "a vertex that is not finite");
    require(std::ranges::all_of(mesh.texture_points, is_finite), "a texture point that is not finite");
    require(mesh.texture_triangles.empty() || mesh.texture_triangles.size() == mesh.triangles.size(),
            "triangles without their texture");
    for (const MeshTriangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) require(corner < mesh.vertices.size(), "no such vertex");
    for (const MeshTriangle& triangle : mesh.texture_triangles)
        for (const std::uint32_t corner : triangle)
            require(corner == no_texture_point || corner < mesh.texture_points.size(), "no such texture point");
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    for (const char* name : {"mesh.obj", "mesh.off", "mesh.ply", "mesh.stl", "mesh.gltf"}) {
        const auto file = fuzz::write_input(name, bytes);
        fuzz::accepts(file.native(), [&] { fuzz::check_mesh(read_triangle_mesh(file, MeshParts::faces_and_texture)); });
    }
    return 0;
}
