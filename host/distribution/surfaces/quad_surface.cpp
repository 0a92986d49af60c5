#include "host/distribution/surfaces/quad_surface.hpp"

#include "base/errors/errors.hpp"
#include "base/surfaces/polygon_soup.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace poissonlab {
namespace {

constexpr std::size_t most_quads = std::size_t{1} << 22;
constexpr int most_cubes_from_0 = 1 << 16;

/// Polycubes may be off their grid by this part of a cube's side.
constexpr double grid_slack = 0.01;

double volume(const MeshPoint& a, const MeshPoint& b, const MeshPoint& c) { return dot(a, cross(b, c)); }

double length(const MeshPoint& a) { return std::sqrt(dot(a, a)); }

using Corners = std::array<MeshPoint, 3>;

/// Returns the place of a triangle with these shares of its corners, which need not add up to one.
MeshPoint place_of_shares(const Corners& corners, const MeshPoint& shares)
{
    const double sum = shares[0] + shares[1] + shares[2];
    MeshPoint place{};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) place[k] += shares[i] / sum * corners[i][k];
    return place;
}

/// Keeps the triangle in which a place is, or which it misses least: `least` is its least share of a corner.
struct Hit
{
    std::size_t triangle = 0;
    MeshPoint shares{};
    double least = -INFINITY;

    void offer(std::size_t number, const MeshPoint& of)
    {
        const double sum = of[0] + of[1] + of[2];
        if (!(sum > 0)) return;
        if (const double lowest = std::min({of[0], of[1], of[2]}) / sum; lowest > least) *this = {number, of, lowest};
    }
};

/// Divides polygons into triangles around their first corner, so that two meshes of the same faces have the same ones.
std::vector<MeshTriangle> fans_of_faces(const PolygonSoup& soup)
{
    std::vector<MeshTriangle> triangles;
    std::size_t first = 0;
    for (const std::uint32_t size : soup.sizes) {
        for (std::size_t k = 2; k < size; ++k)
            triangles.push_back({soup.corners[first], soup.corners[first + k - 1], soup.corners[first + k]});
        first += size;
    }
    return triangles;
}

std::vector<Corners> corners_of(const std::vector<MeshPoint>& points, const std::vector<MeshTriangle>& triangles)
{
    std::vector<Corners> corners;
    corners.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) corners.push_back({points[a], points[b], points[c]});
    return corners;
}

QuadMesh refined_within(const QuadMesh& mesh, std::uint32_t parts)
{
    if (const std::size_t count = mesh.quads.size() * parts * parts; count > most_quads)
        throw InputError(fmt::format("these are {} quads: at most {}", count, most_quads));
    return refined(mesh, QuadTopology(mesh), parts);
}

QuadMesh quads_of_faces(const QuadSettings& settings)
{
    PolygonSoup soup = read_polygons(settings.mesh, MeshParts::faces);
    QuadMesh mesh{std::move(soup.points), {}};
    for (std::size_t face = 0; face < soup.sizes.size(); ++face) {
        if (soup.sizes[face] != 4)
            throw InputError(fmt::format("face {} has {} corners: all faces must be quads, or quads = cube or polycube "
                                         "makes some",
                                         face + 1, soup.sizes[face]));
        mesh.quads.push_back({soup.corners[4 * face], soup.corners[4 * face + 1], soup.corners[4 * face + 2],
                              soup.corners[4 * face + 3]});
    }
    if (mesh.quads.size() << 2 * settings.smooth > most_quads)
        throw InputError(
            fmt::format("these are {} quads: at most {}", mesh.quads.size() << 2 * settings.smooth, most_quads));
    for (std::uint32_t step = 0; step < settings.smooth; ++step) mesh = smoothed(mesh, QuadTopology(mesh));
    return refined_within(mesh, settings.refine);
}

/// A square between whole numbers has a lowest corner, an axis, and looks along that or against it.
using Square = std::tuple<std::array<int, 3>, std::size_t, bool>;

QuadMesh mesh_of_squares(const std::set<Square>& squares)
{
    QuadMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    for (const auto& [lowest, axis, is_upper] : squares) {
        Quad quad{};
        for (std::size_t i = 0; i < 4; ++i) {
            std::array<int, 3> corner = lowest;
            const std::size_t u = (axis + (is_upper ? 1 : 2)) % 3, v = (axis + (is_upper ? 2 : 1)) % 3;
            corner[u] += i == 1 || i == 2;
            corner[v] += i == 2 || i == 3;
            const auto [at, is_new] = numbers.try_emplace(corner, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (is_new) mesh.vertices.push_back({double(corner[0]), double(corner[1]), double(corner[2])});
            quad[i] = at->second;
        }
        mesh.quads.push_back(quad);
    }
    return mesh;
}

/// Moves all vertices by a function of their places, which may throw.
template <class Move>
void move_vertices(QuadMesh& mesh, const Move& move)
{
    tbb::parallel_for(std::size_t{0}, mesh.vertices.size(),
                      [&](std::size_t i) { mesh.vertices[i] = move(mesh.vertices[i]); });
}

QuadMesh cube_quads(const QuadSettings& settings)
{
    const PolygonSoup soup = read_polygons(settings.mesh, MeshParts::faces);
    std::vector<Corners> triangles = corners_of(soup.points, fans_of_faces(soup));
    MeshPoint middle{};
    double area = 0;
    for (const Corners& t : triangles) {
        const double own = length(cross(difference(t[1], t[0]), difference(t[2], t[0])));
        area += own;
        for (std::size_t k = 0; k < 3; ++k) middle[k] += own * (t[0][k] + t[1][k] + t[2][k]) / 3;
    }
    for (double& c : middle) c /= area;
    double angle = 0; // the solid one under which the surface is seen from its middle
    std::vector<std::pair<MeshPoint, double>> cones;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        Corners& t = triangles[i];
        for (MeshPoint& corner : t) corner = difference(corner, middle);
        const double a = length(t[0]), b = length(t[1]), c = length(t[2]), whole = volume(t[0], t[1], t[2]);
        if (!(whole >= 0))
            throw InputError(fmt::format("triangle {} is seen from behind from the middle of the surface: quads = cube "
                                         "is for surfaces that are visible as a whole from there",
                                         i + 1));
        angle += 2 * std::atan2(whole, a * b * c + dot(t[0], t[1]) * c + dot(t[1], t[2]) * a + dot(t[2], t[0]) * b);
        MeshPoint towards{};
        for (std::size_t k = 0; k < 3; ++k) towards[k] = t[0][k] / a + t[1][k] / b + t[2][k] / c;
        const double norm = length(towards);
        double cosine = 1;
        for (double& x : towards) x /= norm;
        for (const MeshPoint& corner : t) cosine = std::min(cosine, dot(towards, corner) / length(corner));
        cones.emplace_back(towards, cosine - 1e-9);
    }
    if (std::abs(angle - 4 * std::numbers::pi) > 1e-6)
        throw InputError(fmt::format("is seen from its middle over {:.4g} of the whole sphere: quads = cube is for "
                                     "closed surfaces of genus 0",
                                     angle / (4 * std::numbers::pi)));
    std::set<Square> faces;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool is_upper : {false, true}) {
            std::array<int, 3> lowest{};
            lowest[axis] = is_upper;
            faces.emplace(lowest, axis, is_upper);
        }
    QuadMesh mesh = refined_within(mesh_of_squares(faces), settings.refine);
    move_vertices(mesh, [&](const MeshPoint& place) {
        MeshPoint direction{}; // squares of equal angles
        for (std::size_t k = 0; k < 3; ++k) direction[k] = std::tan((place[k] - 0.5) * std::numbers::pi / 2);
        const double norm = length(direction);
        Hit hit;
        for (std::size_t i = 0; i < triangles.size(); ++i)
            if (dot(direction, cones[i].first) >= cones[i].second * norm) {
                const Corners& t = triangles[i];
                hit.offer(
                    i, {volume(direction, t[1], t[2]), volume(t[0], direction, t[2]), volume(t[0], t[1], direction)});
            }
        MeshPoint at = place_of_shares(triangles[hit.triangle], hit.shares);
        for (std::size_t k = 0; k < 3; ++k) at[k] += middle[k];
        return at;
    });
    return mesh;
}

/// A triangle of a polycube, in units of its cubes, looks along an axis and lies in a plane.
struct PolycubeTriangle
{
    Corners corners;
    std::size_t axis = 0;
    bool is_upper = false;
    double plane = 0;

    MeshPoint shares_at(const MeshPoint& place) const
    {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto part = [&](const MeshPoint& a, const MeshPoint& b) {
            return (a[u] - place[u]) * (b[v] - place[v]) - (b[u] - place[u]) * (a[v] - place[v]);
        };
        const double sign = is_upper ? 1 : -1;
        return {sign * part(corners[1], corners[2]), sign * part(corners[2], corners[0]),
                sign * part(corners[0], corners[1])};
    }
};

std::vector<PolycubeTriangle> polycube_triangles(std::vector<Corners> corners, double side)
{
    std::vector<PolycubeTriangle> triangles;
    for (Corners& t : corners) {
        for (MeshPoint& corner : t)
            for (double& c : corner) {
                c /= side;
                if (!(std::abs(c) < most_cubes_from_0))
                    throw InputError(fmt::format("the polycube is more than {} cubes from 0; larger cubes are fewer",
                                                 most_cubes_from_0));
            }
        const MeshPoint normal = cross(difference(t[1], t[0]), difference(t[2], t[0]));
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
        const double plane = std::round(t[0][axis]);
        for (const MeshPoint& corner : t)
            if (normal[axis] != 0 && std::abs(corner[axis] - plane) > grid_slack)
                throw InputError(fmt::format("triangle {} of the polycube lies on no side of a cube: its corners must "
                                             "have a coordinate in common that is a multiple of {:.4g}",
                                             &t - corners.data() + 1, side));
        triangles.push_back({t, axis, normal[axis] > 0, plane});
    }
    return triangles;
}

std::set<Square> squares_under(const std::vector<PolycubeTriangle>& triangles)
{
    std::set<Square> squares;
    for (const PolycubeTriangle& t : triangles) {
        const std::size_t u = (t.axis + 1) % 3, v = (t.axis + 2) % 3;
        const auto range = [&](std::size_t k) {
            const auto [low, high] = std::minmax({t.corners[0][k], t.corners[1][k], t.corners[2][k]});
            return std::pair{static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high))};
        };
        for (int i = range(u).first; i < range(u).second; ++i)
            for (int j = range(v).first; j < range(v).second; ++j) {
                MeshPoint centre{};
                std::array<int, 3> lowest{};
                lowest[t.axis] = static_cast<int>(t.plane), lowest[u] = i, lowest[v] = j;
                centre[t.axis] = t.plane, centre[u] = i + 0.5, centre[v] = j + 0.5;
                Hit hit;
                hit.offer(0, t.shares_at(centre));
                if (hit.least >= -1e-9) squares.emplace(lowest, t.axis, t.is_upper);
                if (squares.size() > most_quads)
                    throw InputError("the polycube has too many squares; larger cubes have fewer");
            }
    }
    return squares;
}

QuadMesh polycube_quads(const QuadSettings& settings)
{
    const PolygonSoup own = read_polygons(settings.mesh, MeshParts::faces),
                      mapped = read_polygons(settings.polycube, MeshParts::faces);
    if (own.points.size() != mapped.points.size() || own.sizes != mapped.sizes || own.corners != mapped.corners)
        throw InputError(
            fmt::format("has {} vertices and {} faces, its polycube {} and {}: both must have the same faces",
                        own.points.size(), own.sizes.size(), mapped.points.size(), mapped.sizes.size()));
    const auto faces = fans_of_faces(own);
    const auto places = corners_of(own.points, faces);
    const auto triangles = polycube_triangles(corners_of(mapped.points, faces), settings.cube_side);
    QuadMesh mesh = refined_within(mesh_of_squares(squares_under(triangles)), settings.refine);
    move_vertices(mesh, [&](const MeshPoint& place) {
        Hit hit;
        for (std::size_t i = 0; i < triangles.size(); ++i)
            if (std::abs(place[triangles[i].axis] - triangles[i].plane) < grid_slack)
                hit.offer(i, triangles[i].shares_at(place));
        if (hit.least < -2 * grid_slack)
            throw InputError(fmt::format("no triangle of the polycube is at ({:.4g}, {:.4g}, {:.4g})", place[0],
                                         place[1], place[2]));
        return place_of_shares(places[hit.triangle], hit.shares);
    });
    return mesh;
}

}

void quad_keys(Keys& keys, QuadSettings& s, bool applies, const std::string& when)
{
    const auto only_there = [&](Keys::Said said) {
        if (!when.empty()) said.only_if(applies, when);
    };
    only_there(keys.word("quads", s.way, quad_ways,
                         "where quads come from: faces of the mesh, or squares of a polycube or a cube that it is "
                         "mapped to"));
    const auto with = [&](const std::string& way) { return when.empty() ? way : when + ", " + way; };
    const bool has_polycube = applies && s.way == QuadWay::polycube;
    keys.file("polycube", s.polycube, "the polycube: the mesh's faces with its vertices on cubes", "a mesh")
        .only_if(has_polycube, with("quads = polycube"));
    keys.number("cube_side", s.cube_side, {1e-9, 1e9}, "the side of the polycube's cubes")
        .unit("units of its file")
        .only_if(has_polycube, with("quads = polycube"));
    keys.integer("smooth", s.smooth, 0, 6, "steps of Catmull and Clark's subdivision, each of four quads out of one")
        .only_if(applies && s.way == QuadWay::faces, with("quads = faces"));
    only_there(keys.integer("refine", s.refine, 1, 256, "parts along each side of a quad, each of which has a tile"));
    if (keys.is_read() && has_polycube && s.polycube.empty())
        throw keys.problem(fmt::format("needs {}", keys.name_of("polycube")));
}

std::shared_ptr<const QuadSurface> quad_surface(const QuadSettings& settings)
{
    if (settings.read) return settings.read;
    try {
        QuadMesh mesh = settings.way == QuadWay::faces      ? quads_of_faces(settings)
                        : settings.way == QuadWay::polycube ? polycube_quads(settings)
                                                            : cube_quads(settings);
        QuadTopology topology(mesh);
        const std::size_t coarse = mesh.quads.size() / settings.refine / settings.refine;
        return std::make_shared<const QuadSurface>(QuadSurface{std::move(mesh), std::move(topology), coarse});
    } catch (const InputError& error) {
        if (!error.place().file.empty()) throw;
        throw error.moved_to({settings.mesh.string()});
    }
}

QuadTriangles triangles_of(const QuadMesh& mesh)
{
    QuadTriangles all{fans_of(mesh), {}, {}};
    all.surface = fixed_surface(all.mesh);
    all.number_of.assign(all.mesh.triangles.size(), UINT32_MAX);
    for (std::uint32_t t = 0; t < all.surface.faces.size(); ++t) all.number_of[all.surface.faces[t]] = t;
    return all;
}

SurfacePoint QuadTriangles::point(std::uint32_t quad, double u, double v) const
{
    const FanPlace at = fan_place(u, v);
    SurfacePoint point{};
    point.triangle = number_of[4 * std::size_t{quad} + at.side];
    if (point.triangle == UINT32_MAX) return point;
    point.shares[0] = static_cast<std::uint32_t>(std::ldexp(at.end, contract::surface::BARYCENTRIC_BITS));
    point.shares[1] = static_cast<std::uint32_t>(std::ldexp(at.middle, contract::surface::BARYCENTRIC_BITS));
    const MeshPlace place = place_on(surface.triangles[point.triangle], point.shares[0], point.shares[1]);
    for (std::size_t k = 0; k < 3; ++k) point.place[k] = static_cast<std::int32_t>(place[k]);
    return point;
}

StretchOfAll stretch_of_quads(const QuadTriangles& triangles)
{
    constexpr std::int64_t side = std::int64_t{1} << (tile_bits + step_bits);
    TexturePlane plane;
    for (std::uint32_t t = 0; t < triangles.surface.triangles.size(); ++t)
        plane.triangles.push_back({{{{0, 0}, {side, 0}, {side / 2, side / 2}}}, t});
    return stretch_of_all(triangles.surface, plane, stretches_of(triangles.surface, plane));
}

std::vector<DistributionNumber> quad_numbers(const QuadSurface& surface, const StretchOfAll& stretch)
{
    const auto number = [](auto count) { return static_cast<double>(count); };
    return {
        {"quads", "Quads", number(surface.mesh.quads.size()), fmt::format("of {} coarse ones", surface.coarse)},
        {"vertices", "Vertices", number(surface.topology.vertices()), "of quads"},
        {"irregular", "Irregular vertices", number(surface.topology.irregular()), "where other than four quads meet"},
        {"euler", "Vertices less edges plus quads", number(surface.topology.euler()), "2 for a sphere, 0 for a torus"},
        {"least_stretch", "Least stretch", stretch.extremes.least,
         "units of the mesh: what a side of a tile becomes where it is shortest"},
        {"greatest_stretch", "Greatest stretch", stretch.extremes.greatest,
         "units of the mesh: what a side of a tile becomes where it is longest"},
        {"area_distortion", "Area distortion", stretch.area_distortion,
         "the greatest area on the surface of an equal area of tiles, over the least"},
        {"mean_stretch", "Mean stretch", stretch.root_mean_square,
         "root mean square of lengths (L2 of Sander 2001): 1 where tiles keep all lengths but for one scale"}};
}

}
