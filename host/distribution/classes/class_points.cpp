#include "host/distribution/classes/class_points.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/device/device_memory.hpp"
#include "host/distribution/classes/class_density.hpp"
#include "host/distribution/classes/class_lines.hpp"
#include "host/distribution/classes/class_tiling.hpp"
#include "host/sampling/classes/class_cells.hpp"
#include "host/settings/keys/keys.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Returns the distance of the densest packing of as many points of each class on the torus, at most its side.
std::vector<double> packing_distances(const ClassSettings& settings)
{
    std::vector<double> all;
    for (const std::size_t count : settings.points)
        all.push_back(std::min(1 / settings.relative_radius, max_min_distance(count, settings.dimension)));
    return all;
}

/// Scales all distances down until none is above that of the densest packing of a class: larger ones would shrink in
/// vain.
ClassDistances within_packings(const ClassDistances& distances, const ClassSettings& settings)
{
    double scale = 1;
    for (std::size_t i = 0; i < settings.points.size(); ++i)
        scale = std::min(scale, max_min_distance(settings.points[i], settings.dimension) / distances.at(i, i));
    return distances.scaled(scale);
}

double largest_of(const ClassDistances& distances)
{
    double largest = 0;
    for (std::size_t i = 0; i < distances.classes(); ++i)
        for (std::size_t j = 0; j <= i; ++j) largest = std::max(largest, distances.at(i, j));
    return largest;
}

/// The cells of densities in all features together, and in each of them at least.
constexpr std::size_t most_density_cells = 1 << 18, least_density_cells = 1 << 12;

/// Reads the densities of all classes, if there are any.
std::vector<DensityAt> densities_of(const ClassSettings& settings, const RegionLand& land)
{
    std::vector<DensityAt> all;
    const std::vector<std::string>& from = settings.densities_from;
    for (std::size_t i = 0; i < settings.densities.size(); ++i)
        all.push_back(distance_of_text(settings.densities[i],
                                       from.empty() ? "light" : from[std::min(i, from.size() - 1)], {0, 1},
                                       box_of(land.whole)));
    return all;
}

/// Returns the densities of all classes with points in a part of the land; the others have none.
std::vector<ClassDensity> densities_in(const ClassSettings& settings, const std::vector<DensityAt>& densities,
                                       const FixedRegion& region, const std::vector<std::size_t>& points,
                                       std::size_t parts)
{
    if (densities.empty()) return {};
    const RegionCells cells = density_cells(region, std::max(least_density_cells, most_density_cells / parts));
    std::vector<ClassDensity> all;
    for (std::size_t i = 0; i < densities.size(); ++i)
        all.push_back(points[i] > 0 ? class_density(region, cells, densities[i], name_of_input(settings.densities[i]))
                                    : ClassDensity{});
    return all;
}

std::size_t parts_of(const ClassWork& work) { return std::max<std::size_t>(1, work.features->size()); }

const PlaneRegion& region_of(const ClassWork& work, std::size_t part)
{
    return work.features->empty() ? work.land->rest : (*work.features)[part].region;
}

/// Returns the points of each class in a part of the land.
const std::vector<std::size_t>& points_of(const ClassSettings& settings, const ClassWork& work, std::size_t part)
{
    return work.features->empty() ? settings.points : (*work.features)[part].points;
}

/// Returns the distance of the densest packing of each class where it is densest.
std::vector<double> packing_distances(const ClassSettings& settings, const std::vector<DensityAt>& densities,
                                      const ClassWork& work)
{
    std::vector<double> all(settings.classes(), box_of(work.land->whole).longest() / settings.relative_radius);
    for (std::size_t part = 0; part < parts_of(work); ++part) {
        const std::vector<std::size_t>& points = points_of(settings, work, part);
        const FixedRegion region(region_of(work, part), 0, KeptAway{{}, {}, 0, 0, box_of(work.land->whole)});
        const std::vector<ClassDensity> read = densities_in(settings, densities, region, points, parts_of(work));
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i] == 0) continue;
            const double fullness = read.empty() ? 1 : read[i].fullness;
            all[i] =
                std::min(all[i], max_min_distance(points[i], 2) * std::sqrt(area_of(region_of(work, part)) * fullness));
        }
    }
    return all;
}

/// Divides the request into features, with densities of the classes. Each is made when its points are, because
/// densities of thousands of features would take gigabytes.
void add_parts(const ClassSettings& settings, const std::vector<DensityAt>& densities, const KeptAway& kept,
               ClassWork& work)
{
    ClassDartRequest& request = work.request;
    request.points.assign(settings.classes(), 0);
    request.parts = parts_of(work);
    for (std::size_t part = 0; part < request.parts; ++part) {
        const std::vector<std::size_t>& points = points_of(settings, work, part);
        for (std::size_t i = 0; i < points.size(); ++i) request.points[i] += points[i];
    }
    ClassWork place{.request = {}, .asked = {}, .land = work.land, .features = work.features};
    request.part_at = [settings, densities, kept, place](std::size_t part) {
        const std::vector<std::size_t>& points = points_of(settings, place, part);
        ClassPart made{std::make_shared<const FixedRegion>(region_of(place, part), 0, kept),
                       {points.begin(), points.end()},
                       points,
                       {}};
        for (ClassDensity& density : densities_in(settings, densities, *made.region, points, parts_of(place)))
            made.densities.push_back(std::move(density.cells));
        return made;
    };
    request.shares.assign(request.points.begin(), request.points.end());
}

/// Places the region on the torus, and converts distances to its units. They become longer by as much as rounding of
/// coordinates may shorten them.
void place_in_region(const ClassSettings& settings, ClassWork& work)
{
    work.land = region_land(settings.place);
    const RegionLand& land = *work.land;
    if (!settings.features.is_empty())
        work.features = std::make_shared<const std::vector<FeaturePart>>(feature_parts(
            settings.features, land.whole, land.obstacles.polygons, name_of_input(settings.place.region)));
    std::vector<DensityAt> densities;
    try {
        densities = densities_of(settings, land);
    } catch (const InputError& error) {
        throw DensityError(error.what());
    }
    const bool follows = settings.distances.empty() && settings.matrix.empty();
    const auto distances = follows ? packing_distances(settings, densities, work) : std::vector<double>{};
    work.asked = asked_distances(settings, distances, 2);
    DartSettings place = settings.place; // as for a saturated set at the largest distance
    place.points.reset();
    place.min_distance = largest_of(work.asked);
    if (!place.obstacle_distance) place.obstacle_distance = 0;
    const RegionDartRequest darts = region_dart_request(place, 0, work.land);
    const RegionBox& box = darts.kept.box;
    work.side = FixedRegion::torus_side(box);
    work.request.region = darts.region;
    work.request.distances = ClassDistances(work.asked.classes());
    for (std::size_t i = 0; i < work.asked.classes(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const double distance = work.asked.at(i, j);
            work.request.distances.set(i, j, std::min((distance + distance_rounding(distance, box)) / work.side, 0.5));
        }
    if (!settings.densities.empty() || !work.features->empty()) add_parts(settings, densities, darts.kept, work);
}

/// Saturated sets in regions have at most this number of points, because the cells that they begin with take memory.
constexpr double most_saturated_in_region = 1 << 24;

/// Throws InputError if there would be too many points. Full classes have about half as many points as a packing.
void check_count(const ClassWork& work)
{
    if (work.request.region && work.request.points.empty()) {
        double points = 0;
        for (std::size_t i = 0; i < work.asked.classes(); ++i)
            points += work.request.region->area() / std::pow(work.asked.at(i, i), 2);
        if (points > most_saturated_in_region)
            throw InputError(fmt::format("there would be some {:.2g} points in the region; at most {} are possible",
                                         points, most_saturated_in_region));
        return;
    }
    const std::size_t most = most_class_points(work.request), points = work.request.points.empty() ? most / 2 : most;
    if (points > static_cast<std::size_t>(max_points))
        throw InputError(fmt::format("there would be {} points; at most {} are possible", points, max_points));
}

}

ClassDistances asked_distances(const ClassSettings& settings, const std::vector<double>& largest, int dimension)
{
    const std::size_t classes = settings.classes();
    if (!settings.matrix.empty()) {
        ClassDistances given(classes);
        for (std::size_t i = 0; i < classes; ++i)
            for (std::size_t j = 0; j < classes; ++j) given.set(i, j, settings.matrix[i * classes + j]);
        return given;
    }
    if (!settings.distances.empty()) return wei_distances(settings.distances, dimension);
    std::vector<double> distances;
    for (const double each : largest) distances.push_back(settings.relative_radius * each);
    return wei_distances(distances, dimension);
}

std::size_t ClassSettings::classes() const
{
    if (!matrix.empty()) return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
    return std::max({points.size(), distances.size(), features.names().size()});
}

ClassWork class_work(const ClassSettings& settings, std::uint64_t seed, std::uint32_t number)
{
    ClassWork work{.request = {.dimension = settings.dimension,
                               .distances = {},
                               .shares = {settings.points.begin(), settings.points.end()},
                               .points = settings.points,
                               .factor = settings.factor,
                               .stream = stream_key(seed, Purpose::class_darts, number)},
                   .asked = {}};
    if (settings.is_along()) {
        place_on_lines(settings, work);
    } else if (settings.has_region()) {
        place_in_region(settings, work);
    } else {
        work.asked = asked_distances(settings, packing_distances(settings), settings.dimension);
        if (settings.factor < 1) work.asked = within_packings(work.asked, settings);
        work.request.distances = work.asked;
    }
    if (!settings.has_numbers())
        for (std::size_t i = 0; i < work.asked.classes(); ++i)
            work.request.shares.push_back(
                std::pow(work.asked.at(i, i), settings.is_along() ? -1 : -settings.dimension));
    if (!settings.is_along()) check_count(work);
    return work;
}

void check_densities(const ClassWork& work)
{
    for (std::size_t part = 0; part < work.request.parts; ++part) work.request.part_at(part);
}

ClassSet throw_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                       std::uint32_t number)
{
    if (settings.has_tiles()) return tiled_classes(settings, seed, place, number);
    ClassSet set{class_work(settings, seed, number), {}};
    if (settings.is_along()) {
        set = throw_line_classes(settings, std::move(set.work));
        check_numbers(settings, set);
        return set;
    }
    set.work.request.on_filled = [&](std::size_t, const ClassPart& part, const ClassedPoints& points) {
        set.density_errors.push_back(density_errors(part, points));
    };
    const ClassDartRequest& request = set.work.request;
    if (place.engine == Engine::reference) {
        set.points = reference::throw_class_darts(request);
    } else {
        Device& device = place.device();
        check_fits("dart throwing", ClassDartThrower::memory(request), device.info());
        set.points = ClassDartThrower(device).throw_darts(request);
    }
    set.work.request.on_filled = {};
    if (set.points.classes.empty())
        throw InputError(fmt::format("the region has no room for a point{}",
                                     settings.place.obstacles.empty() ? "" : " among the obstacles"));
    check_numbers(settings, set);
    return set;
}

}
