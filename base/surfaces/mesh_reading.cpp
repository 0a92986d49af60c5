// Files of polygons, as triangles.
#include "base/surfaces/mesh_reading.hpp"

#include "base/errors/errors.hpp"
#include "base/files/mapped_file.hpp"
#include "base/files/whole_file.hpp"
#include "base/surfaces/gltf_file.hpp"
#include "base/text/plain_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace poissonlab {
namespace {

[[noreturn]] void fail_in_mesh(const std::filesystem::path& file, const std::string& problem)
{
    throw InputError::at({file.string()}, problem);
}

/// The format of a file that can be a mesh.
const MeshFormat& checked_format(const std::filesystem::path& file)
{
    const MeshFormat* const format = mesh_format(file);
    if (!format)
        fail_in_mesh(file,
                     "a mesh is a file of OFF, OBJ, PLY, STL or glTF, and its name ends in .off, .obj, .ply, .stl, "
                     ".gltf or .glb");
    if (is_no_lasting_file(file)) fail_in_mesh(file, "must be a file on a disk");
    if (!std::filesystem::is_regular_file(file)) fail_in_mesh(file, "must be a file that is there");
    return *format;
}

/// The search for triangles takes time with the cube of a face's corners.
constexpr std::size_t most_corners = 1000;

/// Adds the faces of a soup to a mesh that has its vertices, as triangles.
class FaceDivision
{
public:
    using Corners = std::span<const std::uint32_t>;

    explicit FaceDivision(TriangleMesh& mesh) : mesh_(mesh) {}

    /// `texture` and `normals` have the numbers of the texture points and normals of these corners; they may be empty.
    void add(Corners polygon, Corners texture, Corners normals)
    {
        const std::vector<std::uint32_t> corners = different_corners(polygon);
        const auto add_triangle = [&](const MeshTriangle& of) {
            const auto chosen = [&](Corners all) {
                return MeshTriangle{all[corners[of[0]]], all[corners[of[1]]], all[corners[of[2]]]};
            };
            mesh_.triangles.push_back(chosen(polygon));
            mesh_.faces.push_back(face_);
            if (!texture.empty()) mesh_.texture_triangles.push_back(chosen(texture));
            if (!normals.empty()) mesh_.normal_triangles.push_back(chosen(normals));
        };
        if (corners.size() == 3) {
            add_triangle({0, 1, 2});
        } else {
            std::vector<MeshPoint> places;
            for (const std::uint32_t c : corners) places.push_back(mesh_.vertices[polygon[c]]);
            const auto filled = corners.size() > 3 ? polygon_triangles(places) : std::vector<MeshTriangle>{};
            for (const MeshTriangle& t : filled) add_triangle(t);
            ++(filled.empty() ? mesh_.dropped : mesh_.divided);
        }
        ++face_;
    }

private:
    /// The corners of a polygon, by their places in it, without those that repeat the one before.
    static std::vector<std::uint32_t> different_corners(Corners polygon)
    {
        std::vector<std::uint32_t> corners;
        for (std::uint32_t c = 0; c < polygon.size(); ++c)
            if (corners.empty() || polygon[corners.back()] != polygon[c]) corners.push_back(c);
        while (corners.size() > 1 && polygon[corners.back()] == polygon[corners.front()]) corners.pop_back();
        return corners;
    }

    TriangleMesh& mesh_;
    std::uint32_t face_ = 0;
};

/// Moves the normals of vertices from the columns nx, ny and nz, if a file has these, to the normals of the mesh.
void take_normals(PolygonSoup& soup)
{
    VertexColumns& columns = soup.columns;
    std::array<std::size_t, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto found = std::ranges::find(columns.names, std::array{"nx", "ny", "nz"}[k]);
        if (found == columns.names.end()) return;
        at[k] = static_cast<std::size_t>(found - columns.names.begin());
    }
    for (std::size_t v = 0; v < soup.points.size(); ++v)
        soup.normals.push_back({columns.at(v, at[0]), columns.at(v, at[1]), columns.at(v, at[2])});
    soup.normal_corners = soup.corners;
    VertexColumns rest;
    for (std::size_t c = 0; c < columns.names.size(); ++c)
        if (std::ranges::find(at, c) == at.end()) {
            rest.names.push_back(columns.names[c]);
            rest.are_bytes.push_back(columns.are_bytes[c]);
        }
    for (std::size_t v = 0; v < soup.points.size(); ++v)
        for (std::size_t c = 0; c < columns.names.size(); ++c)
            if (std::ranges::find(at, c) == at.end()) rest.values.push_back(columns.at(v, c));
    columns = std::move(rest);
}

}

PolygonSoup read_polygons(const std::filesystem::path& file, MeshParts parts)
{
    const MeshFormat& format = checked_format(file);
    const MappedFile content(file);
    if (content.bytes().empty()) fail_in_mesh(file, "is empty");
    PolygonSoup soup = format.read({file.string(), plain_text(file.string(), content.bytes()), parts});
    if (soup.sizes.empty()) fail_in_mesh(file, fmt::format("has no faces: {}", format.faces));
    return soup;
}

TriangleMesh read_triangle_mesh(const std::filesystem::path& file, MeshParts parts)
{
    PolygonSoup soup = read_polygons(file, parts);
    if (soup.normal_corners.empty()) take_normals(soup);
    TriangleMesh mesh;
    mesh.vertices = std::move(soup.points);
    mesh.texture_points = std::move(soup.texture_points);
    mesh.normals = std::move(soup.normals);
    mesh.columns = std::move(soup.columns);
    mesh.notes = std::move(soup.notes);
    if (soup.lines > 0)
        mesh.notes.push_back(
            fmt::format("{} of the file, which {} no area, {} left out",
                        soup.lines == 1 ? "1 line or point" : fmt::format("{} lines or points", soup.lines),
                        soup.lines == 1 ? "has" : "have", soup.lines == 1 ? "was" : "were"));
    FaceDivision faces(mesh);
    FaceDivision::Corners corners = soup.corners, texture = soup.texture_corners, normals = soup.normal_corners;
    for (const std::uint32_t size : soup.sizes) {
        if (size > most_corners)
            fail_in_mesh(file, fmt::format("has a face of {} corners: at most {}", size, most_corners));
        const auto first = [size](FaceDivision::Corners all) { return all.empty() ? all : all.first(size); };
        faces.add(corners.first(size), first(texture), first(normals));
        for (FaceDivision::Corners* all : {&corners, &texture, &normals}) *all = all->subspan(first(*all).size());
    }
    return mesh;
}

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
