// Files of glTF 2.0 that tests write: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
#pragma once

#include "base/files/whole_file.hpp"
#include "base/surfaces/triangle_mesh.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <string>

namespace poissonlab::test {

template <class Value>
void append_bytes(std::string& to, Value value)
{
    to.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// The numbers of a mesh, whose corners have the texture points of their vertices: places, texture, corners. v of glTF
/// counts from above.
inline std::string gltf_numbers(const TriangleMesh& mesh)
{
    std::string bytes;
    for (const MeshPoint& vertex : mesh.vertices)
        for (const double c : vertex) append_bytes(bytes, static_cast<float>(c));
    for (const TexturePoint& point : mesh.texture_points) {
        append_bytes(bytes, static_cast<float>(point[0]));
        append_bytes(bytes, static_cast<float>(1 - point[1]));
    }
    for (const MeshTriangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) append_bytes(bytes, corner);
    return bytes;
}

/// The description of a scene with these nodes, a list in JSON whose meshes are all number 0; `buffer` is where its
/// numbers are:
/// "" or "\"uri\": \"a.bin\", ".
inline std::string gltf_json(const TriangleMesh& mesh, const std::string& nodes, const std::string& roots,
                             const std::string& buffer)
{
    const std::size_t vertices = mesh.vertices.size(), corners = 3 * mesh.triangles.size();
    const bool has_texture = !mesh.texture_points.empty();
    const std::size_t texture_bytes = has_texture ? 8 * vertices : 0, begin_of_corners = 12 * vertices + texture_bytes;
    std::string accessors = fmt::format(
        R"({{"bufferView": 0, "componentType": 5126, "count": {}, "type": "VEC3", "min": [-9, -9, -9], "max": [9, 9, 9]}},
           {{"bufferView": 1, "componentType": 5125, "count": {}, "type": "SCALAR"}})",
        vertices, corners);
    std::string views = fmt::format(
        R"({{"buffer": 0, "byteOffset": 0, "byteLength": {}}}, {{"buffer": 0, "byteOffset": {}, "byteLength": {}}})",
        12 * vertices, begin_of_corners, 4 * corners);
    if (has_texture) {
        accessors +=
            fmt::format(R"(, {{"bufferView": 2, "componentType": 5126, "count": {}, "type": "VEC2"}})", vertices);
        views += fmt::format(R"(, {{"buffer": 0, "byteOffset": {}, "byteLength": {}}})", 12 * vertices, texture_bytes);
    }
    return fmt::format(R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": {}}}], "nodes": {},
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0{}}}, "indices": 1}}]}}],
"accessors": [{}], "bufferViews": [{}], "buffers": [{{{}"byteLength": {}}}]}})",
                       roots, nodes, has_texture ? ", \"TEXCOORD_0\": 2" : "", accessors, views, buffer,
                       begin_of_corners + 4 * corners);
}

/// A .gltf file with its numbers in a file beside it.
inline void write_gltf(const std::filesystem::path& file, const TriangleMesh& mesh,
                       const std::string& nodes = R"([{"mesh": 0}])", const std::string& roots = "[0]")
{
    std::filesystem::path numbers = file;
    numbers.replace_extension(".bin");
    write_whole_file(numbers, gltf_numbers(mesh));
    write_whole_file(file, gltf_json(mesh, nodes, roots, fmt::format(R"("uri": "{}", )", numbers.filename().string())));
}

/// The bytes of a .glb file.
inline std::string glb_bytes(const TriangleMesh& mesh)
{
    std::string json = gltf_json(mesh, R"([{"mesh": 0}])", "[0]", ""), numbers = gltf_numbers(mesh);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string bytes = "glTF";
    append_bytes(bytes, std::uint32_t{2});
    append_bytes(bytes, static_cast<std::uint32_t>(28 + json.size() + numbers.size()));
    append_bytes(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    append_bytes(bytes, static_cast<std::uint32_t>(numbers.size()));
    bytes.append("BIN\0", 4);
    return bytes + numbers;
}

}
