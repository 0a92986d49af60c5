#include "analysis/regions/framed_region.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "base/regions/region_source.hpp"
#include "host/distribution/region_samplers/region_method_samplers.hpp"
#include "host/distribution/regions/region_cells.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/regions/region_candidates.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

class RandomInRegionSampler final : public Sampler
{
public:
    explicit RandomInRegionSampler(SampleRequest request) : request_(std::move(request)) {}

    PointSet sample(std::uint32_t realization) override
    {
        const FixedRegion& region = request_.region->fixed();
        const double distance = max_min_distance(request_.points, 2) * std::sqrt(region.area());
        RegionCandidates candidates(region,
                                    stream_key(request_.seed, Purpose::random_points, realization, region_attempt),
                                    candidate_area(distance / (region.unit() * 0x1p32), 2));
        const std::vector<TorusPoint<2>> places = candidates.next(request_.points);
        if (places.size() < request_.points)
            throw InputError(fmt::format("random: the region {} has no room for {} points: darts into its box do not "
                                         "find it",
                                         request_.region->name(), request_.points));
        PointSet points{2, {}};
        for (const TorusPoint<2>& place : places)
            for (const double c : region.own(place)) points.coordinates.push_back(c);
        return as_in_files(request_.region->own_polygons(), std::move(points));
    }

private:
    SampleRequest request_;
};

}

SamplerSpec region_random_sampler()
{
    SamplerSpec spec = plain_spec("random", "Random", "independent uniform points", {2});
    spec.create = [](const Parameters&, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<RandomInRegionSampler>(request);
    };
    return spec;
}

}
