#include "host/distribution/regions/region_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "base/regions/region_text.hpp"
#include "host/device/device_memory.hpp"
#include "host/distribution/regions/line_points.hpp"
#include "host/distribution/regions/region_cells.hpp"
#include "host/distribution/regions/space_points.hpp"
#include "host/distribution/regions/varied_points.hpp"
#include "host/sampling/regions/boundary_points.hpp"
#include "host/sampling/regions/region_candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace poissonlab {
namespace {

/// Obstacles are kept this part of the minimum distance away at least: slits between walls that all but touch would
/// take points otherwise, and to find whether they do takes boxes as small as the slit.
constexpr double least_gap = 1.0 / 1024;

/// A box that is larger on all sides.
RegionBox enlarged_box(RegionBox box, double by)
{
    for (std::size_t k = 0; k < 2; ++k) {
        box.low[k] -= by;
        box.high[k] += by;
    }
    return box;
}

/// The part of the region's extent by which edges that are cut off at the border of the grid lie farther away than they
/// matter.
constexpr double spare_border = 1e-6;

/// Corners of obstacles and of what is left of the region are rounded, by less than a position along each axis: an edge
/// moves by less than two.
constexpr double lost_by_rounding = 2;

KeptAway kept_away_of(const Obstacles& obstacles, const RegionBox& box, const ObstacleDistances& distances)
{
    // Edges and points that are not there make the grid no larger.
    const double lines = obstacles.lines.empty() && obstacles.polygons.empty() ? 0 : distances.lines;
    const double points = obstacles.points.empty() ? 0 : distances.points;
    KeptAway kept;
    kept.box = enlarged_box(box, std::max(lines, points) + box.longest() * spare_border);
    kept.lines = lines_within(obstacles, kept.box);
    kept.points = points_within(obstacles, kept.box);
    const double side = FixedRegion::torus_side(kept.box);
    const auto margin = [&](double distance) {
        return (distance + distance_rounding(distance, kept.box)) / side + lost_by_rounding * 0x1p-32;
    };
    if (!kept.lines.empty()) kept.from_lines = margin(lines);
    if (!kept.points.empty()) kept.from_points = margin(points);
    return kept;
}

/// Samples the boundary, and lets darts keep away from its points.
void begin_on_boundary(RegionDartRequest& request)
{
    request.on_boundary = boundary_points(*request.region, request.darts.min_distance);
    if (request.darts.points) {
        request.on_boundary.resize(std::min(request.on_boundary.size(), *request.darts.points));
        *request.darts.points -= request.on_boundary.size();
    }
    for (const TorusPoint<2>& point : request.on_boundary) request.kept.points.push_back(request.region->own(point));
    if (!request.on_boundary.empty())
        request.kept.from_points =
            std::max(request.kept.from_points, request.darts.min_distance + lost_by_rounding * 0x1p-32);
    request.region = std::make_shared<const FixedRegion>(request.land->rest, 0, request.kept);
    request.darts.region = request.region;
}

PointSet thrown(const DartThrowingRequest& request, const DistributionPlace& place)
{
    if (place.engine == Engine::reference) return reference::throw_darts(request);
    Device& device = place.device();
    check_fits("dart throwing", DartThrower::memory(request, device.info()), device.info());
    return DartThrower(device).throw_darts(request);
}

}

ObstacleDistances obstacle_distances(const DartSettings& settings, double min_distance)
{
    const double least = settings.boundary == RegionBoundary::disks ? min_distance / 2 : min_distance * least_gap;
    return {std::max(settings.obstacle_distance.value_or(0), least),
            std::max(settings.obstacle_distance.value_or(min_distance), least)};
}

std::vector<std::string> RegionDarts::notes() const
{
    if (!request.land) return {};
    std::vector<std::string> notes = notes_of(request.land->whole);
    std::ranges::copy(request.land->obstacles.notes, std::back_inserter(notes));
    if (obstacle_count() > 0 && request.near_obstacles == 0)
        notes.emplace_back("no obstacle is near enough to matter: are they in the units of the region?");
    return notes;
}

std::shared_ptr<const RegionLand> region_land(const DartSettings& settings)
{
    if (settings.land) return settings.land;
    RegionLand land{read_region(settings.region, settings.reading), {}, {}};
    if (!settings.obstacles.empty()) land.obstacles = read_obstacles(settings.obstacles, settings.reading, land.whole);
    const double longest =
        settings.reading.is_along ? box_around(lines_of(land.whole)).longest() : box_of(land.whole).longest();
    if (settings.obstacle_distance.value_or(0) > longest)
        throw InputError(fmt::format("a distance of {:.6g} from them is more than the region's longest side, {:.6g}",
                                     *settings.obstacle_distance, longest));
    if (settings.reading.is_along) return std::make_shared<const RegionLand>(std::move(land));
    land.rest = without_polygons(land.whole, land.obstacles.polygons);
    if (land.rest.polygons.empty()) throw InputError("they cover the region: nothing is left of it");
    return std::make_shared<const RegionLand>(std::move(land));
}

RegionDartRequest region_dart_request(const DartSettings& settings, std::uint64_t seed,
                                      std::shared_ptr<const RegionLand> land, std::uint32_t realization)
{
    RegionDartRequest request;
    request.land = std::move(land);
    const PlaneRegion &whole = request.land->whole, &plane = request.land->rest;
    request.min_distance = settings.min_distance ? *settings.min_distance
                                                 : min_distance_for(settings.relative_radius, *settings.points, 2) *
                                                       std::sqrt(area_of(plane));
    const double longest = box_of(whole).longest();
    if (settings.min_distance && request.min_distance > longest)
        throw InputError(
            fmt::format("{:.6g} is more than the region's longest side, {:.6g}: there is room for one point",
                        request.min_distance, longest));
    KeptAway kept{{}, {}, 0, 0, box_of(whole)};
    if (!settings.obstacles.empty())
        kept = kept_away_of(request.land->obstacles, kept.box, obstacle_distances(settings, request.min_distance));
    request.near_obstacles = kept.lines.size() + kept.points.size();
    // A single point, or a few in a thin region, would be as far apart as one likes.
    const double side = FixedRegion::torus_side(kept.box);
    const double distance =
        std::min(request.min_distance + distance_rounding(request.min_distance, kept.box), side / 2);
    request.darts.min_distance = distance / side;
    request.darts.points = settings.points;
    request.darts.stream = stream_key(seed, Purpose::dart_throwing, realization, region_attempt);
    request.region = std::make_shared<const FixedRegion>(
        plane, settings.boundary == RegionBoundary::disks ? request.darts.min_distance / 2 : 0, kept);
    request.darts.region = request.region;
    choose_cells(request.darts, side);
    request.kept = std::move(kept);
    return request;
}

RegionDarts throw_region_darts(const DartSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                               std::uint32_t realization)
{
    if (settings.reading.is_along) return throw_line_darts(settings, seed, realization);
    if (settings.varies() || settings.is_in_space()) {
        RegionPointSettings points; // by darts
        points.place = settings;
        return settings.varies() ? make_varied_points(points, seed, place) : make_space_points(points, seed, place);
    }
    RegionDarts darts{region_dart_request(settings, seed, region_land(settings), realization), {}, false, 0};
    const DartThrowingRequest& request = darts.request.darts;
    if (settings.boundary == RegionBoundary::on) begin_on_boundary(darts.request);
    PointSet fixed = to_point_set<2>(std::span<const TorusPoint<2>>(darts.request.on_boundary));
    if (request.points != 0)
        std::ranges::copy(thrown(request, place).coordinates, std::back_inserter(fixed.coordinates));
    if (fixed.size() == 0) fail_without_room(darts.request, settings);
    if (settings.points && fixed.size() < *settings.points) {
        const double share = static_cast<double>(fixed.size()) / static_cast<double>(*settings.points);
        const std::string less =
            settings.min_distance
                ? fmt::format("a minimum distance of about {:.4g}", darts.request.min_distance * std::sqrt(share))
                : fmt::format("a relative radius of about {:.4f}", settings.relative_radius * std::sqrt(share));
        throw InputError(
            fmt::format("the region is saturated with {} of {} points: no further one fits; {} can be reached",
                        fixed.size(), *settings.points, less));
    }
    darts.is_saturated = !settings.points;
    darts.sure_distance = darts.request.min_distance;
    darts.points = in_units_of(*darts.request.region, fixed);
    return darts;
}

PointSet in_units_of(const FixedRegion& region, const PointSet& fixed)
{
    PointSet points{2, {}};
    points.coordinates.reserve(fixed.coordinates.size());
    for (std::size_t i = 0; i < fixed.size(); ++i)
        for (const double c : region.own(
                 {static_cast<std::uint32_t>(fixed[i][0] * 0x1p32), static_cast<std::uint32_t>(fixed[i][1] * 0x1p32)}))
            points.coordinates.push_back(c);
    return points;
}

void fail_without_room(const RegionDartRequest& request, const DartSettings& settings)
{
    const std::string among = settings.obstacles.empty() ? "" : " among the obstacles";
    throw InputError(
        settings.boundary == RegionBoundary::disks
            ? fmt::format("the region has no room for a disk of diameter {:.6g}{}", request.min_distance, among)
            : "the region has no room for a point" + among);
}

}
