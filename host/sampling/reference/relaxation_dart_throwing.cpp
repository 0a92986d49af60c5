// Relaxation dart throwing, plain and sequential: what the kernels must reproduce.
#include "host/sampling/relaxation_dart_throwing.hpp"

#include "host/sampling/reference/relaxing_grid.hpp"
#include "host/sampling/reference/request_land.hpp"

#include <vector>

namespace poissonlab::reference {
namespace {

template <int D>
const auto& squares_for(const RelaxationDartThrowingRequest& request)
{
    if constexpr (D == 2)
        return request.squares;
    else
        return request.cubes;
}

template <int D>
Darts<D> darts_of(const RelaxationDartThrowingRequest& request)
{
    if (const auto& squares = squares_for<D>(request)) return {request.stream, squares->corners, squares->shift};
    if (const auto& land = land_of<D>(request)) return {request.stream, land->extent()};
    return Darts<D>(request.stream);
}

template <int D>
bool is_allowed(const RelaxationDartThrowingRequest& request, const TorusPoint<D>& dart)
{
    const auto& land = land_of<D>(request);
    return !land || land->contains(dart);
}

template <int D>
RelaxationDarts throw_darts(const RelaxationDartThrowingRequest& request)
{
    Darts<D> darts = darts_of<D>(request);
    RadiusLevels levels(request);
    std::vector<TorusPoint<D>> points;
    RelaxingGrid<D> grid(points, request.points, request.is_in_squares());
    grid.fit(2 * levels.radius());
    std::uint64_t squared_min_distance = levels.squared_min_distance();
    std::uint64_t failures = 0;
    while (points.size() < request.points) {
        const TorusPoint<D> dart = darts.next();
        if (!grid.conflicts(dart, squared_min_distance) && is_allowed<D>(request, dart)) {
            points.push_back(dart);
            grid.insert(static_cast<std::uint32_t>(points.size() - 1));
            failures = 0;
        } else if (++failures == request.attempts) {
            levels.reduce();
            squared_min_distance = levels.squared_min_distance();
            grid.fit(2 * levels.radius());
            failures = 0;
        }
    }
    return {to_point_set<D>(std::span<const TorusPoint<D>>(points)), levels.radius(), darts.thrown()};
}

}

RelaxationDarts throw_relaxation_darts(const RelaxationDartThrowingRequest& request)
{
    return request.dimension == 2 ? throw_darts<2>(request) : throw_darts<3>(request);
}

}
