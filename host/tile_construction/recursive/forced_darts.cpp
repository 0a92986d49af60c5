#include "host/tile_construction/recursive/forced_darts.hpp"

#include "host/sampling/reference/relaxing_grid.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <algorithm>

namespace poissonlab {

std::vector<RankedDart> throw_darts_around(std::uint32_t points, const std::vector<ForcedDart>& forced,
                                           double free_distance, const StreamKey& stream)
{
    RelaxationDartThrowingRequest request;
    request.points = points;
    RadiusLevels levels(request);
    reference::Darts<2> darts(stream);
    std::vector<TorusPoint<2>> places;
    std::vector<RankedDart> result;
    reference::RelaxingGrid<2> grid(places, points);
    grid.fit(2 * levels.radius());
    std::uint64_t squared = levels.squared_min_distance();
    const std::uint64_t squared_free = squared_threshold(free_distance);
    auto next_forced = forced.begin();
    const auto take = [&](const RankedDart& dart) {
        places.push_back(dart.place);
        grid.insert(static_cast<std::uint32_t>(places.size() - 1));
        result.push_back(dart);
    };
    const auto is_forbidden = [&](const TorusPoint<2>& dart) {
        if (!forced.empty() && squared_distance<2>(dart, {0, 0}) < squared_free) return true;
        return std::any_of(next_forced, forced.end(), [&](const ForcedDart& later) {
            return squared_distance<2>(dart, later.dart.place) < later.dart.squared_distance;
        });
    };
    std::uint64_t failures = 0;
    while (result.size() < points) {
        if (next_forced != forced.end() && next_forced->rank == result.size()) {
            take((next_forced++)->dart);
            continue;
        }
        const TorusPoint<2> dart = darts.next();
        if (!is_forbidden(dart) && !grid.conflicts(dart, squared)) {
            take({dart, squared});
            failures = 0;
        } else if (++failures == request.attempts) {
            levels.reduce();
            squared = levels.squared_min_distance();
            grid.fit(2 * levels.radius());
            failures = 0;
        }
    }
    return result;
}

std::vector<ForcedDart> darts_near_corner(const std::vector<RankedDart>& darts, double distance)
{
    const std::uint64_t squared = squared_threshold(distance);
    std::vector<ForcedDart> near;
    for (std::uint32_t i = 0; i < darts.size(); ++i)
        if (squared_distance<2>(darts[i].place, {0, 0}) < squared) near.push_back({i, darts[i]});
    return near;
}

}
