#include "host/sampling/surfaces/fixed_surface.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace poissonlab {
namespace {

__extension__ using Wide = __int128;

/// Sizes beyond these have squares of lengths that doubles have not.
constexpr double least_size = 1e-100, most_size = 1e100;

struct MeshBox
{
    MeshPoint low, high;
};

MeshBox box_of(const TriangleMesh& mesh)
{
    MeshBox box;
    box.low.fill(INFINITY);
    box.high.fill(-INFINITY);
    for (const MeshTriangle& t : mesh.triangles)
        for (const std::uint32_t corner : t)
            for (std::size_t k = 0; k < 3; ++k) {
                box.low[k] = std::min(box.low[k], mesh.vertices[corner][k]);
                box.high[k] = std::max(box.high[k], mesh.vertices[corner][k]);
            }
    return box;
}

/// The exact vector product of two edges of a triangle: twice its area long.
std::array<double, 3> product_of_edges(const SurfaceTriangle& t)
{
    const auto edge = [&](int corner, int k) { return Wide{t.corners[3 * corner + k]} - t.corners[k]; };
    std::array<double, 3> product{};
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        product[static_cast<std::size_t>(k)] = static_cast<double>(edge(1, i) * edge(2, j) - edge(1, j) * edge(2, i));
    }
    return product;
}

std::array<std::int32_t, 3> rounded_place(const FixedSurface& surface, const MeshPoint& place)
{
    std::array<std::int32_t, 3> rounded{};
    for (std::size_t k = 0; k < 3; ++k)
        rounded[k] = static_cast<std::int32_t>(std::floor((place[k] - surface.origin[k]) / surface.unit + 0.5));
    return rounded;
}

std::size_t count_open_edges(const TriangleMesh& mesh, const FixedSurface& surface)
{
    std::map<std::array<std::int32_t, 3>, std::uint32_t> first_at;
    std::vector<std::uint32_t> names(mesh.vertices.size());
    std::vector<std::array<std::uint32_t, 2>> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const MeshTriangle& t : mesh.triangles) {
        for (const std::uint32_t corner : t)
            names[corner] = first_at.try_emplace(rounded_place(surface, mesh.vertices[corner]), corner).first->second;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(names[t[k]], names[t[(k + 1) % 3]]);
            if (low != high) edges.push_back({low, high});
        }
    }
    std::ranges::sort(edges);
    std::size_t open = 0;
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        next = i + 1;
        while (next < edges.size() && edges[next] == edges[i]) ++next;
        if (next - i == 1) ++open;
    }
    return open;
}

void add_triangle(FixedSurface& surface, const TriangleMesh& mesh, std::uint32_t face)
{
    SurfaceTriangle t{};
    for (std::size_t i = 0; i < 3; ++i)
        std::ranges::copy(rounded_place(surface, mesh.vertices[mesh.triangles[face][i]]), t.corners + 3 * i);
    const auto [x, y, z] = product_of_edges(t);
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length == 0) {
        ++surface.flat;
        return;
    }
    const double scale = 1 << contract::surface::NORMAL_BITS;
    t.normal[0] = static_cast<std::int32_t>(std::floor(x / length * scale + 0.5));
    t.normal[1] = static_cast<std::int32_t>(std::floor(y / length * scale + 0.5));
    t.normal[2] = static_cast<std::int32_t>(std::floor(z / length * scale + 0.5));
    surface.triangles.push_back(t);
    surface.faces.push_back(face);
    surface.areas.push_back(length / 2 * surface.unit * surface.unit);
    surface.area += surface.areas.back();
}

}

FixedSurface fixed_surface(const TriangleMesh& mesh)
{
    if (mesh.triangles.empty()) throw InputError("the mesh has no triangles");
    const MeshBox box = box_of(mesh);
    FixedSurface surface;
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        surface.size = std::max(surface.size, box.high[k] - box.low[k]);
        farthest = std::max({farthest, std::abs(box.low[k]), std::abs(box.high[k])});
    }
    if (!(surface.size >= least_size && surface.size <= most_size))
        throw InputError(
            fmt::format("the mesh is {} wide: must be from {} to {}", surface.size, least_size, most_size));
    // The surface fits with a unit to spare at either end.
    int exponent = 0;
    std::frexp(surface.size * (1 + 0x1p-20), &exponent);
    surface.unit = std::ldexp(1, exponent - contract::surface::COORDINATE_BITS);
    if (farthest / surface.unit > 0x1p52)
        throw InputError(fmt::format("the mesh is {} wide and lies up to {} away from 0, where numbers do not tell its "
                                     "places apart: move it nearer",
                                     surface.size, farthest));
    for (std::size_t k = 0; k < 3; ++k) surface.origin[k] = std::floor(box.low[k] / surface.unit) * surface.unit;
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) add_triangle(surface, mesh, face);
    if (surface.triangles.empty()) throw InputError("the mesh has no area: its corners lie on lines");
    surface.open_edges = count_open_edges(mesh, surface);
    return surface;
}

MeshPlace place_on(const SurfaceTriangle& triangle, std::uint32_t share_1, std::uint32_t share_2)
{
    using namespace contract::surface;
    MeshPlace place;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t origin = triangle.corners[k];
        const std::int64_t sum =
            (triangle.corners[3 + k] - origin) * share_1 + (triangle.corners[6 + k] - origin) * share_2;
        place[k] = origin + ((sum + (std::int64_t{1} << (BARYCENTRIC_BITS - 1))) >> BARYCENTRIC_BITS);
    }
    return place;
}

MeshPlace place_of(const SurfacePoint& point) { return {point.place[0], point.place[1], point.place[2]}; }

std::uint64_t squared_distance(const MeshPlace& a, const MeshPlace& b)
{
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += static_cast<std::uint64_t>((a[k] - b[k]) * (a[k] - b[k]));
    return sum;
}

std::int32_t cosine_between(const SurfaceTriangle& a, const SurfaceTriangle& b)
{
    return a.normal[0] * b.normal[0] + a.normal[1] * b.normal[1] + a.normal[2] * b.normal[2];
}

std::int32_t least_cosine(double degrees)
{
    if (degrees >= 180) return std::numeric_limits<std::int32_t>::min();
    return static_cast<std::int32_t>(
        std::floor(std::cos(degrees * std::numbers::pi / 180) * (1 << 2 * contract::surface::NORMAL_BITS)));
}

PointSet points_of(const FixedSurface& surface, const std::vector<SurfacePoint>& points)
{
    PointSet set{3, {}};
    set.coordinates.reserve(3 * points.size());
    for (const SurfacePoint& point : points)
        for (std::size_t k = 0; k < 3; ++k)
            set.coordinates.push_back(surface.origin[k] + point.place[k] * surface.unit);
    return set;
}

MeshPoint normal_of(const SurfaceTriangle& triangle)
{
    const double x = triangle.normal[0], y = triangle.normal[1], z = triangle.normal[2];
    const double length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length};
}

}
