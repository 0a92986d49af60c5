#include "host/distribution/regions/varied_points.hpp"

#include "analysis/regions/kept_distances.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/device/device_memory.hpp"
#include "host/sampling/varied/varied_elimination.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace poissonlab {
namespace {

/// The stream of sets with varying distances.
constexpr std::uint32_t varied_attempt = 1;

constexpr std::uint32_t usual_varied_attempts = 1000;

/// Random candidates that tell how many darts count.
constexpr std::size_t counted_candidates = 10'000;

/// The number of points over the packing integral, nearly, where no further one fits: that of random sequential
/// addition, 0.547 of the area in disks of half the distance (Feder 1980).
constexpr double full_part = 0.547 * 4 / std::numbers::pi;

/// Distances of a table that are less than so many positions are not read exactly enough.
constexpr double least_positions = 4096;

void check_slope(const DistanceTable& table, double scale, KeptDistance between)
{
    const double slope = table.slope * scale, limit = slope_limit(between);
    if (slope < limit) return;
    const std::string advice = between == KeptDistance::smaller && slope < 2 ? "; between = mean takes up to 2" : "";
    throw InputError(fmt::format("grows by up to {:.4g} along a unit of length, near {:.6g}, {:.6g}: must be less than "
                                 "{} where points keep {} distance, or it says nothing about neighbours{}",
                                 slope, table.steepest[0], table.steepest[1], limit,
                                 between == KeptDistance::mean ? "the mean" : "the smaller", advice));
}

/// Distances of more than so many times the least one: darts would not tell them apart.
constexpr double most_ratio = 1 << 15;

/// With the mean of both, a place with a distance of so many times another one's is held against all squares of that
/// size that lie within half of its distance: a quarter of this squared.
constexpr double most_mean_ratio = 512;

/// By what factor distances differ, and with the mean by what factor those of places that can be too near to each other
/// do: see distance_rule().
void check_ratio(const DistanceTable& table, double slope, KeptDistance between)
{
    const double ratio = table.most / table.least;
    const std::string extent =
        fmt::format("goes from {:.4g} to {:.4g}, {:.4g} times as much", table.least, table.most, ratio);
    if (ratio > most_ratio) throw InputError(fmt::format("{}: at most {:g} times", extent, most_ratio));
    if (between == KeptDistance::smaller) return;
    const double half = slope / 2, near = half < 1 ? std::min(ratio, (1 + half) / (1 - half)) : ratio;
    if (near > most_mean_ratio)
        throw InputError(fmt::format("{}: with the mean of both, at most {:g} times where it grows as steeply; the "
                                     "smaller of both has at most {:g}",
                                     extent, most_mean_ratio, most_ratio));
}

DistanceAt distance_of(const DartSettings& settings, const PlaneRegion& whole)
{
    const VaryingDistance& varying = settings.varying;
    return distance_of_text(varying.text, varying.from, varying.range, box_of(whole));
}

/// Distances are less than this, or cells do not tell them apart.
double longest_distance(const RegionLand& land) { return 0.999 * box_of(land.whole).longest(); }

/// By what distances are multiplied so that so many points, at this relative radius, have room; 1 without a number.
double asked_scale(const RegionPointSettings& settings, const DistanceTable& table, double longest)
{
    if (!settings.place.points) return 1;
    const double radius = settings.method == RegionMethod::darts ? settings.place.relative_radius : 1;
    const double scale = radius * max_min_distance(*settings.place.points, 2) * std::sqrt(table.packing);
    return std::min(scale, longest / table.most);
}

/// The part of the region's longest side that a single distance is not below, which needs cells everywhere.
constexpr double least_single_part = 2e-4;

/// The region with what its least distance asks for from boundary and obstacles, which changes its grid.
RegionDartRequest place_for(const DartSettings& settings, const std::shared_ptr<const RegionLand>& land, double least)
{
    DartSettings constant = settings;
    constant.min_distance = std::max(least, box_of(land->whole).longest() * least_single_part);
    RegionDartRequest request = region_dart_request(constant, 0, land);
    request.min_distance = least;
    return request;
}

}

double slope_limit(KeptDistance between) { return between == KeptDistance::mean ? 2 : 1; }

VariedRequest varied_request(const RegionPointSettings& settings, const std::shared_ptr<const RegionLand>& land)
{
    const DartSettings& place = settings.place;
    VariedRequest request;
    request.distance = distance_of(place, land->whole);
    const std::string name = "the distance";
    request.table =
        distance_table(FixedRegion(land->rest, 0, KeptAway{{}, {}, 0, 0, box_of(land->whole)}), request.distance, name);
    if (!(request.table.packing > 0)) fail_without_room(place_for(place, land, 0), place);
    const double longest = longest_distance(*land);
    request.scale = asked_scale(settings, request.table, longest);
    request.place = place_for(place, land, request.table.least * request.scale);
    if (!place.obstacles.empty()) {
        request.table = distance_table(*request.place.region, request.distance, name);
        if (!(request.table.packing > 0)) fail_without_room(request.place, place);
        request.scale = asked_scale(settings, request.table, longest);
    }
    check_slope(request.table, request.scale, place.varying.between);
    if (request.table.most * request.scale > longest)
        throw InputError(fmt::format("is {:.6g} somewhere: must be at most {:.6g}, the extent of the region",
                                     request.table.most * request.scale, longest));
    const double unit = request.place.region->unit();
    if (request.table.least * request.scale < least_positions * unit)
        throw InputError(fmt::format("is {:.3g} somewhere: must be at least {:.3g} in a region of this extent",
                                     request.table.least * request.scale, least_positions * unit));
    VariedDartRequest& darts = request.darts;
    darts.region = request.place.region;
    darts.field = std::make_shared<const DistanceField>(request.table, *darts.region, request.scale);
    darts.is_mean = place.varying.between == KeptDistance::mean;
    darts.slope = request.table.slope_of_box * request.scale;
    check_ratio(request.table, darts.slope, place.varying.between);
    darts.points = place.points;
    const double full = full_part * request.table.packing / (request.scale * request.scale);
    if (full > static_cast<double>(max_points))
        throw InputError(fmt::format("has room for {:.3g} points; at most {}", full, max_points));
    darts.expected = place.points.value_or(static_cast<std::size_t>(full) + 1);
    return request;
}

namespace {

class VariedWork
{
public:
    VariedWork(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place)
        : settings_(settings), seed_(seed), place_(place),
          request_(settings.place.varying.request ? *settings.place.varying.request
                                                  : varied_request(settings, region_land(settings.place)))
    {
        request_.darts.stream = stream_key(seed, Purpose::varied_darts, 0, varied_attempt);
    }

    RegionDarts run()
    {
        VariedDarts made;
        if (settings_.method == RegionMethod::elimination)
            made.points = eliminated();
        else
            made = thrown();
        if (made.points.empty()) fail_without_room(request_.place, settings_.place);
        check_count(made.points.size());
        return result_of(made);
    }

private:
    std::size_t wanted() const { return settings_.place.points.value_or(0); }

    VariedDarts thrown()
    {
        VariedDartRequest darts = request_.darts;
        if (settings_.method == RegionMethod::relaxation) {
            const double share = candidates(counted_candidates).share;
            const double attempts = settings_.attempts.value_or(usual_varied_attempts) / share;
            darts.attempts = static_cast<std::uint32_t>(std::min(attempts + 0.5, 0x1p31));
            darts.factor = settings_.factor;
        }
        if (place_.engine == Engine::reference) return reference::throw_varied_darts(darts);
        Device& device = place_.device();
        check_fits("dart throwing", VariedDartThrower::memory(darts), device.info());
        return VariedDartThrower(device).throw_darts(darts);
    }

    VariedCandidates candidates(std::size_t count) const
    {
        VariedDartRequest darts = request_.darts;
        darts.stream = stream_key(seed_, Purpose::varied_candidates, 0, varied_attempt);
        VariedCandidates found = varied_candidates(darts, count);
        if (found.points.size() < count) fail_without_room(request_.place, settings_.place);
        return found;
    }

    std::vector<TorusPoint<2>> eliminated()
    {
        const double packing = request_.table.packing / (request_.scale * request_.scale);
        const PointSet kept =
            eliminate_varied(request_.darts, candidates(wanted() * settings_.candidates).points, wanted(), packing);
        std::vector<TorusPoint<2>> points;
        for (std::size_t i = 0; i < kept.size(); ++i)
            points.push_back(
                {static_cast<std::uint32_t>(kept[i][0] * 0x1p32), static_cast<std::uint32_t>(kept[i][1] * 0x1p32)});
        return points;
    }

    void check_count(std::size_t points) const
    {
        if (points >= wanted()) return;
        throw InputError(fmt::format("the region is saturated with {} of {} points: no further one fits; a relative "
                                     "radius of about {:.4f} can be reached",
                                     points, wanted(),
                                     settings_.place.relative_radius *
                                         std::sqrt(static_cast<double>(points) / static_cast<double>(wanted()))));
    }

    /// Distances that vary are proven as they are kept; without a promise, the set has what was found.
    RegionDarts result_of(const VariedDarts& made)
    {
        const FixedRegion& region = *request_.place.region;
        const bool is_promised = settings_.method != RegionMethod::elimination;
        auto set = std::make_shared<VariedSet>(VariedSet{.request = request_, .scale = request_.scale * made.scale});
        std::vector<std::uint32_t> kept, typed;
        for (const TorusPoint<2>& point : made.points) {
            const auto [x, y] = region.own(point);
            set->distances.push_back(request_.distance(x, y) * set->scale);
            if (!(set->distances.back() > 0))
                throw InputError(fmt::format("the minimum distance is {:.6g} at {:.6g}, {:.6g}: must be above 0",
                                             set->distances.back(), x, y));
            kept.push_back(scaled_distance(request_.darts.field->at(point), made.scale));
            typed.push_back(
                static_cast<std::uint32_t>(std::clamp(set->distances.back() / region.unit(), 1.0, 0x1p31 - 1)));
        }
        const KeptDistances found = kept_distances(made.points, kept, request_.darts.is_mean);
        if (is_promised && !found.are_kept) throw std::logic_error("darts are nearer to each other than they may be");
        set->nearest = found.nearest;
        set->least = found.least();
        set->is_proven = is_promised;
        set->least_as_typed = kept_distances(made.points, typed, request_.darts.is_mean).least();
        if (!is_promised && made.points.size() > 1) take_least_for_scale(*set);
        RegionDarts darts{request_.place, {}, made.is_full, 0, set};
        darts.points = in_units_of(region, to_point_set<2>(std::span<const TorusPoint<2>>(made.points)));
        if (is_promised) darts.sure_distance = request_.table.least * set->scale;
        return darts;
    }

    /// Multiplies distances by the least ratio that was found, so that all pairs keep them.
    static void take_least_for_scale(VariedSet& set)
    {
        set.scale *= set.least;
        for (double& distance : set.distances) distance *= set.least;
        for (double& nearest : set.nearest) nearest /= set.least;
        set.least_as_typed /= set.least;
        set.least = 1;
    }

    /// Scales a distance and rounds it as kernels do.
    static std::uint32_t scaled_distance(std::uint32_t distance, double scale)
    {
        return static_cast<std::uint32_t>(std::uint64_t{distance} * static_cast<std::uint64_t>(scale * 0x1p31) >> 31);
    }

    const RegionPointSettings& settings_;
    std::uint64_t seed_;
    const DistributionPlace& place_;
    VariedRequest request_;
};

}

RegionDarts make_varied_points(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place)
{
    return VariedWork(settings, seed, place).run();
}

}
