#include "host/distribution/surfaces/texture_stretch.hpp"

#include "tiles/poisson/tile_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
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
