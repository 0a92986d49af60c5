// Meshes of glTF, by assimp, which is in a module of its own: see gltf_mesh.cpp.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <filesystem>
#include <string_view>

namespace poissonlab {

/// Is that the end of the name, in lower case, of a file of glTF?
inline bool is_gltf_end(std::string_view end) { return end == ".gltf" || end == ".glb"; }

/// Reads the triangles of all nodes of a file with their texture coordinates; see read_triangle_mesh(). Throws
/// InputError, a line that names the file; StorageError where the module cannot be loaded.
TriangleMesh read_gltf_mesh(const std::filesystem::path& file);

/// The function of the module that does so.
using GltfReader = void (*)(const std::filesystem::path& file, TriangleMesh& mesh);
inline constexpr const char* gltf_reader_function = "poissonlab_read_gltf";

}
