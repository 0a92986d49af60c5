#include "host/distribution/surfaces/surface_set.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/torus.hpp"
#include "host/device/device_memory.hpp"
#include "host/distribution/surfaces/along_surface.hpp"
#include "host/distribution/surfaces/given_points.hpp"
#include "host/distribution/surfaces/relaxed_surface.hpp"
#include "host/distribution/surfaces/surface_density.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/distribution/surfaces/tiled_surface.hpp"
#include "host/sampling/surfaces/surface_elimination.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace poissonlab {
namespace {

/// Returns the distance with which darts begin that shrinks, over that at which as many saturate a plane of the same
/// area. Few points begin above it, as borders and curved surfaces have room for more. Many begin below it by three
/// standard deviations, so that they almost surely fit at once: a set that was saturated before its distance shrinks
/// has fewer points in the end, and takes as long again.
double first_part(std::size_t points)
{
    constexpr std::size_t many = 4096;
    return points < many ? 1.02 : 1 - 0.3 / std::sqrt(static_cast<double>(points));
}

/// Places at which it is looked whether a set leaves them uncovered.
constexpr std::uint64_t looked_at = 1 << 16;

std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

double diagonal_of(const FixedSurface& surface) { return surface.size * std::numbers::sqrt3; }

/// The distance of the densest packing of N points in a plane of that area.
double packed_distance(double area, std::size_t points)
{
    return std::sqrt(2 / std::numbers::sqrt3 * area / static_cast<double>(points));
}

/// Throws InputError where darts came to their end before there were enough.
void check_count(const SurfaceDarts& darts, const MeshPointSettings& settings)
{
    if (!settings.points || darts.points.size() >= *settings.points) return;
    const double share = std::sqrt(static_cast<double>(darts.points.size()) / static_cast<double>(*settings.points));
    std::string advice;
    if (!darts.points.empty() && settings.start.empty() && settings.obstacles.empty())
        advice = settings.min_distance ? fmt::format("; a minimum distance of about {:.4g} can be reached",
                                                     0.99 * share * *settings.min_distance)
                                       : fmt::format("; a relative radius of about {:.3f} can be reached",
                                                     0.99 * share * settings.relative_radius.value_or(0));
    throw InputError(fmt::format("the surface is saturated with {} of {} points: no further one fits{}",
                                 darts.points.size(), *settings.points, advice));
}

SurfaceDarts thrown_on(const SurfaceDartRequest& request, SurfaceMetric metric, const DistributionPlace& place)
{
    const auto tell = [&](std::size_t points) {
        if (place.on_step) place.on_step(fmt::format("{} points", points));
    };
    const auto most = static_cast<std::size_t>(max_points);
    if (metric == SurfaceMetric::surface) return throw_surface_darts(request, *path_dart_engine(request), most, tell);
    if (place.engine == Engine::reference)
        return throw_surface_darts(request, *reference::surface_dart_engine(request), most, tell);
    Device& device = place.device();
    const std::size_t expected =
        request.points > 0 ? request.points
                           : static_cast<std::size_t>(saturated_count(request.surface->area, request.min_distance));
    check_fits("dart throwing", surface_dart_memory(*request.surface, expected), device.info());
    return throw_surface_darts(request, *surface_dart_engine(request, device), most, tell);
}

/// New points are looked at once more, without what threw them. Given points may be nearer to each other.
void check_distances(const SurfaceDartRequest& request, const SurfaceDarts& darts, SurfaceMetric metric)
{
    std::vector<SurfacePoint> all = request.obstacles;
    all.insert(all.end(), darts.points.begin(), darts.points.end());
    const std::size_t given = request.obstacles.size() + request.start.size();
    if (!(metric == SurfaceMetric::surface
              ? keep_distance_along(*request.surface, all, darts.min_distance, given)
              : keep_distance(*request.surface, all, darts.min_distance, least_cosine(request.angle), given)))
        throw std::logic_error("darts are nearer to each other than they may be");
}

/// Returns `kept` of these points, in an order whose first parts are even.
std::vector<SurfacePoint> eliminated(const std::vector<SurfacePoint>& candidates, std::size_t kept,
                                     const MeshPointSettings& settings, const std::shared_ptr<const SurfaceMesh>& mesh,
                                     const DistributionPlace& place)
{
    const std::shared_ptr<const FixedSurface> surface{mesh, &mesh->surface};
    std::optional<SurfaceElimination> kernels;
    const bool is_along = settings.metric == SurfaceMetric::surface;
    if (place.engine == Engine::opencl && !is_along) {
        Device& device = place.device();
        check_fits("sample elimination", SurfaceElimination::memory(*surface, candidates.size()), device.info());
        kernels.emplace(device, surface);
    }
    const auto order = [&](const std::vector<SurfacePoint>& points, const SurfaceReach& reach, std::size_t removed) {
        if (place.on_step) place.on_step(fmt::format("{} of {} points go", removed, points.size()));
        if (is_along) return removal_order_along(*surface, points, reach, removed);
        return kernels ? kernels->removal_order(points, reach, removed)
                       : reference::surface_removal_order(*surface, points, reach, removed);
    };
    return eliminate_on_surface(*surface, candidates, kept, settings.normal_angle, order);
}

/// Returns the number of points of the start that are nearer to an obstacle than a distance.
std::size_t near_obstacles(const SurfaceBeginning& beginning, const FixedSurface& surface, double distance,
                           const MeshPointSettings& settings)
{
    if (settings.metric == SurfaceMetric::surface)
        return beginning.start.size() - uncovered_along(surface, beginning.obstacles, beginning.start, distance);
    const double units = surface.units_of(distance) * (1 - 0x1p-40);
    const SurfaceNeighbours near(surface, beginning.obstacles, static_cast<std::uint64_t>(units) + 1);
    const auto squared = static_cast<std::uint64_t>(units * units);
    return static_cast<std::size_t>(std::ranges::count_if(beginning.start, [&](const SurfacePoint& point) {
        return near.is_near(point, squared, least_cosine(settings.normal_angle));
    }));
}

SurfaceSet dart_set(const MeshPointSettings& settings, std::shared_ptr<const SurfaceMesh> mesh, std::uint64_t seed,
                    const DistributionPlace& place)
{
    const auto beginning = surface_beginning(settings, *mesh);
    const bool shrinks = settings.points && !settings.min_distance && !settings.relative_radius;
    const double distance = surface_distance(settings, *mesh);
    const SurfaceDartRequest request{.surface = {mesh, &mesh->surface},
                                     .min_distance = distance,
                                     .angle = settings.normal_angle,
                                     .points = settings.points.value_or(0),
                                     .shrinking = shrinks ? settings.factor : 1,
                                     .stream = stream_key(seed, Purpose::surface_darts, 0),
                                     .start = beginning->start,
                                     .obstacles = beginning->obstacles};
    SurfaceDarts darts = thrown_on(request, settings.metric, place);
    check_count(darts, settings);
    check_distances(request, darts, settings.metric);
    if (settings.order == SurfaceOrder::elimination)
        darts.points = eliminated(darts.points, darts.points.size(), settings, mesh, place);
    SurfaceSet set{std::move(mesh),
                   std::move(darts.points),
                   std::min(darts.min_distance, beginning->least),
                   settings.normal_angle,
                   darts.is_saturated,
                   darts.small_area,
                   darts.darts};
    set.dart_distance = darts.min_distance;
    set.metric = settings.metric;
    set.obstacles = beginning->obstacles;
    set.notes.insert(set.notes.end(), beginning->notes.begin(), beginning->notes.end());
    if (const std::size_t near = near_obstacles(*beginning, set.mesh->surface, darts.min_distance, settings); near > 0)
        set.notes.push_back(
            fmt::format("{} nearer to an obstacle than the {:.6g} that new points keep",
                        near == 1 ? "a point of the start is" : fmt::format("{} points of the start are", near),
                        darts.min_distance));
    if (beginning->least < darts.min_distance && set.points.size() > beginning->start.size())
        set.notes.push_back(
            fmt::format("two points of the start are {:.6g} apart, nearer than the {:.6g} that new points keep",
                        beginning->least, darts.min_distance));
    return set;
}

SurfaceSet eliminated_set(const MeshPointSettings& settings, std::shared_ptr<const SurfaceMesh> mesh,
                          std::uint64_t seed, const DistributionPlace& place)
{
    const std::size_t count = *settings.points * settings.candidates;
    if (!settings.density.empty()) {
        SurfaceDensity density(settings.density, settings.density_from, mesh->mesh);
        const auto random = density_candidates(mesh->surface, density, count,
                                               stream_key(seed, Purpose::surface_candidates, 0), place.on_step);
        SurfaceSet set{std::move(mesh), {}, 0, settings.normal_angle, false, 0, count};
        set.points = eliminate_by_density(set.mesh->surface, random, *settings.points, settings.normal_angle);
        set.follows_density = true;
        if (random.larger > 0)
            set.notes.push_back(fmt::format("the density is larger at {} of {} places than the largest value that was "
                                            "looked for: peaks are flattened",
                                            random.larger, random.darts));
        if (random.larger_corners > 0)
            set.notes.push_back(fmt::format("the density is more than a tenth larger at {} of {} corners of triangles "
                                            "than the largest value that was looked for: peaks are flattened",
                                            random.larger_corners, 3 * set.mesh->surface.triangles.size()));
        return set;
    }
    const auto candidates = surface_candidates(mesh->surface, count, stream_key(seed, Purpose::surface_candidates, 0));
    auto points = eliminated(candidates, *settings.points, settings, mesh, place);
    SurfaceSet set{std::move(mesh), std::move(points), 0, settings.normal_angle, false, 0, count};
    set.metric = settings.metric;
    return set;
}

SurfaceSet moved_set(const MeshPointSettings& settings, std::shared_ptr<const SurfaceMesh> mesh, std::uint64_t seed,
                     const DistributionPlace& place)
{
    const SurfaceSet darts = dart_set(settings, std::move(mesh), seed, place);
    const auto tell = [&](std::size_t steps) {
        if (place.on_step) place.on_step(fmt::format("{} steps of {} points", steps, darts.points.size()));
    };
    const bool is_lloyd = settings.method == SurfaceMethod::lloyd;
    RelaxedSurface moved = is_lloyd ? relax_on_surface(darts.mesh->surface, darts.points, settings, tell)
                                    : descend_on_surface(darts.mesh->surface, darts.points, settings, tell);
    SurfaceSet set{.mesh = darts.mesh, .points = std::move(moved.points), .angle = settings.normal_angle};
    set.of_method = {
        {"iterations", "Iterations", static_cast<double>(moved.energies.size() - 1), "steps that all points made"},
        {"energy_before", "Energy before", moved.energies.front(), "of the darts with which it begins"},
        {"energy", "Energy", moved.energies.back(),
         is_lloyd ? "the mean squared distance of places from their nearest point, over that of a triangular lattice "
                    "in a plane of the same area"
                  : "the mean of the Gaussians of all points, less those of the surface; random points have 1"}};
    return set;
}

/// The part of the surface that is not nearer than a distance to any point, from uniform places: the distance of darts,
/// or the least one of the set.
DistributionNumber uncovered_part(const SurfaceSet& set, double least, std::uint64_t seed)
{
    const FixedSurface& surface = set.mesh->surface;
    const double kept = std::max(set.dart_distance, set.min_distance), distance = kept > 0 ? kept : least;
    const double units = surface.units_of(distance);
    std::vector<SurfacePoint> all = set.points;
    all.insert(all.end(), set.obstacles.begin(), set.obstacles.end());
    const auto places = surface_candidates(surface, looked_at, stream_key(seed, Purpose::surface_coverage, 0));
    std::uint64_t uncovered = 0;
    if (set.metric == SurfaceMetric::surface) {
        uncovered = uncovered_along(surface, all, places, distance);
    } else {
        const SurfaceNeighbours near(surface, all, static_cast<std::uint64_t>(units) + 1);
        for (const SurfacePoint& spot : places)
            uncovered += !near.is_near(spot, squared_threshold(units * 0x1p-32), least_cosine(set.angle));
    }
    const double part = static_cast<double>(uncovered) / looked_at;
    return {"uncovered", "Uncovered part", part,
            fmt::format("of the surface: no point is nearer than the {}; from {} places",
                        kept == 0                 ? "least distance"
                        : kept > set.min_distance ? "distance that new points keep"
                                                  : "minimum distance",
                        looked_at),
            std::sqrt(std::max(part, 1.0 / looked_at) * (1 - part) / looked_at)};
}

}

std::vector<std::string> SurfaceMesh::notes() const
{
    std::vector<std::string> notes = mesh.notes;
    if (mesh.divided > 0)
        notes.push_back(counted(mesh.divided, "face", "faces") + " of more than three corners became triangles");
    if (const std::size_t dropped = surface.flat + mesh.dropped; dropped > 0)
        notes.push_back(counted(dropped, "face", "faces") + " without an area, or that no triangles fill, " +
                        (dropped == 1 ? "was" : "were") + " left out");
    if (surface.open_edges > 0)
        notes.push_back("the surface is open: " + counted(surface.open_edges, "edge has a face", "edges have faces") +
                        " on one side only, and beyond it no points keep others away");
    return notes;
}

std::shared_ptr<const SurfaceMesh> surface_mesh(const MeshPointSettings& settings)
{
    if (settings.read) return settings.read;
    if (settings.method == SurfaceMethod::quads) return mesh_of_quads(settings);
    const MeshParts parts = settings.faces || !settings.density.empty() ? MeshParts::all
                            : settings.method == SurfaceMethod::tiles   ? MeshParts::faces_and_texture
                                                                        : MeshParts::faces;
    SurfaceMesh read{read_triangle_mesh(settings.mesh, parts), {}};
    try {
        read.surface = fixed_surface(read.mesh);
    } catch (const InputError& error) {
        throw error.moved_to({settings.mesh.string()});
    }
    return std::make_shared<const SurfaceMesh>(std::move(read));
}

double surface_distance(const MeshPointSettings& settings, const SurfaceMesh& mesh)
{
    const FixedSurface& surface = mesh.surface;
    const bool is_along = settings.metric == SurfaceMetric::surface;
    const double least = least_part_of_size * surface.size,
                 most = is_along ? measured_units * surface.unit : diagonal_of(surface);
    double distance = settings.min_distance.value_or(0);
    if (is_along && distance > most)
        throw InputError(fmt::format("{:.6g} is more than can be measured along this mesh, {:.6g}", distance, most));
    if (distance > most)
        throw InputError(fmt::format("{:.6g} is more than the mesh is wide, {:.6g} from corner to corner of the box "
                                     "around it: there is room for one point",
                                     distance, most));
    if (!settings.min_distance)
        distance = settings.relative_radius
                       ? *settings.relative_radius * packed_distance(surface.area, *settings.points)
                       : first_part(*settings.points) *
                             std::sqrt(saturated_count(surface.area, 1) / static_cast<double>(*settings.points));
    if (distance < least)
        throw InputError(
            fmt::format("a distance of {:.4g} is too small for a mesh of this size: at least {:.4g}", distance, least));
    const bool is_filled = settings.method == SurfaceMethod::darts && !settings.points;
    if (const double count = saturated_count(surface.area, distance); is_filled && count > max_points)
        throw InputError(fmt::format("there would be some {:.3g} points; at most {} are possible", count, max_points));
    return std::min(distance, most);
}

SurfaceSet make_surface_set(const MeshPointSettings& settings, std::uint64_t seed, const DistributionPlace& place)
{
    if (settings.method == SurfaceMethod::tiles) return tiled_surface(settings, surface_mesh(settings), seed, place);
    if (settings.method == SurfaceMethod::quads) return tiled_quads(settings, surface_mesh(settings), seed);
    if (moves_points(settings.method)) return moved_set(settings, surface_mesh(settings), seed, place);
    return settings.method == SurfaceMethod::darts ? dart_set(settings, surface_mesh(settings), seed, place)
                                                   : eliminated_set(settings, surface_mesh(settings), seed, place);
}

std::string surface_fact(const SurfaceSet& set, const MeshPointSettings& settings)
{
    if (set.tiling)
        return fmt::format("{}, {:.6g} a unit of texture coordinates", words_for_tiles(settings),
                           set.tiling->tiles_per_unit);
    if (settings.method == SurfaceMethod::quads) return "tiles on quads";
    if (settings.method == SurfaceMethod::elimination) return "sample elimination";
    if (settings.method == SurfaceMethod::lloyd) return "Lloyd relaxation";
    if (settings.method == SurfaceMethod::gaussian) return "Gaussian blue noise";
    if (set.is_saturated && !settings.points) return "saturated: no further point fits";
    return settings.min_distance || settings.relative_radius ? "stopped at that number"
                                                             : "the distance shrank until so many fitted";
}

SurfaceDots dots_of(const SurfaceSet& set)
{
    const double spacing = std::sqrt(set.mesh->surface.area / static_cast<double>(set.points.size()));
    const double kept = std::max(set.dart_distance, set.min_distance);
    return {kept > 0 ? kept : spacing, set.mesh->surface.open_edges == 0};
}

std::vector<DistributionNumber> surface_numbers(const SurfaceSet& set, std::uint64_t seed)
{
    const FixedSurface& surface = set.mesh->surface;
    std::vector<DistributionNumber> numbers;
    numbers.push_back({"points", "Points", static_cast<double>(set.points.size()), "on the surface"});
    numbers.push_back({"area", "Area", surface.area, "of the surface, in squares of its units"});
    if (set.min_distance > 0)
        numbers.push_back({"min_distance", "Minimum distance", set.min_distance,
                           set.metric == SurfaceMetric::surface ? "that points are sure to keep along the surface"
                           : set.angle < 180
                               ? "that points whose normals are near enough are sure to keep, straight through space"
                               : "that points are sure to keep, straight through space"});
    if (set.darts > 0)
        numbers.push_back({"darts", "Darts", static_cast<double>(set.darts), "random points of which these are"});
    if (set.tiling) std::ranges::copy(tiling_numbers(set), std::back_inserter(numbers));
    std::ranges::copy(set.of_method, std::back_inserter(numbers));
    if (set.points.size() < 2) return numbers;
    const bool is_along = set.metric == SurfaceMetric::surface;
    SurfaceDistances found = surface_distances(surface, set.points, least_cosine(set.angle),
                                               set.tiling ? set.tiling->covered_area : surface.area);
    if (is_along) {
        const PathDistances along = distances_along(surface, set.points);
        found.least = along.least;
        found.mean_nearest = along.mean_nearest;
    }
    if (!std::isfinite(found.least)) return numbers;
    numbers.push_back({"least_distance", "Least distance", found.least,
                       is_along          ? "of two points, along the surface, in units of the mesh"
                       : set.angle < 180 ? "of two points whose normals are near enough, in units of the mesh"
                                         : "of two points, in units of the mesh"});
    if (is_along)
        numbers.push_back({"least_of_any", "Least distance in space", found.least_of_any,
                           "of two points, straight through space, in units of the mesh"});
    else if (set.angle < 180)
        numbers.push_back({"least_of_any", "Least distance of any two", found.least_of_any,
                           "also of points whose normals are too far apart, such as those on two sides of a sheet"});
    numbers.push_back({"mean_nearest", "Mean nearest distance", found.mean_nearest, "in units of the mesh"});
    if (set.follows_density) return numbers; // no single distance measures the evenness of such a set
    numbers.push_back(
        {"relative_radius", "Relative radius", found.least / packed_distance(surface.area, set.points.size()),
         "least distance over that of the densest packing of as many points in a plane of the same area"});
    if (set.is_saturated)
        numbers.push_back({"uncovered", "Uncovered part", set.small_area / surface.area,
                           "of the surface, at most: proven, piece by piece"});
    else if (!set.tiling) // of which a seam may have two points at nearly one place
        numbers.push_back(uncovered_part(set, found.least, seed));
    return numbers;
}

}
