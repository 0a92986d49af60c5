#include "host/distribution/surface_classes/surface_class_set.hpp"

#include "base/errors/errors.hpp"
#include "host/device/device_memory.hpp"
#include "host/distribution/surface_classes/path_class_darts.hpp"
#include "host/distribution/surfaces/along_surface.hpp"
#include "host/distribution/surfaces/surface_density.hpp"
#include "host/distribution/surfaces/surface_pairs.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace poissonlab {
namespace {

/// Darts of classes on meshes have this attempt of random numbers, so that no other darts have the same ones.
constexpr std::uint32_t surface_attempt = 0x6d657368;

/// The distance of the densest packing of N points in a plane of that area.
double packed_distance_in(double area, std::size_t points)
{
    return std::sqrt(2 / std::numbers::sqrt3 * area / static_cast<double>(points));
}

/// No distance is larger than the diagonal of the mesh's box, or along the surface than what can be measured.
double largest_distance(const FixedSurface& surface, SurfaceMetric metric)
{
    return metric == SurfaceMetric::surface ? measured_units * surface.unit : surface.size * std::numbers::sqrt3;
}

/// Reads the density of each class, and where the densities are densest.
void read_densities(const SurfaceClassSettings& settings, SurfaceClassWork& work, std::vector<double>& fullness)
{
    const ClassSettings& classes = settings.classes;
    if (classes.densities.empty()) return;
    const std::vector<SurfacePiece> pieces = small_pieces(work.mesh->surface);
    for (std::size_t i = 0; i < classes.densities.size(); ++i) {
        const std::vector<std::string>& from = classes.densities_from;
        try {
            const auto density = std::make_shared<SurfaceDensity>(
                classes.densities[i], from.empty() ? "light" : from[std::min(i, from.size() - 1)], work.mesh->mesh);
            work.request.densities.push_back(
                [density, mesh = work.mesh](const SurfacePoint& at) { return density->at(mesh->surface, at); });
            const WeightedPieces weighted = weighted_pieces(work.mesh->surface, pieces, work.request.densities.back());
            if (weighted.pieces.empty()) throw InputError(density->name() + ": is 0 everywhere on the mesh, or nearly");
            fullness[i] = weighted.fullness;
        } catch (const InputError& error) {
            throw SurfaceDensityError(error.what());
        }
    }
}

/// Throws InputError where distances or the numbers of points do not suit the surface.
void check_room(const SurfaceClassWork& work, SurfaceMetric metric)
{
    const FixedSurface& surface = work.mesh->surface;
    const double largest = largest_distance(surface, metric);
    double points = 0;
    for (std::size_t i = 0; i < work.request.distances.classes(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const double distance = work.request.distances.at(i, j);
            if (distance > largest || distance < least_part_of_size * surface.size)
                throw InputError(fmt::format("{:.6g} is the distance of classes {} and {}: must be from {:.4g} to "
                                             "{:.6g}, {}",
                                             distance, j, i, least_part_of_size * surface.size, largest,
                                             metric == SurfaceMetric::surface ? "what can be measured along this mesh"
                                                                              : "the diagonal of the mesh's box"));
        }
        points += work.request.points.empty() ? saturated_count(surface.area, work.request.distances.at(i, i))
                                              : static_cast<double>(work.request.points[i]);
    }
    if (points > static_cast<double>(max_points))
        throw InputError(fmt::format("there would be {:.4g} points; at most {} are possible", points, max_points));
}

}

std::shared_ptr<const SurfaceMesh> surface_class_mesh(const SurfaceClassSettings& settings)
{
    if (settings.read) return settings.read;
    MeshPointSettings reading;
    reading.mesh = settings.mesh;
    reading.faces = settings.faces || !settings.classes.densities.empty();
    return surface_mesh(reading);
}

SurfaceClassWork surface_class_work(const SurfaceClassSettings& settings, std::uint64_t seed)
{
    const ClassSettings& classes = settings.classes;
    SurfaceClassWork work{surface_class_mesh(settings), {}};
    const FixedSurface& surface = work.mesh->surface;
    std::vector<double> fullness(classes.classes(), 1), packed;
    read_densities(settings, work, fullness);
    for (std::size_t i = 0; i < classes.points.size(); ++i)
        packed.push_back(
            std::min(packed_distance_in(surface.area * fullness[i], classes.points[i]),
                     largest_distance(surface, settings.metric) / classes.relative_radius * (1 - 0x1p-50)));
    work.request.surface = {work.mesh, &surface};
    work.request.distances = asked_distances(classes, packed, 2);
    work.request.angle = settings.normal_angle;
    work.request.points = classes.points;
    work.request.shares.assign(classes.points.begin(), classes.points.end());
    if (classes.points.empty())
        for (std::size_t i = 0; i < work.request.distances.classes(); ++i)
            work.request.shares.push_back(std::pow(work.request.distances.at(i, i), -2));
    work.request.factor = classes.factor;
    work.request.stream = stream_key(seed, Purpose::class_darts, 0, surface_attempt);
    check_room(work, settings.metric);
    return work;
}

SurfaceClassSet throw_surface_classes(const SurfaceClassSettings& settings, std::uint64_t seed,
                                      const DistributionPlace& place)
{
    SurfaceClassSet set{surface_class_work(settings, seed), settings.metric};
    const ClassSurfaceRequest& request = set.work.request;
    const auto tell = [&](std::size_t points) {
        if (place.on_step) place.on_step(fmt::format("{} points", points));
    };
    if (settings.metric == SurfaceMetric::surface) {
        set.darts = throw_class_surface_darts(request, *path_class_engine(request), tell);
    } else if (place.engine == Engine::reference) {
        set.darts = throw_class_surface_darts(request, *reference::class_surface_engine(request), tell);
    } else {
        Device& device = place.device();
        double points = 0;
        for (std::size_t i = 0; i < request.shares.size(); ++i)
            points += request.points.empty() ? saturated_count(request.surface->area, request.distances.at(i, i))
                                             : static_cast<double>(request.points[i]);
        check_fits("dart throwing",
                   class_surface_memory(*request.surface, static_cast<std::size_t>(points), request.shares.size()),
                   device.info());
        set.darts = throw_class_surface_darts(request, *class_surface_engine(request, device), tell);
    }
    check_counts(settings.classes, settings.classes.points, set.darts.counts(), "", 2);
    return set;
}

SurfaceDots dots_of(const SurfaceClassSet& set)
{
    const double area = set.surface().area / static_cast<double>(std::max<std::size_t>(1, set.darts.points.size()));
    return {std::sqrt(area), set.surface().open_edges == 0, set.darts.classes};
}

std::vector<SurfacePair> pairs_of(const SurfaceClassSet& set)
{
    std::vector<std::vector<SurfacePoint>> by_class;
    for (std::uint32_t i = 0; i < set.darts.is_full.size(); ++i) by_class.push_back(set.darts.of_class(i));
    const bool is_along = set.metric == SurfaceMetric::surface;
    std::vector<SurfacePair> pairs = is_along
                                         ? pairs_along(set.surface(), by_class)
                                         : surface_pairs(set.surface(), by_class, least_cosine(set.work.request.angle));
    const double rounding = is_along ? path_rounding : 0x1p-40;
    for (const SurfacePair& pair : pairs) // found without what threw them
        if (pair.from_first.least < set.kept().at(pair.first, pair.second) * (1 - rounding))
            throw std::logic_error("darts of classes are nearer to each other than they may be");
    return pairs;
}

std::vector<std::string> class_numbers_as_names(const SurfaceClassSet& set)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < set.darts.is_full.size(); ++i) names.push_back(std::to_string(i));
    return names;
}

std::vector<DistributionNumber> surface_class_numbers(const SurfaceClassSet& set, const std::vector<SurfacePair>& pairs)
{
    const std::vector<std::size_t> counts = set.darts.counts();
    std::vector<DistributionNumber> numbers{
        {"points", "Points", static_cast<double>(set.darts.points.size()), "of all classes"},
        {"area", "Area", set.surface().area, "of the surface, in squares of the mesh's units"}};
    for (std::size_t i = 0; i < counts.size(); ++i)
        numbers.push_back({fmt::format("points_{}", i), fmt::format("Points of class {}", i),
                           static_cast<double>(counts[i]),
                           set.darts.is_full[i] ? "no further one fits" : "as asked for"});
    for (const SurfacePair& pair : pairs) {
        const std::size_t i = pair.first, j = pair.second;
        if (i == j && std::isfinite(pair.from_first.least))
            numbers.push_back({fmt::format("relative_radius_{}", i), fmt::format("Relative radius of class {}", i),
                               pair.from_first.least / packed_distance_in(set.surface().area, counts[i]),
                               "of its points alone: their least distance over that of the densest packing of as many "
                               "in a plane of the same area"});
        numbers.push_back({fmt::format("distance_{}_{}", i, j),
                           fmt::format("Distance {}, {}", i, j),
                           set.kept().at(i, j),
                           set.metric == SurfaceMetric::surface
                               ? "that the two classes keep along the surface, in units of the mesh"
                               : "that the two classes keep, in units of the mesh",
                           {},
                           true});
    }
    append_pair_numbers(pairs, class_numbers_as_names(set), set.metric == SurfaceMetric::surface, numbers);
    if (set.work.request.points.empty())
        numbers.push_back({"uncovered_area", "Uncovered area", set.darts.small_area,
                           "that is not proven to be full, for all classes together, in squares of the mesh's units"});
    return numbers;
}

}
