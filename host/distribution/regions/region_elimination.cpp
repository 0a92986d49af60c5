#include "host/distribution/regions/region_elimination.hpp"

#include "host/device/device_memory.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "host/sampling/regions/region_candidates.hpp"

#include <optional>

namespace poissonlab {

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
        return elimination ? elimination->removal_order(points, reach, count, factors)
                           : reference::factored_removal_order(points, reach, count, factors);
    };
    return eliminate(all, kept, order, area);
}

template PointSet eliminate_in_region(const FixedRegion&, const PointSet&, std::size_t, double,
                                      const DistributionPlace&);
template PointSet eliminate_in_region(const FixedSpace&, const PointSet&, std::size_t, double,
                                      const DistributionPlace&);

}
