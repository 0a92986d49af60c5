#include "host/distribution/regions/space_points.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "base/surfaces/mesh_solid.hpp"
#include "host/device/device_memory.hpp"
#include "host/distribution/regions/region_cells.hpp"
#include "host/distribution/regions/region_elimination.hpp"
#include "host/sampling/classics/torus_grid.hpp"
#include "host/sampling/regions/region_bridson.hpp"
#include "host/sampling/regions/region_candidates.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace poissonlab {
namespace {

/// The attempt in whose place regions of space stand among streams.
constexpr std::uint32_t space_attempt = 2;

constexpr std::size_t least_space_candidates = 10'000; ///< that tell a share

/// Most time would go to darts that miss where less than this of the box around a region is inside.
constexpr double least_share_of_box = 1e-4;
constexpr std::size_t candidates_for_check = 200;

constexpr std::uint32_t usual_failures = 1000, usual_darts_around = 30;

[[noreturn]] void fail_without_space(const SpaceDartRequest& request, const DartSettings& settings)
{
    throw InputError(settings.boundary == RegionBoundary::disks
                         ? fmt::format("the region has no room for a ball of diameter {:.6g}", request.min_distance)
                         : "the region has no room for a point");
}

class SpacePointWork
{
public:
    SpacePointWork(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place)
        : settings_(settings), seed_(seed), place_(place), request_(space_dart_request(settings.place, seed)),
          space_(*request_.space)
    {}

    RegionDarts run()
    {
        RegionDarts made;
        made.space = request_.space;
        made.request.min_distance = request_.min_distance;
        const PointSet fixed = points_for(made);
        if (fixed.size() == 0) fail_without_space(request_, settings_.place);
        check_count(fixed.size());
        made.points = PointSet{3, {}};
        made.points.coordinates.reserve(fixed.coordinates.size());
        for (std::size_t i = 0; i < fixed.size(); ++i) {
            TorusPoint<3> position;
            for (std::size_t k = 0; k < 3; ++k) position[k] = static_cast<std::uint32_t>(fixed[i][k] * 0x1p32);
            std::ranges::copy(space_.own(position), std::back_inserter(made.points.coordinates));
        }
        return made;
    }

private:
    StreamKey stream(Purpose purpose) const { return stream_key(seed_, purpose, 0, space_attempt); }
    bool is_reference() const { return place_.engine == Engine::reference; }
    std::size_t wanted() const { return settings_.place.points.value_or(0); }

    PointSet points_for(RegionDarts& made)
    {
        switch (settings_.method) {
        case RegionMethod::relaxation:
            return relaxed_darts(made);
        case RegionMethod::elimination:
            return eliminated();
        case RegionMethod::bridson:
            check_share();
            made.sure_distance = request_.min_distance;
            return throw_bridson_darts(space_, {.min_distance = request_.darts.min_distance,
                                                .attempts = settings_.attempts.value_or(usual_darts_around),
                                                .stream = stream(Purpose::bridson),
                                                .area = area()});
        default:
            made.sure_distance = request_.min_distance;
            made.is_saturated = !settings_.place.points;
            return thrown();
        }
    }

    PointSet thrown()
    {
        if (is_reference()) return reference::throw_darts(request_.darts);
        Device& device = place_.device();
        check_fits("dart throwing", DartThrower::memory(request_.darts, device.info()), device.info());
        return DartThrower(device).throw_darts(request_.darts);
    }

    CandidateArea area() const
    {
        if (space_.volume() / std::pow(space_.unit() * 0x1p32, 3) < least_share_of_box * box_volume())
            return CandidateArea::squares;
        return candidate_area(request_.darts.min_distance, 3);
    }

    /// The parts of the box around the region, and of darts, that are allowed.
    struct Shares
    {
        double of_box = 0, of_darts = 0;
        std::shared_ptr<const RegionSquares<FixedSpace>> cubes; ///< around the region, where darts fall into them
    };

    /// Random points, all of which are allowed, and what part that is.
    std::vector<TorusPoint<3>> candidates(std::size_t count, Purpose purpose, Shares& share) const
    {
        RegionCandidates found(space_, stream(purpose), area(), least_share_of_box);
        std::vector<TorusPoint<3>> places = found.next(count);
        share = {found.share(), found.share_of_darts(), found.squares()};
        if (places.empty()) fail_without_space(request_, settings_.place);
        if (places.size() < count)
            throw InputError(fmt::format(
                "so little of the region is left by its boundary that fewer than {:g} of the darts would hit it",
                least_share_of_box));
        return places;
    }

    void check_share() const
    {
        Shares share;
        candidates(candidates_for_check, Purpose::random_points, share);
    }

    /// The volume of the box around the region, on the torus.
    double box_volume() const
    {
        double volume = 1;
        for (std::size_t k = 0; k < 3; ++k)
            volume *= (space_.extent().high[k] - space_.extent().low[k] + 1.0) * 0x1p-32;
        return volume;
    }

    PointSet relaxed_darts(RegionDarts& made)
    {
        Shares share;
        candidates(least_space_candidates, Purpose::random_points, share);
        RelaxationDartThrowingRequest request;
        request.dimension = 3;
        request.points = wanted();
        request.factor = settings_.factor;
        request.initial_radius =
            std::min(0.25, max_min_distance(request.points, 3) * std::cbrt(box_volume() * share.of_box) / 2);
        // Darts outside the region fail as well.
        const double attempts = settings_.attempts.value_or(usual_failures) / share.of_darts;
        request.attempts = static_cast<std::uint64_t>(std::min(attempts + 0.5, 0x1p40));
        request.stream = stream(Purpose::relaxation_dart_throwing);
        request.space = request_.space;
        if (area() == CandidateArea::squares) request.cubes = share.cubes;
        RelaxationDarts darts;
        if (is_reference()) {
            darts = reference::throw_relaxation_darts(request);
        } else {
            check_fits("relaxation dart throwing", RelaxationDartThrower::memory(request), place_.device().info());
            darts = RelaxationDartThrower(place_.device()).throw_darts(request);
        }
        const double distance = 2 * darts.radius * space_.unit() * 0x1p32;
        made.sure_distance = std::max(0.0, distance - 2 * distance_rounding(distance, space_.box()));
        return darts.points;
    }

    PointSet eliminated() const
    {
        Shares share;
        const std::vector<TorusPoint<3>> places =
            candidates(wanted() * settings_.candidates, Purpose::sample_elimination, share);
        return eliminate_in_region(space_, to_point_set<3>(std::span<const TorusPoint<3>>(places)), wanted(),
                                   box_volume() * share.of_box, place_);
    }

    void check_count(std::size_t points) const
    {
        if (points >= wanted()) return;
        const double share = std::cbrt(static_cast<double>(points) / static_cast<double>(wanted()));
        const std::string less =
            settings_.place.min_distance
                ? fmt::format("a minimum distance of about {:.4g}", request_.min_distance * share)
                : fmt::format("a relative radius of about {:.4f}", settings_.place.relative_radius * share);
        throw InputError(fmt::format("the region is saturated with {} of {} points: no further one fits; {} can be "
                                     "reached",
                                     points, wanted(), less));
    }

    const RegionPointSettings& settings_;
    std::uint64_t seed_;
    const DistributionPlace& place_;
    SpaceDartRequest request_;
    const FixedSpace& space_;
};

}

namespace {

SpaceRegion space_region_of(const std::string& text)
{
    return is_mesh_name(text) ? solid_of_mesh(text) : read_space_region(text);
}

}

std::shared_ptr<const FixedSpace> whole_space(const DartSettings& settings)
{
    return settings.space ? settings.space : std::make_shared<const FixedSpace>(space_region_of(settings.region));
}

SpaceDartRequest space_distance_request(const DartSettings& settings, std::uint64_t seed)
{
    SpaceDartRequest request{whole_space(settings), 0, {}};
    const FixedSpace& whole = *request.space;
    const double longest = whole.box().longest();
    request.min_distance = settings.min_distance ? *settings.min_distance
                                                 : min_distance_for(settings.relative_radius, *settings.points, 3) *
                                                       std::cbrt(whole.volume());
    if (settings.min_distance && request.min_distance > longest)
        throw InputError(
            fmt::format("{:.6g} is more than the region's longest side, {:.6g}: there is room for few points",
                        request.min_distance, longest));
    const double side = FixedSpace::torus_side(whole.box());
    const double distance =
        std::min(request.min_distance + distance_rounding(request.min_distance, whole.box()), side / 2);
    request.darts.dimension = 3;
    request.darts.min_distance = distance / side;
    request.darts.points = settings.points;
    request.darts.stream = stream_key(seed, Purpose::dart_throwing, 0, space_attempt);
    request.darts.space = request.space;
    choose_cells(request.darts, side);
    return request;
}

SpaceDartRequest space_dart_request(const DartSettings& settings, std::uint64_t seed)
{
    SpaceDartRequest request = space_distance_request(settings, seed);
    if (settings.boundary == RegionBoundary::disks)
        request.space =
            std::make_shared<const FixedSpace>(space_region_of(settings.region), request.darts.min_distance / 2);
    request.darts.space = request.space;
    return request;
}

RegionDarts make_space_points(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place)
{
    return SpacePointWork(settings, seed, place).run();
}

NearestDistances nearest_in_space(const FixedSpace& space, const PointSet& points)
{
    const auto count = static_cast<double>(points.size());
    const double begin = std::cbrt(space.volume() / count) / space.unit();
    TorusGrid grid(points.size(), 3, static_cast<std::uint64_t>(std::max(begin, 1.0)));
    for (std::size_t i = 0; i < points.size(); ++i) {
        TorusPosition position;
        for (std::size_t k = 0; k < 3; ++k)
            position[k] = static_cast<std::uint32_t>((points[i][k] - space.box().low[k]) / space.unit());
        grid.add(position);
    }
    std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
    const auto look_at = [&](std::size_t i, std::size_t j) {
        const double gap =
            std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1], points[i][2] - points[j][2]);
        if (j != i) nearest[i] = std::min(nearest[i], gap);
    };
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        // Positions are rounded down: a few units farther than the distance that was looked at.
        bool is_found = false;
        for (double reach = begin; reach < 0x1p31 && !is_found; reach *= 2) {
            for (const std::size_t j : grid.within(grid[i], reach)) look_at(i, j);
            is_found = nearest[i] < (reach - 4) * space.unit();
        }
        if (is_found) return;
        for (std::size_t j = 0; j < points.size(); ++j) look_at(i, j); // a few points far from each other
    });
    NearestDistances distances{std::ranges::min(nearest), 0};
    for (const double distance : nearest) distances.mean += distance / static_cast<double>(nearest.size());
    return distances;
}

}
