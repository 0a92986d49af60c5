#include "base/files/whole_file.hpp"
#include "base/surfaces/gltf_file.hpp"
#include "base/surfaces/mesh_format.hpp"

namespace poissonlab {

std::vector<std::filesystem::path> files_beside_mesh(const std::filesystem::path& file)
{
    if (mesh_end(file) != ".gltf") return {};
    std::vector<std::filesystem::path> files;
    const auto scene = nlohmann::json::parse(read_whole_file(file), nullptr, false);
    if (!scene.is_object() || !scene.contains("buffers")) return {};
    for (const auto& buffer : scene["buffers"]) {
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
        const std::string name = buffer["uri"];
        if (!name.starts_with("data:")) files.push_back(file_of_uri(file, name));
    }
    return files;
}

}
