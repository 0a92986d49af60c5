#include "base/surfaces/mesh_format.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace poissonlab {

const MeshFormat* mesh_format(const std::filesystem::path& file)
{
    constexpr std::string_view gltf_faces = "no node of its scene has a mesh of triangles";
    static constexpr std::array<MeshFormat, 6> formats{{{".off", read_off, "by its head"},
                                                        {".obj", read_obj, "no line begins with f"},
                                                        {".ply", read_ply, "the element `face` has no rows"},
                                                        {".stl", read_stl, "there are no facets"},
                                                        {".gltf", read_gltf, gltf_faces},
                                                        {".glb", read_gltf, gltf_faces}}};
    const auto* const found = std::ranges::find(formats, mesh_end(file), &MeshFormat::end);
    return found == formats.end() ? nullptr : found;
}

std::string mesh_end(const std::filesystem::path& file)
{
    std::string end = file.extension().string();
    std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return end;
}

}
