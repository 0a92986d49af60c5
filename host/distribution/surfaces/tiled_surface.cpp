#include "host/distribution/surfaces/tiled_surface.hpp"

#include "base/errors/errors.hpp"
#include "host/distribution/object_tiles.hpp"
#include "host/distribution/surfaces/laid_tiles.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/distribution/surfaces/texture_seams.hpp"
#include "host/settings/keys/keys.hpp"
#include "host/settings/sampler_table.hpp"
#include "host/tile_points/tiled_region.hpp"
#include "tiles/quads/quad_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace poissonlab {
namespace {

/// The number of tiles a unit that settings ask for: where they ask for points, the one with as many, or nearly.
double tiles_per_unit_of(const MeshPointSettings& settings, const SurfaceMesh& mesh, const PoissonTileSet& tiles,
                         const PoissonTiling& tiling, const DistributionPlace& place)
{
    if (settings.tiles_per_unit) return *settings.tiles_per_unit;
    const double points_per_area = static_cast<double>(*settings.points) / texture_area(mesh.mesh, mesh.surface);
    const auto points_at = [&](double width) {
        const std::uint64_t count = count_laid_points(texture_plane(mesh.mesh, mesh.surface, 1 / width), tiles, tiling);
        if (place.on_step) place.on_step(fmt::format("{:.4g} tiles a unit: {} points", 1 / width, count));
        return count;
    };
    return 1 / tile_width_for_points(*settings.points, std::sqrt(tiles.parameters.points_per_tile / points_per_area),
                                     points_at);
}

std::string of_faces(std::size_t count, const FixedSurface& surface)
{
    return fmt::format("{} of {} faces", count, surface.triangles.size());
}

/// Returns a line for each thing that texture coordinates lack.
std::vector<std::string> notes_on(const FixedSurface& surface, const TexturePlane& plane, const LaidPoints& laid)
{
    std::vector<std::string> notes;
    if (plane.without_coordinates + plane.without_area > 0)
        notes.push_back(fmt::format(
            "{} have no texture coordinates, {} no area in them: {:.3g} % of the surface has no points",
            of_faces(plane.without_coordinates, surface), plane.without_area, 100 * plane.bare_area / surface.area));
    if (laid.repetitions > 0)
        notes.push_back(fmt::format("texture coordinates overlap: {} of {} points repeat others of the tiling on other "
                                    "faces",
                                    laid.repetitions, laid.points.size()));
    return notes;
}

/// Leaves points out until all that see each other keep a distance.
void leave_near_points_out(LaidPoints& laid, const FixedSurface& surface, double distance, std::int32_t least_cosine)
{
    std::vector<std::uint32_t> order(laid.points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return laid.levels[i]; });
    const std::vector<bool> kept = kept_in_order(surface, laid.points, order, distance, least_cosine);
    std::size_t count = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (!kept[i]) continue;
        laid.points[count] = laid.points[i];
        laid.texture[count++] = laid.texture[i];
    }
    laid.points.resize(count);
    laid.texture.resize(count);
    if (!keep_distance(surface, laid.points, distance, least_cosine))
        throw std::logic_error("points that were left are nearer to each other than they may be");
}

double proven_in_tiles(const PoissonTileSet& tiles)
{
    return std::sqrt(static_cast<double>(tiles.squared_min_distance)) / tile_units;
}

}

std::shared_ptr<const PoissonTileSet> surface_tiles(const MeshPointSettings& settings, const DistributionPlace& place)
{
    if (settings.read_tiles) return settings.read_tiles;
    return std::make_shared<const PoissonTileSet>(object_tile_set(settings.tiles, 2, place));
}

std::string words_for_tiles(const MeshPointSettings& settings)
{
    return settings.tiles.empty() ? "corner tiles" : "tiles of " + name_of_input(settings.tiles.string());
}

void check_texture(const MeshPointSettings& settings, const SurfaceMesh& mesh)
{
    const auto fail = [&](const char* problem) { throw InputError::at({settings.mesh.string()}, problem); };
    if (mesh.mesh.texture_triangles.empty())
        fail("has no texture coordinates, over which tiles are laid: vt of OBJ, s and t, u and v or texture_u and "
             "texture_v of the vertices of PLY, TEXCOORD_0 of glTF");
    if (texture_area(mesh.mesh, mesh.surface) == 0) fail("no triangle has an area in texture coordinates");
}

void check_tiled_surface(const MeshPointSettings& settings, const SurfaceMesh& mesh)
{
    const double area = texture_area(mesh.mesh, mesh.surface),
                 points_per_tile =
                     settings.read_tiles ? settings.read_tiles->parameters.points_per_tile : points_per_default_tile;
    const double per_unit = settings.tiles_per_unit
                                ? *settings.tiles_per_unit
                                : std::sqrt(static_cast<double>(*settings.points) / points_per_tile / area);
    texture_plane(mesh.mesh, mesh.surface, per_unit);
    if (const double count = area * per_unit * per_unit * points_per_tile; count > max_points)
        throw InputError(fmt::format("there would be some {:.3g} points; at most {} are possible", count, max_points));
}

SurfaceSet tiled_surface(const MeshPointSettings& settings, std::shared_ptr<const SurfaceMesh> mesh, std::uint64_t seed,
                         const DistributionPlace& place)
{
    const FixedSurface& surface = mesh->surface;
    const auto read_tiles = surface_tiles(settings, place);
    const PoissonTileSet& tiles = *read_tiles;
    // This is the tiling that `tiles points` has.
    const PoissonTiling plane_tiling{static_cast<std::uint32_t>(seed),
                                     settings.is_closed ? static_cast<std::int32_t>(settings.tiles_per_unit.value_or(0))
                                                        : 0};
    auto tiling = std::make_shared<SurfaceTiling>();
    tiling->tiles_per_unit = tiles_per_unit_of(settings, *mesh, tiles, plane_tiling, place);
    tiling->tile_distance = proven_in_tiles(tiles) / tiling->tiles_per_unit;
    const TexturePlane plane = texture_plane(mesh->mesh, surface, tiling->tiles_per_unit);
    LaidPoints laid = lay_tiles(surface, plane, tiles, plane_tiling);
    if (laid.points.empty()) throw InputError("no point of the tiling lies on the surface: it needs more tiles");
    tiling->laid = laid.points.size();
    tiling->repetitions = laid.repetitions;
    tiling->covered_area = surface.area - plane.bare_area;
    auto notes = notes_on(surface, plane, laid);
    if (settings.points && tiling->laid != *settings.points)
        notes.push_back(fmt::format("{} points: no size of tiles has exactly {}", tiling->laid, *settings.points));
    const std::int32_t cosine = least_cosine(settings.normal_angle);
    if (settings.min_distance) leave_near_points_out(laid, surface, *settings.min_distance, cosine);

    const std::vector<Stretch> stretch = stretches_of(surface, plane);
    tiling->stretch = stretch_of_all(surface, plane, stretch);
    const Charts charts = charts_of(mesh->mesh, surface, plane);
    tiling->charts = charts.count;
    const SeamDistances seams = seam_distances(surface, plane, stretch, charts, laid.points, laid.texture, cosine);
    tiling->least_without_seams = seams.least;
    tiling->broken = seams.broken;
    return {.mesh = std::move(mesh),
            .points = std::move(laid.points),
            .min_distance = settings.min_distance.value_or(0),
            .angle = settings.normal_angle,
            .tiling = std::move(tiling),
            .notes = std::move(notes)};
}

std::vector<DistributionNumber> tiling_numbers(const SurfaceSet& set)
{
    const SurfaceTiling& tiling = *set.tiling;
    std::vector<DistributionNumber> numbers;
    numbers.push_back(
        {"tiles_per_unit", "Tiles a unit", tiling.tiles_per_unit, "of texture coordinates, along each axis"});
    if (set.min_distance > 0)
        numbers.push_back({"laid_points", "Points of the tiling", static_cast<double>(tiling.laid),
                           "on the surface, of which those were left out that were too near to others"});
    const auto [least, greatest] = tiling.stretch.extremes;
    numbers.push_back({"least_stretch", "Least stretch", least,
                       "units of the mesh: what a unit of texture coordinates becomes where it is shortest"});
    numbers.push_back({"greatest_stretch", "Greatest stretch", greatest,
                       "units of the mesh: what a unit of texture coordinates becomes where it is longest"});
    numbers.push_back({"area_distortion", "Area distortion", tiling.stretch.area_distortion,
                       "the greatest area on the surface of an equal area of texture coordinates, over the least"});
    numbers.push_back(
        {"mean_stretch", "Mean stretch", tiling.stretch.root_mean_square,
         "root mean square of lengths (L2 of Sander 2001): 1 where texture coordinates keep all lengths but "
         "for one scale"});
    if (tiling.tile_distance > 0) {
        numbers.push_back({"tile_distance", "Distance of the tiles", tiling.tile_distance,
                           "that all points of the tiling keep, in units of texture coordinates: proven"});
        // Two repetitions of a point may be joined by a way that turns back at a fold.
        if (tiling.repetitions == 0)
            numbers.push_back({"surface_distance", "Distance on the surface", least * tiling.tile_distance,
                               "that points of the tiling keep along the surface within a chart: proven, in units of "
                               "the mesh; through space they may be nearer"});
    }
    numbers.push_back({"charts", "Charts", static_cast<double>(tiling.charts),
                       "parts of the surface whose texture coordinates hang together"});
    if (!tiling.least_without_seams) return numbers;
    numbers.push_back({"least_without_seams", "Least distance without seams", *tiling.least_without_seams,
                       "of two points whose normals are near enough, with no seam of charts between them, in units of "
                       "the mesh"});
    numbers.push_back({"broken_by_seams", "Points broken by seams",
                       static_cast<double>(tiling.broken) / static_cast<double>(set.points.size()),
                       "the part of the points that are nearer than that to one beyond a seam"});
    return numbers;
}

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
