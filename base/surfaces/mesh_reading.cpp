// Files of polygons, by CGAL's readers, which say neither line nor reason where a file is wrong.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/surfaces/gltf_mesh.hpp"
#include "base/surfaces/texture_coordinates.hpp"
#include "base/surfaces/triangle_mesh.hpp"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

namespace poissonlab {
namespace {

using SoupPoint = CGAL::Simple_cartesian<double>::Point_3;

struct PolygonSoup
{
    std::vector<SoupPoint> points;
    std::vector<std::vector<std::size_t>> polygons;
};

[[noreturn]] void fail_in_mesh(const std::filesystem::path& file, const std::string& problem)
{
    throw InputError::at({file.string()}, problem);
}

void check_indices(const std::filesystem::path& file, const PolygonSoup& soup)
{
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
        for (const std::size_t corner : soup.polygons[f])
            if (corner >= soup.points.size())
                fail_in_mesh(file, fmt::format("face {} has a vertex that is not there: there are {} vertices", f + 1,
                                               soup.points.size()));
}

/// The end of a file's name, in lower case, once the file is one that can be a mesh.
std::string checked_end(const std::filesystem::path& file)
{
    std::string end = file.extension().string();
    std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (end != ".off" && end != ".obj" && end != ".ply" && end != ".stl" && !is_gltf_end(end))
        fail_in_mesh(file,
                     "a mesh is a file of OFF, OBJ, PLY, STL or glTF, and its name ends in .off, .obj, .ply, .stl, "
                     ".gltf or .glb");
    if (is_no_lasting_file(file)) fail_in_mesh(file, "must be a file on a disk");
    if (!std::filesystem::is_regular_file(file)) fail_in_mesh(file, "must be a file that is there");
    return end;
}

PolygonSoup read_soup(const std::filesystem::path& file, const std::string& end)
{
    PolygonSoup soup;
    bool is_read = false;
    try {
        // CGAL looks at the end of the name, in lower case only.
        const auto quiet = CGAL::parameters::verbose(false);
        const std::string name = file.string();
        is_read = end == ".off"   ? CGAL::IO::read_OFF(name, soup.points, soup.polygons, quiet)
                  : end == ".obj" ? CGAL::IO::read_OBJ(name, soup.points, soup.polygons, quiet)
                  : end == ".ply" ? CGAL::IO::read_PLY(name, soup.points, soup.polygons, quiet)
                                  : CGAL::IO::read_STL(name, soup.points, soup.polygons, quiet);
    } catch (const std::exception&) { // of memory, where counts in the file lie, among others
        is_read = false;
    }
    check_indices(file, soup);
    if (!is_read && soup.polygons.empty())
        fail_in_mesh(file, "cannot be read as a mesh: it is damaged, or has no faces");
    if (!is_read) fail_in_mesh(file, "is damaged, or has coordinates that are no finite numbers");
    if (soup.polygons.empty()) fail_in_mesh(file, "has no faces");
    return soup;
}

/// The search for triangles takes time with the cube of a face's corners.
constexpr std::size_t most_corners = 1000;

/// Adds the faces of a soup to a mesh that has its vertices, as triangles.
class FaceDivision
{
public:
    FaceDivision(TriangleMesh& mesh, std::vector<std::uint32_t> texture) : mesh_(mesh), texture_(std::move(texture)) {}

    void add(const std::vector<std::size_t>& polygon)
    {
        const std::vector<std::uint32_t> corners = different_corners(polygon);
        if (corners.size() == 3) {
            add_triangle(polygon, corners, {0, 1, 2});
        } else {
            std::vector<MeshPoint> places;
            for (const std::uint32_t c : corners) places.push_back(mesh_.vertices[polygon[c]]);
            const auto filled = corners.size() > 3 ? polygon_triangles(places) : std::vector<MeshTriangle>{};
            for (const MeshTriangle& t : filled) add_triangle(polygon, corners, t);
            ++(filled.empty() ? mesh_.dropped : mesh_.divided);
        }
        first_ += polygon.size();
    }

private:
    /// The corners of a polygon, by their places in it, without those that repeat the one before.
    static std::vector<std::uint32_t> different_corners(const std::vector<std::size_t>& polygon)
    {
        std::vector<std::uint32_t> corners;
        for (std::uint32_t c = 0; c < polygon.size(); ++c)
            if (corners.empty() || polygon[corners.back()] != polygon[c]) corners.push_back(c);
        while (corners.size() > 1 && polygon[corners.back()] == polygon[corners.front()]) corners.pop_back();
        return corners;
    }

    void add_triangle(const std::vector<std::size_t>& polygon, const std::vector<std::uint32_t>& corners,
                      const MeshTriangle& of)
    {
        MeshTriangle triangle{}, texture{};
        for (std::size_t k = 0; k < 3; ++k) {
            triangle[k] = static_cast<std::uint32_t>(polygon[corners[of[k]]]);
            if (!texture_.empty()) texture[k] = texture_[first_ + corners[of[k]]];
        }
        mesh_.triangles.push_back(triangle);
        if (!texture_.empty()) mesh_.texture_triangles.push_back(texture);
    }

    TriangleMesh& mesh_;
    std::vector<std::uint32_t> texture_; ///< of the corners of all faces; empty: there are none
    std::size_t first_ = 0;              ///< of these, that of the next face
};

}

TriangleMesh read_triangle_mesh(const std::filesystem::path& file, MeshParts parts)
{
    const std::string end = checked_end(file);
    if (is_gltf_end(end)) return read_gltf_mesh(file);
    const PolygonSoup soup = read_soup(file, end);
    if (soup.points.size() > UINT32_MAX / 4 || soup.polygons.size() > UINT32_MAX / 4)
        fail_in_mesh(file, fmt::format("has more than {} vertices or faces", UINT32_MAX / 4));
    TriangleMesh mesh;
    mesh.vertices.reserve(soup.points.size());
    for (const SoupPoint& p : soup.points) {
        mesh.vertices.push_back({p.x(), p.y(), p.z()});
        for (const double c : mesh.vertices.back())
            if (!std::isfinite(c))
                fail_in_mesh(file,
                             fmt::format("vertex {} has a coordinate that is no finite number", mesh.vertices.size()));
    }
    TextureCoordinates texture;
    if (parts == MeshParts::faces_and_texture) texture = read_texture_coordinates(file, end, soup.polygons);
    mesh.texture_points = std::move(texture.points);
    FaceDivision faces(mesh, std::move(texture.corners));
    for (const auto& polygon : soup.polygons) {
        if (polygon.size() > most_corners)
            fail_in_mesh(file, fmt::format("has a face of {} corners: at most {}", polygon.size(), most_corners));
        faces.add(polygon);
    }
    return mesh;
}

}
