#include "host/distribution/surfaces/tiled_quads.hpp"

#include "base/errors/errors.hpp"
#include "tiles/quads/quad_points.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// This part of the plane is in disks of the distance's diameter around saturated darts.
constexpr double covered = 0.547;

}

double quad_distance(std::size_t points, std::size_t quads)
{
    return std::sqrt(covered * 4 / std::numbers::pi * static_cast<double>(quads) / static_cast<double>(points));
}

void check_quad_points(std::size_t points, std::size_t quads)
{
    const double each = static_cast<double>(points) / static_cast<double>(quads);
    if (quad_distance(points, quads) <= most_quad_distance && each <= 65536) return;
    const double least = covered * 4 / std::numbers::pi / (most_quad_distance * most_quad_distance);
    throw InputError(fmt::format(
        "{:.4g} points on each of {} quads: tiles have {:.4g} to 65,536; fewer quads have more", each, quads, least));
}

std::shared_ptr<const SurfaceMesh> mesh_of_quads(const MeshPointSettings& settings)
{
    QuadTriangles triangles = triangles_of(quad_surface(settings.quads)->mesh);
    return std::make_shared<const SurfaceMesh>(SurfaceMesh{std::move(triangles.mesh), std::move(triangles.surface)});
}

SurfaceSet tiled_quads(const MeshPointSettings& settings, std::shared_ptr<const SurfaceMesh> mesh, std::uint64_t seed)
{
    const auto surface = quad_surface(settings.quads);
    const QuadSurface& quads = *surface;
    const QuadTriangles triangles = triangles_of(quads.mesh);
    const double distance = quad_distance(*settings.points, quads.mesh.quads.size());
    const QuadPoints laid = lay_quad_points(quads.mesh, quads.topology, {distance, settings.colors, seed});
    SurfaceSet set{.mesh = std::move(mesh), .points = {}, .angle = settings.normal_angle};
    for (const QuadPoint& p : laid.points) {
        const SurfacePoint point = triangles.point(p.quad, p.u, p.v);
        if (point.triangle != UINT32_MAX) set.points.push_back(point);
    }
    const StretchOfAll stretch = stretch_of_quads(triangles);
    set.of_method = quad_numbers(quads, stretch);
    const auto add = [&](const char* key, const char* title, std::size_t count, const char* words) {
        set.of_method.push_back({key, title, static_cast<double>(count), words});
    };
    add("tiles", "Tiles", laid.tiles, "that differ by more than a turn");
    add("tile_edges", "Edges of tiles", laid.edges, "that differ");
    add("tile_disks", "Disks around vertices", laid.disks, "that differ: of each valence, each colour");
    set.of_method.push_back({"tile_distance", "Distance of the tiles", distance,
                             "that all points keep along the quads, in sides of a tile: proven"});
    set.of_method.push_back(
        {"surface_distance", "Distance on the surface", distance * stretch.extremes.least,
         "that all points keep along the surface, in units of the mesh: proven; through space they may be "
         "nearer"});
    return set;
}

}
