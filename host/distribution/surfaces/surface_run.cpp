// kind = "surface": points on the triangles of a mesh, by dart throwing, by sample elimination, or by tiles
// over its texture coordinates.
//
// Cline et al., Dart throwing on surfaces, EGSR 2009; Yuksel, Sample elimination for generating Poisson disk sample
// sets, Computer Graphics Forum 34(2), 2015.
#include "base/errors/errors.hpp"
#include "base/images/png_file.hpp"
#include "base/points/point_file.hpp"
#include "base/programs/memory_limit.hpp"
#include "host/distribution/surfaces/relaxed_surface.hpp"
#include "host/distribution/surfaces/surface_density.hpp"
#include "host/distribution/surfaces/surface_files.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/distribution/surfaces/surface_view.hpp"
#include "host/distribution/surfaces/tiled_surface.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

/// Throws InputError if candidates of elimination have no room, where all pairs of near ones are in memory. Measured,
/// with a density: 0.67 kB for each of 600,000 candidates where there are 5 for a point, 2.3 kB where there are 30.
/// Along the surface they take half as much again.
void check_pair_memory(const MeshPointSettings& s)
{
    constexpr double gibibyte = 1 << 30;
    const bool is_along = s.metric == SurfaceMetric::surface;
    const double candidates = s.method == SurfaceMethod::elimination ? s.candidates : 1, // all darts stay
        points = s.points ? static_cast<double>(*s.points) : saturated_count(s.read->surface.area, *s.min_distance),
                 bytes = (is_along ? 1.5 : 1) * points * candidates * (192 + 72 * candidates);
    if (const auto most = static_cast<double>(memory_limit()); bytes > most)
        throw InputError(fmt::format("{:.0f}{} and {} need {:.1f} GiB of memory: must be at most {:.1f}", points,
                                     candidates > 1 ? fmt::format(" with {} candidates each", candidates) : " points",
                                     is_along ? "distances along the surface" : "a density", bytes / gibibyte,
                                     most / gibibyte));
}

/// Throws InputError if points that move have no room. Measured, of Lloyd's method: 1.8 kB for each of 200,000 points,
/// 0.5 kB for each of 800,000 triangles. The pieces that attract points by Gaussians have a place, a weight, a cell and
/// a piece each. Without a number of points they are as many as saturated sets have.
void check_moving_memory(const MeshPointSettings& s)
{
    constexpr double gibibyte = 1 << 30, saturated = 0.7; // points on the square of the minimum distance
    const FixedSurface& surface = s.read->surface;
    const double points = s.points ? static_cast<double>(*s.points)
                                   : saturated * surface.area / (*s.min_distance * *s.min_distance),
                 charges = s.method == SurfaceMethod::gaussian ? gaussian_charges(surface, points) : 0,
                 bytes = 1800 * points + 500 * static_cast<double>(surface.triangles.size()) + 100 * charges;
    if (const auto most = static_cast<double>(memory_limit()); bytes > most)
        throw InputError(fmt::format("{:.3g} points that {} moves on {} triangles need {:.1f} GiB of "
                                     "memory: must be at most {:.1f}",
                                     points,
                                     s.method == SurfaceMethod::lloyd ? "Lloyd's method" : "the method gaussian",
                                     surface.triangles.size(), bytes / gibibyte, most / gibibyte));
}

void check_tile_keys(Keys& keys, MeshPointSettings& s)
{
    for (const char* key : {"relative_radius", "factor", "candidates"})
        if (keys.is_given(key)) throw keys.invalid(key, "cannot be combined with " + keys.name_of("tiles"));
    if (!s.points && !s.tiles_per_unit)
        throw keys.problem(fmt::format("tiles need {} or {}", keys.name_of("points"), keys.name_of("tiles_per_unit")));
    if (!s.tiles.empty()) keys.check("tiles", [&] { s.read_tiles = surface_tiles(s, {}); });
    if (s.is_closed && (!s.tiles_per_unit || std::floor(*s.tiles_per_unit) != *s.tiles_per_unit))
        throw keys.invalid("closed", fmt::format("needs {}, a whole number", keys.name_of("tiles_per_unit")));
    keys.check("mesh", [&] {
        s.read = surface_mesh(s);
        check_texture(s, *s.read);
    });
    if (s.min_distance) keys.check("min_distance", [&] { surface_distance(s, *s.read); });
    keys.check(s.tiles_per_unit ? "tiles_per_unit" : "points", [&] { check_tiled_surface(s, *s.read); });
}

void check_quad_keys(Keys& keys, MeshPointSettings& s)
{
    for (const char* key : {"min_distance", "relative_radius", "factor", "faces"})
        if (keys.is_given(key))
            throw keys.invalid(key, fmt::format("cannot be combined with {} quads", keys.name_of("method")));
    if (!s.points) throw keys.problem(fmt::format("tiles on quads need {}", keys.name_of("points")));
    keys.check("mesh", [&] { s.read = surface_mesh(s); });
    keys.check("points", [&] { check_quad_points(*s.points, s.quads.read->mesh.quads.size()); });
}

void check_surface_keys(Keys& keys, MeshPointSettings& s)
{
    if (s.method == SurfaceMethod::quads) return check_quad_keys(keys, s);
    if (s.method == SurfaceMethod::tiles) return check_tile_keys(keys, s);
    if (s.method == SurfaceMethod::elimination && !s.points)
        throw keys.problem(fmt::format("elimination needs {}", keys.name_of("points")));
    if (!s.points && !s.min_distance)
        throw keys.problem(fmt::format("needs {} or {}", keys.name_of("points"), keys.name_of("min_distance")));
    if (s.relative_radius && !s.points) throw keys.invalid("relative_radius", "needs " + keys.name_of("points"));
    const bool shrinks = s.method != SurfaceMethod::elimination && s.points && !s.min_distance && !s.relative_radius;
    if (keys.is_given("factor") && !shrinks)
        throw keys.invalid("factor", fmt::format("needs darts with {} and neither {} nor {}", keys.name_of("points"),
                                                 keys.name_of("min_distance"), keys.name_of("relative_radius")));
    if (s.method == SurfaceMethod::elimination)
        for (const char* key : {"min_distance", "relative_radius"})
            if (keys.is_given(key))
                throw keys.invalid(key, fmt::format("elimination takes {} alone", keys.name_of("points")));
    if (s.method == SurfaceMethod::elimination && *s.points * s.candidates > static_cast<std::size_t>(max_points))
        throw keys.invalid("points",
                           fmt::format("times {} must be at most {}", keys.name_of("candidates"), max_points));
    keys.check("mesh", [&] { s.read = surface_mesh(s); });
    keys.check(s.min_distance ? "min_distance" : "points", [&] { surface_distance(s, *s.read); });
    if (moves_points(s.method)) keys.check(s.points ? "points" : "min_distance", [&] { check_moving_memory(s); });
    if (!s.density.empty()) {
        keys.check("points", [&] { check_pair_memory(s); });
        keys.check("density", [&] {
            SurfaceDensity density(s.density, s.density_from, s.read->mesh);
            density_candidates(s.read->surface, density, 1, stream_key(0, Purpose::surface_candidates, 0));
        });
    }
    if (s.metric == SurfaceMetric::surface) {
        for (const char* key : {"normal_angle", "density"})
            if (keys.is_given(key))
                throw keys.invalid(key, fmt::format("cannot be combined with {} surface", keys.name_of("distance")));
        s.normal_angle = 180;
        if (s.method == SurfaceMethod::elimination || s.order == SurfaceOrder::elimination)
            keys.check(s.points ? "points" : "min_distance", [&] { check_pair_memory(s); });
    }
    if (s.order == SurfaceOrder::elimination && keys.is_given("start"))
        throw keys.invalid("order", "cannot be combined with " + keys.name_of("start"));
    keys.check(keys.is_given("start") ? "start" : "obstacles", [&] { s.beginning = surface_beginning(s, *s.read); });
}

/// Points that a distance decides are only about so many: they are refused where they are sure to be too many. Through
/// space, points keep their distance from those of other sheets nearby, too, and obstacles take any part of the
/// surface.
void check_instances(const Keys& keys, const MeshPointSettings& s)
{
    const double sure = s.metric == SurfaceMetric::surface ? 0.95 : 0.25;
    if (s.points) return check_instance_count(keys, "points", s.instances, static_cast<double>(*s.points));
    if (!s.min_distance || !s.obstacles.empty()) return;
    const double count = saturated_count(s.read->surface.area, *s.min_distance);
    if (sure * count > static_cast<double>(most_surface_instances))
        check_instance_count(keys, "min_distance", s.instances, count);
}

void surface_keys(Keys& keys, MeshPointSettings& s)
{
    keys.file("mesh", s.mesh, "the surface: a file of polygons, .obj, .ply, .off, .stl, .gltf or .glb", "a mesh")
        .required();
    keys.word("method", s.method, surface_methods, "how points are made; tiles, where there are any");
    if (keys.is_given("tiles") && !keys.is_given("method")) s.method = SurfaceMethod::tiles;
    keys.integer("points", s.points, 1, max_points, "the number of points").otherwise("as many as there is room for");
    keys.number("min_distance", s.min_distance, {1e-100, 1e100},
                "the least distance of two points, as distance measures it")
        .unit("units of the mesh")
        .otherwise("one that shrinks until the points fit");
    keys.number("relative_radius", s.relative_radius, {0.001, 1},
                "of so many points: their distance over that of the densest packing of as many in a plane of the "
                "surface's area")
        .excludes("min_distance")
        .otherwise("none");
    keys.word("distance", s.metric, surface_metrics, surface_metric_help)
        .only_if(s.method == SurfaceMethod::darts || s.method == SurfaceMethod::elimination,
                 "method = darts or elimination");
    keys.number("normal_angle", s.normal_angle, {1, 180},
                "the largest angle between normals of points that keep a distance; 180: all do")
        .unit("degrees");
    keys.number("factor", s.factor, {0.5, 0.9999}, "what the distance is multiplied by where it shrinks");
    keys.integer("candidates", s.candidates, 1, 30, "random points to begin with, for each point that is kept")
        .only_if(s.method == SurfaceMethod::elimination, "method = elimination");
    keys.integer("iterations", s.iterations, 0, 1'000'000,
                 "the number of steps to centroids, or along the forces of Gaussians")
        .otherwise("50 of lloyd, 100 of gaussian")
        .only_if(moves_points(s.method), "method = lloyd or gaussian");
    keys.picture_or_formula("density", s.density, s.density_from,
                            "the density of the points: a formula in x, y and z in the mesh's units; the name of a "
                            "number of its vertices, such as red or quality; or a picture over its texture coordinates")
        .otherwise("none")
        .only_if(s.method == SurfaceMethod::elimination, "method = elimination");
    keys.flag(
        "faces", s.faces,
        "whether files of points (PLY, CSV) have the face, the barycentric coordinates, and the numbers that the mesh "
        "has at its vertices: normals, colours, texture coordinates and others");
    surface_model_keys(keys, s.instances, 1);
    keys.tiles(s.tiles);
    const bool has_tiles = s.method == SurfaceMethod::tiles;
    if (keys.is_given("tiles") && !has_tiles)
        throw keys.invalid(
            "tiles", fmt::format("cannot be combined with {} {}", keys.name_of("method"), surface_methods[s.method]));
    keys.file(
            "start", s.start,
            "points of the surface with which the set begins, and which stay: a file of points with three coordinates",
            "a point file")
        .otherwise("none")
        .only_if(s.method == SurfaceMethod::darts, "method = darts");
    keys.file("obstacles", s.obstacles,
              "points of the surface from which all others keep the minimum distance, and which do not belong to the "
              "set: a file of points with three coordinates",
              "a point file")
        .otherwise("none")
        .only_if(s.method == SurfaceMethod::darts, "method = darts");
    keys.word(
            "order", s.order, surface_orders,
            "the order of the points: that in which they are made, or one whose first parts, whatever their size, are "
            "well spread (Yuksel 2015)")
        .only_if(s.method == SurfaceMethod::darts, "method = darts");
    keys.number("tiles_per_unit", s.tiles_per_unit, {1e-6, 1e6},
                "how many tiles lie along a unit of the mesh's texture coordinates")
        .only_if(has_tiles, "method = tiles")
        .excludes("points")
        .otherwise("as many as have the points");
    keys.flag("closed", s.is_closed,
              "whether the tiling repeats after a unit of texture coordinates, so that a seam between 0 and 1 fits")
        .only_if(has_tiles, "method = tiles");
    const bool has_quads = s.method == SurfaceMethod::quads;
    s.quads.mesh = s.mesh;
    quad_keys(keys, s.quads, has_quads, "method = quads");
    keys.integer("colors", s.colors, 1, 16, "the number of colours of vertices of quads; more colours make more tiles")
        .only_if(has_quads, "method = quads");
    if (!keys.is_read()) return;
    if (has_quads) keys.check("mesh", [&] { s.quads.read = quad_surface(s.quads); });
    check_surface_keys(keys, s);
    read_surface_models(keys, s.instances, 1);
    check_instances(keys, s);
    for (const auto& file : files_beside_mesh(s.mesh)) keys.reads_too(file);
    for (const std::string& model : s.instances.names)
        for (const auto& file : files_beside_mesh(model)) keys.reads_too(file);
}

std::string surface_label(const MeshPointSettings& s)
{
    return fmt::format("Points on {}, {}", name_of_input(s.mesh.string()),
                       s.method == SurfaceMethod::tiles ? words_for_tiles(s) : std::string(surface_methods[s.method]));
}

DistributionResult make_surface(const MeshPointSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files)
{
    const SurfaceSet set = make_surface_set(settings, seed, place);
    const FixedSurface& surface = set.mesh->surface;
    DistributionResult result;
    result.facts = {fmt::format("{} points", set.points.size()), surface_fact(set, settings),
                    fmt::format("{} triangles", surface.triangles.size())};
    for (const std::string& note : set.mesh->notes()) result.facts.push_back(note);
    for (const std::string& note : set.notes) result.facts.push_back(note);
    write_png(files.add("points.png"), surface_view(surface, set.points, dots_of(set)));
    result.pictures.push_back(
        {"points.png", "The points on their surface: left from the front above, right from behind above."});
    write_surface_points(files.add("points.ply", result), surface, set.points, "",
                         settings.faces ? &set.mesh->mesh : nullptr);
    if (settings.instances.are_given())
        write_surface_instances(files.add("instances.glb", result), surface, set.points, {}, settings.instances, seed);
    write_points(files.add("points.npy", result), set.places());
    write_points(files.add("normals.npy", result), normals_of(surface, set.points));
    if (!settings.start.empty())
        result.facts.push_back(fmt::format("{} given points to begin with", settings.beginning->start.size()));
    if (!set.obstacles.empty()) result.facts.push_back(fmt::format("{} obstacles", set.obstacles.size()));
    result.numbers = surface_numbers(set, seed);
    return result;
}

}

Kind surface_point_kind()
{
    return make_kind<MeshPointSettings>({"distribution", "surface", "distribute surface", "Points on a surface",
                                         "Make points on the triangles of a mesh, even by distances through space"},
                                        surface_keys, surface_label, make_surface);
}

}
