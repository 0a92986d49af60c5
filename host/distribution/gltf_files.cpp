#include "host/distribution/gltf_files.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

using GltfJson = nlohmann::ordered_json;

void append_word(std::string& to, std::size_t word)
{
    for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<char>(word >> shift & 255));
}

/// A part of a binary glTF file: its length, its name and its bytes, filled up to whole words.
std::string glb_chunk(std::string_view name, std::string bytes, char filling)
{
    bytes.resize((bytes.size() + 3) / 4 * 4, filling);
    std::string chunk;
    append_word(chunk, bytes.size());
    return chunk.append(name).append(bytes);
}

/// Collects the nodes of a scene, each with a mesh, and the numbers that their accessors lead to.
class GltfScene
{
public:
    /// Adds floats, `width` of each thing, and returns the number of their accessor.
    std::size_t add(const std::vector<float>& values, std::size_t width, bool has_bounds = false)
    {
        if (!std::ranges::all_of(values, [](float v) { return std::isfinite(v); }))
            throw InputError("glTF: numbers are larger than floats hold; choose a larger unit of length");
        GltfJson view{{"buffer", 0}, {"byteLength", 4 * values.size()}};
        if (!bytes_.empty()) view["byteOffset"] = bytes_.size();
        GltfJson accessor{{"bufferView", views_.size()},
                          {"componentType", 5126},
                          {"count", values.size() / width},
                          {"type", width == 1 ? "SCALAR" : "VEC" + std::to_string(width)}};
        if (has_bounds) {
            std::vector<float> low(width, INFINITY), high(width, -INFINITY);
            for (std::size_t k = 0; k < values.size(); ++k) {
                low[k % width] = std::min(low[k % width], values[k]);
                high[k % width] = std::max(high[k % width], values[k]);
            }
            accessor["min"] = low;
            accessor["max"] = high;
        }
        views_.push_back(view);
        accessors_.push_back(accessor);
        bytes_.append(reinterpret_cast<const char*>(values.data()), 4 * values.size());
        return accessors_.size() - 1;
    }

    /// Adds a mesh of one primitive and a node that has it. `more` are further members of the node.
    void add_node(const std::string& name, GltfJson primitive, const GltfJson& more = GltfJson::object())
    {
        GltfJson node{{"mesh", nodes_.size()}}, mesh{{"primitives", GltfJson::array({std::move(primitive)})}};
        if (!name.empty()) mesh["name"] = node["name"] = name;
        node.update(more);
        roots_.push_back(nodes_.size());
        nodes_.push_back(node);
        meshes_.push_back(mesh);
    }

    void write(const std::filesystem::path& file, const GltfJson& more = GltfJson::object()) const
    {
        GltfJson json{{"asset", {{"version", "2.0"}, {"generator", "Poisson disk laboratory"}}}};
        json.update(more);
        if (!nodes_.empty()) {
            json["scene"] = 0;
            json["scenes"] = GltfJson::array({{{"nodes", roots_}}});
            json["nodes"] = nodes_;
            json["meshes"] = meshes_;
            json["accessors"] = accessors_;
            json["bufferViews"] = views_;
            json["buffers"] = GltfJson::array({{{"byteLength", bytes_.size()}}});
        }
        write_glb_parts(file, json.dump(), bytes_);
    }

private:
    std::string bytes_;
    std::vector<GltfJson> nodes_, meshes_, accessors_, views_;
    std::vector<std::size_t> roots_;
};

/// Places as floats, and what their node is moved by.
struct NearPlaces
{
    std::vector<float> places;
    GltfJson node = GltfJson::object();
};

/// Floats have 24 bits: far from the origin they would not tell neighbours apart. There places count from the middle of
/// their box.
NearPlaces near_places(const std::vector<double>& places)
{
    constexpr double far = 16; // extents
    std::array<double, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY}, origin{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], places[i]);
        high[i % 3] = std::max(high[i % 3], places[i]);
    }
    double extent = 0, distance = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        extent = std::max(extent, high[k] - low[k]);
        distance = std::max(distance, std::abs(low[k] / 2 + high[k] / 2));
    }
    NearPlaces result;
    if (distance > far * extent) { // a single instance has no extent, and stands where its node is
        for (std::size_t k = 0; k < 3; ++k) origin[k] = low[k] / 2 + high[k] / 2;
        result.node["translation"] = origin;
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        result.places.push_back(static_cast<float>(places[i] - origin[i % 3]));
    return result;
}

/// The corners of a model, triangle by triangle, three floats each.
struct ModelCorners
{
    std::vector<float> places, normals;
};

/// Corners have the normals of the file; those that lack one have that of their triangle.
ModelCorners corners_of(const TriangleMesh& model)
{
    ModelCorners corners;
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        const auto at = [&](std::size_t corner) { return model.vertices[model.triangles[i][corner]]; };
        const MeshPoint flat = cross(difference(at(1), at(0)), difference(at(2), at(0)));
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t given =
                model.normal_triangles.empty() ? no_texture_point : model.normal_triangles[i][corner];
            const MeshPoint place = at(corner), normal = unit(given == no_texture_point ? flat : model.normals[given]);
            corners.places.insert(corners.places.end(), place.begin(), place.end());
            corners.normals.insert(corners.normals.end(), normal.begin(), normal.end());
        }
    }
    return corners;
}

/// Along all three axes.
std::vector<float> thrice(const std::vector<float>& scales)
{
    std::vector<float> all;
    for (const float scale : scales) all.insert(all.end(), 3, scale);
    return all;
}

}

TriangleMesh turned_model(double top, const std::vector<ModelRing>& rings, double bottom)
{
    constexpr std::uint32_t sides = 12;
    TriangleMesh model;
    model.vertices = {{0, top, 0}, {0, bottom, 0}};
    for (const auto& [radius, height] : rings)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            model.vertices.push_back({radius * std::cos(angle), height, radius * std::sin(angle)});
        }
    const auto last = static_cast<std::uint32_t>(2 + (rings.size() - 1) * sides);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        model.triangles.push_back({0, 2 + next, 2 + i});
        for (std::uint32_t ring = 2; ring < last; ring += sides) {
            model.triangles.push_back({ring + i, ring + next, ring + sides + next});
            model.triangles.push_back({ring + i, ring + sides + next, ring + sides + i});
        }
        model.triangles.push_back({1, last + i, last + next});
    }
    return model;
}

void write_glb_parts(const std::filesystem::path& file, std::string json, std::string_view buffer)
{
    if (json.size() + buffer.size() + 64 > std::numeric_limits<std::uint32_t>::max())
        throw InputError("glTF: a file has less than 4 GB; these points or models need more");
    std::string chunks = glb_chunk("JSON", std::move(json), ' ');
    if (!buffer.empty()) chunks += glb_chunk(std::string_view("BIN\0", 4), std::string(buffer), '\0');
    std::string head = "glTF";
    append_word(head, 2);
    append_word(head, 12 + chunks.size());
    write_whole_file(file, head + chunks);
}

void write_surface_glb(const std::filesystem::path& file, std::vector<GltfGroup> groups)
{
    std::erase_if(groups, [](const GltfGroup& group) { return group.places.empty(); });
    GltfScene scene;
    for (const auto& [name, places, normals] : groups) {
        const NearPlaces near = near_places(places);
        const std::size_t first = scene.add(near.places, 3, true), second = scene.add(normals, 3);
        scene.add_node(name, {{"attributes", {{"POSITION", first}, {"NORMAL", second}}}, {"mode", 0}}, // 0: points
                       near.node);
    }
    scene.write(file);
}

void write_instance_glb(const std::filesystem::path& file, std::vector<GltfInstances> groups)
{
    constexpr auto extension = "EXT_mesh_gpu_instancing";
    std::erase_if(groups, [](const GltfInstances& group) { return group.ids.empty(); });
    GltfScene scene;
    GltfJson materials = GltfJson::array();
    for (const GltfInstances& group : groups) {
        const ModelCorners corners = corners_of(*group.model);
        const std::size_t places = scene.add(corners.places, 3, true), normals = scene.add(corners.normals, 3);
        NearPlaces near = near_places(group.places);
        GltfJson attributes{
            {"TRANSLATION", scene.add(near.places, 3)},
            {"ROTATION", scene.add(group.turns, 4)},
            {"SCALE", scene.add(thrice(group.scales), 3)},
            {"_ID", scene.add(group.ids, 1)},
        };
        if (group.of_class) attributes["_CLASS"] = scene.add(std::vector<float>(group.ids.size(), *group.of_class), 1);
        const std::size_t material = materials.size();
        materials.push_back({{"pbrMetallicRoughness",
                              {{"baseColorFactor", {group.color[0], group.color[1], group.color[2], 1}},
                               {"metallicFactor", 0},
                               {"roughnessFactor", 0.8}}},
                             {"doubleSided", true}});
        near.node["extensions"] = {{extension, {{"attributes", attributes}}}};
        scene.add_node(group.name,
                       {{"attributes", {{"POSITION", places}, {"NORMAL", normals}}}, {"material", material}},
                       near.node);
    }
    GltfJson more = GltfJson::object();
    if (!groups.empty()) {
        more["extensionsUsed"] = more["extensionsRequired"] = GltfJson::array({extension});
        more["materials"] = materials;
    }
    scene.write(file, more);
}

}
