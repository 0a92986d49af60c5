#include "host/distribution/regions/region_points.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "host/device/device_memory.hpp"
#include "host/distribution/regions/region_cells.hpp"
#include "host/distribution/regions/region_elimination.hpp"
#include "host/distribution/regions/space_points.hpp"
#include "host/distribution/regions/varied_points.hpp"
#include "host/sampling/regions/region_bridson.hpp"
#include "host/sampling/regions/region_candidates.hpp"
#include "host/sampling/regions/region_gaussian.hpp"
#include "host/sampling/regions/region_lloyd.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Distances from lines that are less than this part of the minimum distance take nothing from cells.
constexpr double least_part_of_distance = 1.0 / 8;

/// Corners of half a circle.
constexpr int half_corners = 16;

/// The places that are nearer to a line than a distance, as a polygon within them. Lines of no length are points.
RegionPolygon around_line(const std::array<double, 4>& line, double distance)
{
    const double direction = std::atan2(line[3] - line[1], line[2] - line[0]);
    RegionPolygon polygon;
    for (const bool is_end : {true, false})
        for (int i = 0; i <= half_corners; ++i) {
            const double angle = direction + std::numbers::pi * (static_cast<double>(i) / half_corners - 0.5) +
                                 (is_end ? 0 : std::numbers::pi);
            polygon.outline.push_back(
                {line[is_end ? 2 : 0] + distance * std::cos(angle), line[is_end ? 3 : 1] + distance * std::sin(angle)});
        }
    // If the line is a point, the halves meet in two corners, which come twice.
    if (line[0] == line[2] && line[1] == line[3]) {
        polygon.outline.pop_back();
        polygon.outline.erase(polygon.outline.begin() + half_corners);
    }
    return polygon;
}

/// The land without what is too near to obstacles: cells of Lloyd's method are cut there.
PlaneRegion land_for_cells(const RegionDartRequest& request)
{
    const double side = FixedRegion::torus_side(request.kept.box);
    const double from_lines = request.kept.from_lines * side, from_points = request.kept.from_points * side;
    std::vector<RegionPolygon> taken;
    if (from_lines > request.min_distance * least_part_of_distance)
        for (const auto& line : request.kept.lines) taken.push_back(around_line(line, from_lines));
    for (const auto& [x, y] : request.kept.points) taken.push_back(around_line({x, y, x, y}, from_points));
    return without_polygons(request.land->rest, taken);
}

class RegionPointWork
{
public:
    RegionPointWork(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                    std::uint32_t realization)
        : settings_(settings), seed_(seed), realization_(realization),
          place_(place), points_{region_dart_request(settings.place, seed, region_land(settings.place), realization),
                                 {2, {}},
                                 false,
                                 0},
          region_(*points_.request.region)
    {}

    RegionDarts run()
    {
        switch (settings_.method) {
        case RegionMethod::relaxation:
            return made_of(relaxed_darts());
        case RegionMethod::elimination:
            return made_of(eliminated());
        case RegionMethod::lloyd:
            return made_of(relaxed());
        case RegionMethod::gaussian:
            return made_of(gaussian());
        default:
            return made_of(bridson());
        }
    }

    DeviceMemory memory(const DeviceInfo& device) const
    {
        std::size_t points = wanted();
        if (settings_.method == RegionMethod::gaussian) points = std::max(points, least_points_of_region_gaussian());
        switch (settings_.method) {
        case RegionMethod::darts:
            return DartThrower::memory(points_.request.darts, device);
        case RegionMethod::relaxation:
            return relaxation_memory();
        case RegionMethod::elimination:
            return SampleElimination::memory(2, points * settings_.candidates, points, own_area(), true);
        case RegionMethod::lloyd:
            return RegionLloyd::memory(SiteGrid(region_, points, is_in_squares()));
        case RegionMethod::gaussian:
            return either(relaxation_memory(),
                          GaussianBlueNoise::memory(RegionGaussian(region_, points, is_in_squares(),
                                                                   [](const GaussianFieldShape&) { return false; })
                                                        .shape(),
                                                    points));
        default:
            return {};
        }
    }

private:
    StreamKey stream(Purpose purpose) const { return stream_key(seed_, purpose, realization_, region_attempt); }
    bool is_reference() const { return place_.engine == Engine::reference; }
    std::size_t wanted() const { return settings_.place.points.value_or(0); }

    /// The side of the torus in units of the region.
    double side() const { return region_.unit() * 0x1p32; }

    RegionDarts made_of(const PointSet& fixed)
    {
        if (fixed.size() == 0) fail_without_room(points_.request, settings_.place);
        points_.points = in_units_of(region_, fixed);
        return std::move(points_);
    }

    CandidateArea area() const { return candidate_area(points_.request.darts.min_distance, 2); }
    bool is_in_squares() const { return area() == CandidateArea::squares; }

    /// The parts of the box around the region, and of darts, that are allowed.
    struct Shares
    {
        double of_box = 0, of_darts = 0;
        std::shared_ptr<const RegionSquares<FixedRegion>> squares{}; ///< that darts fall into, once they are known
    };

    /// Random points, all of which are allowed, and what part that is.
    std::vector<TorusPoint<2>> candidates(std::size_t count, Purpose purpose, Shares& share) const
    {
        RegionCandidates candidates(region_, stream(purpose), area());
        std::vector<TorusPoint<2>> places = candidates.next(count);
        if (places.size() < count) fail_without_room(points_.request, settings_.place);
        share = {candidates.share(), candidates.share_of_darts(), candidates.squares()};
        return places;
    }

    /// The area of the box around the region, on the torus.
    double box_area() const
    {
        const FixedBox& box = region_.extent();
        return (box.high[0] - box.low[0] + 1.0) * (box.high[1] - box.low[1] + 1.0) * 0x1p-64;
    }

    RelaxationDartThrowingRequest relaxation_request(const Shares& share) const
    {
        RelaxationDartThrowingRequest request;
        request.points = wanted();
        request.factor = settings_.factor;
        request.initial_radius =
            std::min(0.25, max_min_distance(request.points, 2) * std::sqrt(box_area() * share.of_box) / 2);
        // Darts outside the region fail as well.
        const double attempts = settings_.attempts.value_or(usual_attempts) / share.of_darts;
        request.attempts = static_cast<std::uint64_t>(std::min(attempts + 0.5, 0x1p40));
        request.stream = stream(Purpose::relaxation_dart_throwing);
        request.region = points_.request.region;
        request.squares = share.squares;
        if (!request.squares && is_in_squares())
            request.squares =
                std::make_shared<const RegionSquares<FixedRegion>>(squares_of(region_, most_region_squares));
        return request;
    }

    /// The region's area, on the torus.
    double own_area() const { return region_.area() / (side() * side()); }

    DeviceMemory relaxation_memory() const
    {
        const double share = std::min(1.0, own_area() / box_area());
        return RelaxationDartThrower::memory(relaxation_request({share, share}));
    }

    PointSet relaxed_darts()
    {
        Shares share;
        candidates(least_candidates, Purpose::random_points, share);
        const RelaxationDartThrowingRequest request = relaxation_request(share);
        check_memory("relaxation dart throwing", RelaxationDartThrower::memory(request));
        const RelaxationDarts darts = is_reference() ? reference::throw_relaxation_darts(request)
                                                     : RelaxationDartThrower(place_.device()).throw_darts(request);
        const double distance = 2 * darts.radius * side();
        points_.sure_distance = std::max(0.0, distance - 2 * distance_rounding(distance, region_.box()));
        return darts.points;
    }

    PointSet eliminated()
    {
        Shares share;
        const std::vector<TorusPoint<2>> places =
            candidates(wanted() * settings_.candidates, Purpose::sample_elimination, share);
        return eliminate_in_region(region_, to_point_set<2>(std::span<const TorusPoint<2>>(places)), wanted(),
                                   box_area() * share.of_box, place_);
    }

    /// Throws InputError where the work is the device's, which has no memory for it.
    void check_memory(const char* what, const DeviceMemory& memory) const
    {
        if (!is_reference()) check_fits(what, memory, place_.device().info());
    }

    PointSet relaxed()
    {
        Shares share;
        const std::vector<TorusPoint<2>> start = candidates(wanted(), Purpose::random_points, share);
        if (is_reference()) return relaxed_from(start, reference::integrate_cells);
        check_memory("Lloyd relaxation", RegionLloyd::memory(SiteGrid(region_, start.size(), is_in_squares())));
        RegionLloyd lloyd(place_.device());
        return relaxed_from(start, [&](const SiteGrid& grid) { return lloyd.integrate_cells(grid); });
    }

    PointSet relaxed_from(const std::vector<TorusPoint<2>>& start, const CellIntegrals& integrals) const
    {
        const FixedRegion land(land_for_cells(points_.request), 0, {{}, {}, 0, 0, points_.request.kept.box});
        const std::vector<TorusPoint<2>> sites = relax_in_region(
            region_, land, start, settings_.iterations.value_or(usual_lloyd_steps), integrals, is_in_squares());
        return to_point_set<2>(std::span<const TorusPoint<2>>(sites));
    }

    /// Makes Gaussian blue noise from darts, which are even at long distances already.
    PointSet gaussian()
    {
        const PointSet darts = relaxed_darts();
        points_.sure_distance = 0;
        std::vector<TorusPoint<2>> start;
        for (std::size_t i = 0; i < darts.size(); ++i)
            start.push_back(
                {static_cast<std::uint32_t>(darts[i][0] * 0x1p32), static_cast<std::uint32_t>(darts[i][1] * 0x1p32)});
        const auto fits = [&](const GaussianFieldShape& shape) {
            check_memory("Gaussian blue noise", GaussianBlueNoise::memory(shape, start.size()));
            return true;
        };
        const RegionGaussian gaussians(region_, start.size(), is_in_squares(), fits);
        fits(gaussians.shape());
        const auto descent = [&](const PointSet& points, const GaussianRequest& request) {
            return is_reference() ? reference::descend(points, request).points
                                  : GaussianBlueNoise(place_.device()).descend(points, request).points;
        };
        const std::vector<TorusPoint<2>> places =
            gaussians.descend(start, settings_.iterations.value_or(usual_gaussian_steps), descent);
        return to_point_set<2>(std::span<const TorusPoint<2>>(places));
    }

    PointSet bridson()
    {
        points_.sure_distance = points_.request.min_distance;
        return throw_bridson_darts(region_, {.min_distance = points_.request.darts.min_distance,
                                             .attempts = settings_.attempts.value_or(usual_bridson_attempts),
                                             .stream = stream(Purpose::bridson),
                                             .area = area()});
    }

    static constexpr std::size_t least_candidates = 10'000; ///< that tell a share
    static constexpr std::uint32_t usual_attempts = 1000;
    static constexpr std::uint32_t usual_lloyd_steps = 50, usual_gaussian_steps = 100;
    static constexpr std::uint32_t usual_bridson_attempts = 30;

    const RegionPointSettings& settings_;
    std::uint64_t seed_;
    std::uint32_t realization_;
    const DistributionPlace& place_;
    RegionDarts points_;
    const FixedRegion& region_;
};

}

RegionDarts make_region_points(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                               std::uint32_t realization)
{
    if (settings.place.varies()) return make_varied_points(settings, seed, place);
    if (settings.place.is_in_space()) return make_space_points(settings, seed, place);
    if (settings.method == RegionMethod::darts) return throw_region_darts(settings.place, seed, place, realization);
    return RegionPointWork(settings, seed, place, realization).run();
}

DeviceMemory region_point_memory(const RegionPointSettings& settings, const DeviceInfo& device)
{
    return RegionPointWork(settings, 0, {}, 0).memory(device);
}

}
