#include "host/distribution/surface_textures/quad_atlas.hpp"

#include "base/files/scratch_folder.hpp"
#include "base/files/whole_file.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "host/distribution/gltf_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Quads meet in a crease where the cosine between their normals is less.
constexpr double least_smooth_cosine = 0.766;

/// Returns twice the vector area of a quad, which lies along its mean normal.
MeshPoint area_of(const QuadMesh& mesh, std::uint32_t quad)
{
    const auto& [a, b, c, d] = mesh.quads[quad];
    return cross(difference(mesh.vertices[c], mesh.vertices[a]), difference(mesh.vertices[d], mesh.vertices[b]));
}

/// Collects the bytes of a GLB's buffer, and the views of its parts.
class GlbBuffer
{
public:
    template <class Value>
    void add(const std::vector<Value>& values, int target)
    {
        add_bytes(std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)),
                  target);
    }
    void add_bytes(std::string_view part, int target)
    {
        nlohmann::ordered_json view{{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", part.size()}};
        if (target != 0) view["target"] = target;
        views.push_back(view);
        bytes.append(part);
        bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    }

    std::string bytes;
    nlohmann::ordered_json views = nlohmann::ordered_json::array();
};

/// Returns the bytes of a picture's PNG file.
std::string png_bytes(const PngPixels& pixels)
{
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "picture.png";
    write_png(file, pixels);
    return read_whole_file(file);
}

struct GlbVertices
{
    std::vector<float> places, normals, texture;
    std::vector<std::uint32_t> corners;
};

/// Makes five vertices of each quad; z upwards becomes y upwards, as glTF has it.
GlbVertices glb_vertices(const QuadMesh& mesh, const QuadTopology& topology, const QuadAtlas& atlas)
{
    constexpr std::array<std::array<double, 2>, 5> places{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}}};
    const auto normals = corner_normals(mesh, topology);
    GlbVertices all;
    const auto add = [](std::vector<float>& to, const MeshPoint& p) {
        for (const double c : {p[0], p[2], -p[1]}) to.push_back(static_cast<float>(c));
    };
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q) {
        MeshPoint mean{};
        for (const MeshPoint& normal : normals[q])
            for (std::size_t k = 0; k < 3; ++k) mean[k] += normal[k];
        for (std::size_t i = 0; i < 5; ++i) {
            add(all.places, i < 4 ? mesh.vertices[mesh.quads[q][i]] : middle_of(mesh, q));
            add(all.normals, i < 4 ? normals[q][i] : unit(mean));
            const auto at = atlas.place_of(q, places[i][0], places[i][1]);
            all.texture.push_back(static_cast<float>(at[0] / atlas.color.width));
            all.texture.push_back(static_cast<float>(at[1] / atlas.color.height));
            if (i < 4)
                all.corners.insert(all.corners.end(), {5 * q + static_cast<std::uint32_t>(i),
                                                       5 * q + static_cast<std::uint32_t>(i + 1) % 4, 5 * q + 4});
        }
    }
    return all;
}

}

QuadAtlas QuadAtlas::with(std::size_t count, int side, int gutter, int channels)
{
    QuadAtlas atlas{side, gutter, std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))))),
                    {},   {},     {}};
    const int whole = side + 2 * gutter, rows = (static_cast<int>(count) + atlas.columns - 1) / atlas.columns;
    atlas.color = {atlas.columns * whole, rows * whole, channels, {}};
    atlas.color.values.resize(atlas.color.at(0, atlas.color.height, 0));
    return atlas;
}

std::array<int, 2> QuadAtlas::corner_of(std::uint32_t cell) const
{
    const int number = static_cast<int>(cell), whole = side + 2 * gutter;
    return {number % columns * whole, number / columns * whole};
}

std::array<double, 2> QuadAtlas::place_of(std::uint32_t quad, double u, double v) const
{
    const auto [left, top] = corner_of(cells[quad].number);
    const auto at = turned_place(u, v, 4 - cells[quad].first);
    return {left + gutter + at[0] * side, top + gutter + (1 - at[1]) * side};
}

AtlasSteps atlas_steps(const QuadAtlas& atlas, const QuadMesh& mesh, const QuadTopology& topology)
{
    const PngPixels& picture = atlas.color;
    // This finds the pixel of a quad that lies so far along one of its sides, and so deep.
    const auto pixel = [&](QuadCorner side, int along, int depth) {
        const auto place = turned_place((along + 0.5) / atlas.side, (depth + 0.5) / atlas.side, side.corner);
        const auto at = atlas.place_of(side.quad, place[0], place[1]);
        return &picture.values[picture.at(static_cast<int>(at[0]), static_cast<int>(at[1]), 0)];
    };
    const auto step = [&](const std::uint8_t* a, const std::uint8_t* b) {
        int sum = 0;
        for (int c = 0; c < picture.channels; ++c) sum += std::abs(a[c] - b[c]);
        return static_cast<double>(sum) / atlas.side;
    };
    AtlasSteps steps;
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q)
        for (std::uint32_t k = 0; k < 4; ++k) {
            double across = 0, inside = 0;
            for (int t = 0; t < atlas.side; ++t) {
                across += step(pixel({q, k}, t, 0), pixel(topology.across({q, k}), atlas.side - 1 - t, 0));
                inside += step(pixel({q, k}, t, 0), pixel({q, k}, t, 1));
            }
            const double sides = 4 * static_cast<double>(mesh.quads.size());
            steps.across += across / sides;
            steps.inside += inside / sides;
            steps.greatest_across = std::max(steps.greatest_across, across);
            steps.greatest_inside = std::max(steps.greatest_inside, inside);
        }
    return steps;
}

PngPixels normals_of_heights(const PngPixels& heights, double relief)
{
    PngPixels normals{heights.width, heights.height, 3, {}};
    const auto height = [&](int x, int y) {
        return heights
                   .values[heights.at(std::clamp(x, 0, heights.width - 1), std::clamp(y, 0, heights.height - 1), 0)] *
               relief / 255;
    };
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) {
            const MeshPoint n =
                unit({(height(x - 1, y) - height(x + 1, y)) / 2, (height(x, y + 1) - height(x, y - 1)) / 2, 1});
            for (const double c : n)
                normals.values.push_back(static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * c)));
        }
    return normals;
}

std::vector<std::array<MeshPoint, 4>> corner_normals(const QuadMesh& mesh, const QuadTopology& topology)
{
    std::vector<MeshPoint> areas;
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q) areas.push_back(area_of(mesh, q));
    std::vector<std::array<MeshPoint, 4>> normals(mesh.quads.size());
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k) {
            const MeshPoint own = unit(areas[q]);
            MeshPoint sum{};
            for (const QuadCorner& other : topology.around(mesh.quads[q][k])) {
                const MeshPoint n = unit(areas[other.quad]);
                if (n[0] * own[0] + n[1] * own[1] + n[2] * own[2] < least_smooth_cosine) continue;
                for (std::size_t i = 0; i < 3; ++i) sum[i] += areas[other.quad][i];
            }
            normals[q][k] = unit(sum);
        }
    return normals;
}

void write_glb(const std::filesystem::path& file, const QuadMesh& mesh, const QuadTopology& topology,
               const QuadAtlas& atlas)
{
    using Json = nlohmann::ordered_json;
    const GlbVertices v = glb_vertices(mesh, topology, atlas);
    GlbBuffer buffer;
    buffer.add(v.places, 34962);
    buffer.add(v.normals, 34962);
    buffer.add(v.texture, 34962);
    buffer.add(v.corners, 34963);
    buffer.add_bytes(png_bytes(atlas.color), 0);
    const bool has_normals = !atlas.normal.values.empty();
    if (has_normals) buffer.add_bytes(png_bytes(atlas.normal), 0);

    std::vector<float> low(3, INFINITY), high(3, -INFINITY);
    for (std::size_t i = 0; i < v.places.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], v.places[i]);
        high[i % 3] = std::max(high[i % 3], v.places[i]);
    }
    const auto accessor = [](int view, int type, std::size_t count, const char* shape) {
        return Json{{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}};
    };
    const std::size_t count = v.places.size() / 3;
    Json places = accessor(0, 5126, count, "VEC3");
    places["min"] = low;
    places["max"] = high;
    Json material{{"pbrMetallicRoughness",
                   {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}}};
    Json images = Json::array({{{"bufferView", 4}, {"mimeType", "image/png"}}});
    Json textures = Json::array({{{"source", 0}, {"sampler", 0}}});
    if (has_normals) {
        material["normalTexture"] = {{"index", 1}};
        images.push_back({{"bufferView", 5}, {"mimeType", "image/png"}});
        textures.push_back({{"source", 1}, {"sampler", 0}});
    }
    const Json json{
        {"asset", {{"version", "2.0"}, {"generator", "Poisson disk laboratory"}}},
        {"scene", 0},
        {"scenes", Json::array({{{"nodes", {0}}}})},
        {"nodes", Json::array({{{"mesh", 0}}})},
        {"meshes",
         Json::array({{{"primitives", Json::array({{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}},
                                                    {"indices", 3},
                                                    {"material", 0}}})}}})},
        {"materials", Json::array({material})},
        {"textures", textures},
        {"images", images},
        {"samplers", Json::array({{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33071}}})},
        {"accessors", Json::array({places, accessor(1, 5126, count, "VEC3"), accessor(2, 5126, count, "VEC2"),
                                   accessor(3, 5125, v.corners.size(), "SCALAR")})},
        {"bufferViews", buffer.views},
        {"buffers", Json::array({{{"byteLength", buffer.bytes.size()}}})}};
    write_glb_parts(file, json.dump(), buffer.bytes);
}

}
