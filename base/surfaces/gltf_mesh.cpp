// Assimp brings libraries that no other command needs, and is loaded with the first file of glTF.
#include "base/surfaces/gltf_mesh.hpp"

#include "base/files/whole_file.hpp"
#include "base/programs/loaded_module.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>

namespace poissonlab {

TriangleMesh read_gltf_mesh(const std::filesystem::path& file)
{
    static const auto read = reinterpret_cast<GltfReader>(
        function_of_module("poissonlab_meshes", gltf_reader_function, "files of glTF need assimp"));
    TriangleMesh mesh;
    read(file, mesh);
    return mesh;
}

std::vector<std::filesystem::path> files_beside_mesh(const std::filesystem::path& file)
{
    std::string end = file.extension().string();
    std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (end != ".gltf") return {};
    std::vector<std::filesystem::path> files;
    const auto scene = nlohmann::json::parse(read_whole_file(file), nullptr, false);
    if (!scene.is_object() || !scene.contains("buffers")) return {};
    for (const auto& buffer : scene["buffers"]) {
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
        const std::string name = buffer["uri"];
        if (!name.starts_with("data:")) files.push_back(file.parent_path() / name);
    }
    return files;
}

}
