#include "host/distribution/region_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/plane_delaunay.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/regions/region_text.hpp"
#include "host/device/device_memory.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// The attempt in whose place regions stand among streams: sets of the torus have none, and so share nothing with
/// theirs.
constexpr std::uint32_t region_stream = 1;

/// What the minimum distance is enlarged by, so that points that far apart have coordinates whose computed distance is
/// not below it: each coordinate is rounded twice, by half a unit in the last place of the largest one at most, and so
/// are differences, squares and root.
double rounding_of(double distance, const RegionBox& box)
{
    double largest = 0;
    for (std::size_t k = 0; k < 2; ++k) largest = std::max({largest, std::abs(box.low[k]), std::abs(box.high[k])});
    return 4 * largest * std::numeric_limits<double>::epsilon() + distance * 0x1p-50;
}

double squared_gap(const PointSet& points, std::size_t i, std::size_t j)
{
    const double dx = points[i][0] - points[j][0], dy = points[i][1] - points[j][1];
    return dx * dx + dy * dy;
}

}

RegionDartRequest region_dart_request(const DartSettings& settings, std::uint64_t seed)
{
    RegionDartRequest request;
    const PlaneRegion plane = read_region(settings.region, settings.is_planar);
    const RegionBox box = box_of(plane);
    request.min_distance = settings.min_distance ? *settings.min_distance
                                                 : min_distance_for(settings.relative_radius, *settings.points, 2) *
                                                       std::sqrt(area_of(plane));
    const double longest = box.longest();
    if (settings.min_distance && request.min_distance > longest)
        throw InputError(
            fmt::format("{:.6g} is more than the region's longest side, {:.6g}: there is room for one point",
                        request.min_distance, longest));
    // A single point, or a few in a thin region, would be as far apart as one likes.
    const double side = FixedRegion::torus_side(box);
    const double distance = std::min(request.min_distance + rounding_of(request.min_distance, box), side / 2);
    if (level_0_cells(distance / side, 2) > max_level_0_cells)
        throw InputError(
            fmt::format("a minimum distance of {:.3g} needs a finer grid than memory has room for; at least "
                        "{:.3g} in a region of this extent",
                        request.min_distance, std::sqrt(2.0 / max_level_0_cells) * 1.001 * side));
    request.darts.min_distance = distance / side;
    request.darts.points = settings.points;
    request.darts.stream = stream_key(seed, Purpose::dart_throwing, 0, region_stream);
    request.region = std::make_shared<const FixedRegion>(
        plane, settings.boundary == RegionBoundary::disks ? request.darts.min_distance / 2 : 0);
    request.darts.region = request.region;
    return request;
}

RegionDarts throw_region_darts(const DartSettings& settings, std::uint64_t seed, const DistributionPlace& place)
{
    RegionDarts darts{region_dart_request(settings, seed), {}, false};
    const DartThrowingRequest& request = darts.request.darts;
    PointSet fixed;
    if (place.engine == Engine::reference) {
        fixed = reference::throw_darts(request);
    } else {
        Device& device = place.device();
        check_fits("dart throwing", DartThrower::memory(request, device.info()), device.info());
        fixed = DartThrower(device).throw_darts(request);
    }
    if (fixed.size() == 0)
        throw InputError(
            fmt::format("the region has no room for a disk of diameter {:.6g}", darts.request.min_distance));
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
    darts.points.coordinates.reserve(fixed.coordinates.size());
    for (std::size_t i = 0; i < fixed.size(); ++i)
        for (const double c : darts.request.region->own(
                 {static_cast<std::uint32_t>(fixed[i][0] * 0x1p32), static_cast<std::uint32_t>(fixed[i][1] * 0x1p32)}))
            darts.points.coordinates.push_back(c);
    return darts;
}

/// The nearest point is a neighbour in the Delaunay triangulation; points on one line have none.
NearestDistances nearest_distances(const PointSet& points)
{
    std::vector<PlanePosition> positions;
    for (std::size_t i = 0; i < points.size(); ++i) positions.push_back({points[i][0], points[i][1]});
    std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
    const auto look_at = [&](std::size_t i, std::size_t j) {
        const double gap = squared_gap(points, i, j);
        nearest[i] = std::min(nearest[i], gap);
        nearest[j] = std::min(nearest[j], gap);
    };
    const std::vector<PlaneTriangle> triangles = plane_triangles(positions);
    for (const PlaneTriangle& triangle : triangles)
        for (std::size_t i = 0; i < 3; ++i) look_at(triangle.points[i], triangle.points[(i + 1) % 3]);
    if (triangles.empty())
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) look_at(i, j);
    NearestDistances distances{std::sqrt(std::ranges::min(nearest)), 0};
    for (const double squared : nearest) distances.mean += std::sqrt(squared) / static_cast<double>(nearest.size());
    return distances;
}

}
