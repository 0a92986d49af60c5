#include "host/distribution/surfaces/surface_gltf.hpp"

#include "base/files/whole_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace poissonlab {
namespace {

template <typename Value>
void append_bytes(std::string& to, Value value)
{
    to.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// A part of a binary glTF file: its length, its name and its bytes, filled up to whole words.
std::string glb_chunk(std::string_view name, std::string bytes, char filling)
{
    bytes.resize((bytes.size() + 3) / 4 * 4, filling);
    std::string chunk;
    append_bytes(chunk, static_cast<std::uint32_t>(bytes.size()));
    return chunk.append(name).append(bytes);
}

/// Describes a buffer that has places and then normals of each group, which are drawn as points (mode 0). Floats are
/// numbers of type 5126.
std::string gltf_of_points(const std::vector<GltfGroup>& groups)
{
    std::vector<std::string> nodes, numbers, meshes, accessors, views;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const auto& [name, places, normals] = groups[i];
        std::array<float, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
        for (std::size_t k = 0; k < places.size(); ++k) {
            low[k % 3] = std::min(low[k % 3], places[k]);
            high[k % 3] = std::max(high[k % 3], places[k]);
        }
        const std::string named = name.empty() ? "" : fmt::format(R"("name":"{}",)", name);
        const std::size_t bytes = 4 * places.size(), count = places.size() / 3;
        numbers.push_back(std::to_string(i));
        nodes.push_back(fmt::format(R"({{{}"mesh":{}}})", named, i));
        meshes.push_back(fmt::format(R"({{{}"primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{}}},"mode":0}}]}})",
                                     named, 2 * i, 2 * i + 1));
        accessors.push_back(fmt::format(
            R"({{"bufferView":{0},"componentType":5126,"count":{2},"type":"VEC3","min":[{3}],"max":[{4}]}},)"
            R"({{"bufferView":{1},"componentType":5126,"count":{2},"type":"VEC3"}})",
            2 * i, 2 * i + 1, count, fmt::join(low, ","), fmt::join(high, ",")));
        for (int view = 0; view < 2; ++view, begin += bytes)
            views.push_back(fmt::format(R"({{"buffer":0,{}"byteLength":{}}})",
                                        begin == 0 ? "" : fmt::format(R"("byteOffset":{},)", begin), bytes));
    }
    return fmt::format(
        R"({{"asset":{{"version":"2.0","generator":"Poisson disk laboratory"}},"scene":0,"scenes":[{{"nodes":[{}]}}],)"
        R"("nodes":[{}],"meshes":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
        fmt::join(numbers, ","), fmt::join(nodes, ","), fmt::join(meshes, ","), fmt::join(accessors, ","),
        fmt::join(views, ","), begin);
}

}

void write_surface_glb(const std::filesystem::path& file, std::vector<GltfGroup> groups)
{
    std::erase_if(groups, [](const GltfGroup& group) { return group.places.empty(); });
    std::string binary;
    for (const GltfGroup& group : groups)
        for (const std::vector<float>* floats : {&group.places, &group.normals})
            for (const float c : *floats) append_bytes(binary, c);
    std::string chunks =
        glb_chunk("JSON", groups.empty() ? R"({"asset":{"version":"2.0"}})" : gltf_of_points(groups), ' ');
    if (!groups.empty()) chunks += glb_chunk(std::string_view("BIN\0", 4), binary, '\0');
    std::string head = "glTF";
    append_bytes(head, std::uint32_t{2});
    append_bytes(head, static_cast<std::uint32_t>(12 + chunks.size()));
    write_whole_file(file, head + chunks);
}

}
