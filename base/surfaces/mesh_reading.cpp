// Files of meshes, by CGAL's readers, which say neither line nor reason where a file is wrong.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
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

PolygonSoup read_soup(const std::filesystem::path& file)
{
    std::string end = file.extension().string();
    std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (end != ".off" && end != ".obj" && end != ".ply" && end != ".stl")
        fail_in_mesh(file, "a mesh is a file of OFF, OBJ, PLY or STL, and its name ends in .off, .obj, .ply or .stl");
    if (is_no_lasting_file(file)) fail_in_mesh(file, "must be a file on a disk");
    if (!std::filesystem::is_regular_file(file)) fail_in_mesh(file, "must be a file that is there");
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

/// The corners of a polygon without those that repeat the one before.
std::vector<std::uint32_t> corners_of(const std::vector<std::size_t>& polygon)
{
    std::vector<std::uint32_t> corners;
    for (const std::size_t c : polygon)
        if (corners.empty() || corners.back() != c) corners.push_back(static_cast<std::uint32_t>(c));
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    return corners;
}

void add_polygon(TriangleMesh& mesh, const std::vector<std::uint32_t>& corners)
{
    if (corners.size() == 3) return mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    std::vector<MeshPoint> places;
    for (const std::uint32_t c : corners) places.push_back(mesh.vertices[c]);
    const auto filled = corners.size() > 3 ? polygon_triangles(places) : std::vector<MeshTriangle>{};
    for (const auto& [a, b, c] : filled) mesh.triangles.push_back({corners[a], corners[b], corners[c]});
    ++(filled.empty() ? mesh.dropped : mesh.divided);
}

}

TriangleMesh read_triangle_mesh(const std::filesystem::path& file)
{
    const PolygonSoup soup = read_soup(file);
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
    for (const auto& polygon : soup.polygons) {
        if (polygon.size() > most_corners)
            fail_in_mesh(file, fmt::format("has a face of {} corners: at most {}", polygon.size(), most_corners));
        add_polygon(mesh, corners_of(polygon));
    }
    return mesh;
}

}
