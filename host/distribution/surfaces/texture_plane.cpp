#include "host/distribution/surfaces/texture_plane.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

__extension__ using Wide = __int128;

TexturePlace difference_of(const TexturePlace& to, const TexturePlace& from)
{
    return {to[0] - from[0], to[1] - from[1]};
}

/// Twice the area between two directions, with its sign.
Wide area_between(const TexturePlace& a, const TexturePlace& b) { return Wide{a[0]} * b[1] - Wide{a[1]} * b[0]; }

/// On which side of an edge a place lies, of which `area` is the area with the edge: 1 or -1. On the edge itself, that
/// of a place a bit to the right.
int side_of(Wide area, const TexturePlace& edge)
{
    if (area != 0) return area > 0 ? 1 : -1;
    if (edge[1] != 0) return edge[1] < 0 ? 1 : -1;
    return edge[0] > 0 ? 1 : -1;
}

/// Doubles round, and all triangles at a corner round it alike.
TexturePlace rounded_steps(const TexturePoint& point, double steps_per_unit)
{
    constexpr double most = farthest_tile * (1 << (tile_bits + step_bits));
    TexturePlace place{};
    for (std::size_t k = 0; k < 2; ++k) {
        const double steps = point[k] * steps_per_unit;
        if (!(std::abs(steps) < most))
            throw InputError(fmt::format("a texture coordinate is {:.6g}, {:.6g} tiles from 0: must be less than {}",
                                         point[k], std::abs(steps) / (1 << (tile_bits + step_bits)), farthest_tile));
        place[k] = std::llround(steps);
    }
    return place;
}

}

std::optional<std::array<std::uint32_t, 2>> TextureTriangle::shares_at(const TexturePlace& place) const
{
    const auto& [a, b, c] = corners;
    const TexturePlace from_a = difference_of(place, a);
    const TexturePlace ab = difference_of(b, a), bc = difference_of(c, b), ca = difference_of(a, c);
    const Wide whole = area_between(ab, bc);
    const Wide at_c = area_between(ab, from_a), at_b = area_between(ca, from_a), at_a = whole - at_b - at_c;
    const int side = whole > 0 ? 1 : -1;
    if (side_of(at_a, bc) != side || side_of(at_b, ca) != side || side_of(at_c, ab) != side) return {};
    const auto share = [&](Wide part) {
        return static_cast<std::uint32_t>((part * (Wide{1} << contract::surface::BARYCENTRIC_BITS)) / whole);
    };
    return std::array{share(at_b), share(at_c)};
}

double TextureTriangle::twice_area() const
{
    const auto& [a, b, c] = corners;
    return static_cast<double>(area_between(difference_of(b, a), difference_of(c, a)));
}

std::optional<std::array<TexturePoint, 3>> texture_of(const TriangleMesh& mesh, std::uint32_t number)
{
    if (mesh.texture_triangles.empty()) return {};
    std::array<TexturePoint, 3> points{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t point = mesh.texture_triangles[number][k];
        if (point == no_texture_point) return {};
        points[k] = mesh.texture_points[point];
    }
    return points;
}

TexturePlane texture_plane(const TriangleMesh& mesh, const FixedSurface& surface, double tiles_per_unit)
{
    TexturePlane plane;
    plane.tiles_per_unit = tiles_per_unit;
    const double steps_per_unit = tiles_per_unit * (1 << (tile_bits + step_bits));
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        const auto points = texture_of(mesh, surface.faces[t]);
        TextureTriangle triangle;
        triangle.triangle = t;
        for (std::size_t k = 0; points && k < 3; ++k) triangle.corners[k] = rounded_steps((*points)[k], steps_per_unit);
        const auto& [a, b, c] = triangle.corners;
        const bool has_area = points && area_between(difference_of(b, a), difference_of(c, a)) != 0;
        if (has_area) {
            plane.triangles.push_back(triangle);
            continue;
        }
        ++(points ? plane.without_area : plane.without_coordinates);
        plane.bare_area += surface.areas[t];
    }
    if (plane.triangles.empty()) throw InputError("no triangle has an area in texture coordinates");
    return plane;
}

double texture_area(const TriangleMesh& mesh, const FixedSurface& surface)
{
    double sum = 0;
    for (const std::uint32_t face : surface.faces)
        if (const auto points = texture_of(mesh, face)) {
            const auto& [a, b, c] = *points;
            sum += std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
        }
    return sum;
}

namespace {

double scalar_product(const MeshPoint& a, const MeshPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double area_of_product(const MeshPoint& a, const MeshPoint& b)
{
    return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

std::array<MeshPoint, 3> corners_in_space(const FixedSurface& surface, std::uint32_t triangle)
{
    std::array<MeshPoint, 3> places{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            places[i][k] = surface.triangles[triangle].corners[3 * i + k] * surface.unit;
    return places;
}

}

Stretch stretch_of(const std::array<MeshPoint, 3>& places, const TextureTriangle& triangle, double tiles_per_unit)
{
    const double steps = tiles_per_unit * (1 << (tile_bits + step_bits));
    const auto along = [&](std::size_t corner, std::size_t axis) {
        return static_cast<double>(triangle.corners[corner][axis] - triangle.corners[0][axis]) / steps;
    };
    const double qu = along(1, 0), qv = along(1, 1), ru = along(2, 0), rv = along(2, 1);
    const double twice_area = triangle.twice_area() / (steps * steps);
    MeshPoint pq{}, pr{}, along_u{}, along_v{};
    for (std::size_t k = 0; k < 3; ++k) {
        pq[k] = places[1][k] - places[0][k];
        pr[k] = places[2][k] - places[0][k];
        along_u[k] = (pq[k] * rv - pr[k] * qv) / twice_area;
        along_v[k] = (pr[k] * qu - pq[k] * ru) / twice_area;
    }
    const double a = scalar_product(along_u, along_u), b = scalar_product(along_u, along_v),
                 c = scalar_product(along_v, along_v);
    const double greatest = std::sqrt(((a + c) + std::hypot(a - c, 2 * b)) / 2);
    // The difference of nearly equal numbers would lose the least one.
    return {area_of_product(pq, pr) / std::abs(twice_area) / greatest, greatest};
}

std::vector<Stretch> stretches_of(const FixedSurface& surface, const TexturePlane& plane)
{
    std::vector<Stretch> each;
    each.reserve(plane.triangles.size());
    for (const TextureTriangle& t : plane.triangles)
        each.push_back(stretch_of(corners_in_space(surface, t.triangle), t, plane.tiles_per_unit));
    return each;
}

StretchOfAll stretch_of_all(const FixedSurface& surface, const TexturePlane& plane, const std::vector<Stretch>& each)
{
    StretchOfAll all{.extremes = {std::numeric_limits<double>::infinity(), 0}};
    double least_area = std::numeric_limits<double>::infinity(), greatest_area = 0;
    double area = 0, plane_area = 0, squares = 0;
    for (std::size_t t = 0; t < each.size(); ++t) {
        const auto [least, greatest] = each[t];
        const double own = surface.areas[plane.triangles[t].triangle];
        all.extremes = {std::min(all.extremes.least, least), std::max(all.extremes.greatest, greatest)};
        least_area = std::min(least_area, least * greatest);
        greatest_area = std::max(greatest_area, least * greatest);
        area += own;
        plane_area += own / (least * greatest);
        squares += own * (least * least + greatest * greatest) / 2;
    }
    all.area_distortion = greatest_area / least_area;
    all.root_mean_square = std::sqrt(squares * plane_area) / area;
    return all;
}

}
