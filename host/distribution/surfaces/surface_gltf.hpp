// Binary glTF 2.0 files of points with normals, in nodes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Points that a node of a glTF file has: three floats of each place, and three of each normal.
struct GltfGroup
{
    std::string name; ///< empty: none
    std::vector<float> places, normals;
};

/// Writes a node with a mesh of points for each group, whole or not at all. Groups without points are left out, because
/// glTF has no empty meshes. Throws StorageError.
void write_surface_glb(const std::filesystem::path& file, std::vector<GltfGroup> groups);

}
