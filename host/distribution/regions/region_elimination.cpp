#include "host/distribution/regions/region_elimination.hpp"

#include "host/device/device_memory.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "host/sampling/regions/region_candidates.hpp"

#include <cmath>
#include <optional>

namespace poissonlab {

namespace {

/// The grid of the device has cells around the torus, no more than some for each point: where points lie in so small a
/// part of it, each of its cells would have very many.
constexpr double most_points_a_cell = 64;

bool is_scattered(const PointSet& points, double reach)
{
    return std::pow(reach, -points.dimension) > most_points_a_cell * static_cast<double>(points.size());
}

}

template <typename Region>
PointSet eliminate_in_region(const Region& region, const PointSet& all, std::size_t kept, double area,
                             const DistributionPlace& place)
{
    std::optional<SampleElimination> elimination;
    if (place.engine != Engine::reference) {
        check_fits("sample elimination", SampleElimination::memory(all.dimension, all.size(), kept, area, true),
                   place.device().info());
        elimination.emplace(place.device());
    }
    const RemovalOrder order = [&](const PointSet& points, const EliminationReach& reach, std::size_t count) {
        const std::vector<std::uint32_t> factors = boundary_factors(region, points, reach);
        return elimination && !is_scattered(points, reach.most)
                   ? elimination->removal_order(points, reach, count, factors)
                   : reference::factored_removal_order(points, reach, count, factors);
    };
    return eliminate(all, kept, order, area);
}

template PointSet eliminate_in_region(const FixedRegion&, const PointSet&, std::size_t, double,
                                      const DistributionPlace&);
template PointSet eliminate_in_region(const FixedSpace&, const PointSet&, std::size_t, double,
                                      const DistributionPlace&);

}
