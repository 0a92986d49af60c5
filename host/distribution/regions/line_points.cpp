#include "host/distribution/regions/line_points.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "base/regions/obstacles.hpp"
#include "host/distribution/regions/line_darts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

[[noreturn]] void fail_saturated(const DartSettings& settings, const RegionDarts& darts)
{
    const double share = static_cast<double>(darts.points.size()) / static_cast<double>(*settings.points);
    throw InputError(fmt::format(
        "the lines are saturated with {} of {} points: no further one fits; {} can be reached", darts.points.size(),
        *settings.points,
        settings.min_distance ? fmt::format("a minimum distance of about {:.4g}", darts.request.min_distance * share)
                              : fmt::format("a relative radius of about {:.4f}", settings.relative_radius * share)));
}

}

double length_along(const std::vector<RegionRing>& lines) { return total_length(edges_of(lines)); }

double distance_along(const DartSettings& settings, const std::vector<RegionRing>& lines)
{
    const double length = total_length(edges_of(lines)), longest = box_around(lines).longest();
    const double distance = settings.min_distance
                                ? *settings.min_distance
                                : settings.relative_radius * length / static_cast<double>(*settings.points);
    if (settings.min_distance && distance > longest)
        throw InputError(fmt::format("{:.6g} is more than the lines' longest side, {:.6g}: there is room for one point",
                                     distance, longest));
    check_line_pieces(length, longest, distance);
    return distance;
}

RegionDarts throw_line_darts(const DartSettings& settings, std::uint64_t seed, std::uint32_t realization)
{
    RegionDarts made;
    made.points = {2, {}};
    made.request.land = region_land(settings);
    const RegionLand& land = *made.request.land;
    const std::vector<RegionRing>& lines = lines_of(land.whole);
    const RegionBox box = box_around(lines);
    made.request.min_distance = made.sure_distance = distance_along(settings, lines);
    const ObstacleDistances away = obstacle_distances(settings, made.sure_distance);
    const auto [rest, numbers] = lines_among(land, away.lines);
    const std::vector<LinePiece> edges = edges_of(rest);
    made.length = total_length(edges);
    const double apart = made.sure_distance + line_margin(made.sure_distance, box);
    const double from_points = away.points + line_margin(away.points, box);
    LineDarts darts(pieces_of(edges, made.sure_distance), box,
                    land.obstacles.points.empty() ? apart : std::max(apart, from_points));
    const std::uint64_t all = darts.free_count();
    for (const LinePlace& point : land.obstacles.points) darts.keep_away(point, from_points);
    if (darts.is_full()) throw InputError("the lines have no room for a point among the obstacles");
    if (rest != lines || darts.free_count() < all) made.request.near_obstacles = land.obstacles.count();
    const StreamKey stream = stream_key(seed, Purpose::dart_throwing, realization, line_attempt);
    const RegionSource& source = *land.whole.source;
    for (std::uint32_t i = 0; !darts.is_full() && i < settings.points.value_or(SIZE_MAX); ++i) {
        const auto words = philox({i, 0, 0, 0}, stream);
        const auto [place, line] = darts.dart((std::uint64_t{words[0]} << 32) | words[1]);
        darts.keep_away(place, apart);
        made.points.coordinates.insert(made.points.coordinates.end(), place.begin(), place.end());
        if (!source.feature_of_line.empty())
            made.features.push_back(source.features[source.feature_of_line[numbers[line]]].id);
    }
    if (settings.points && made.points.size() < *settings.points) fail_saturated(settings, made);
    made.is_saturated = !settings.points;
    return made;
}

}
