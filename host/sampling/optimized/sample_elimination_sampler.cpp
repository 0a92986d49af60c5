// The sampler "sample-elimination": random points of which elimination keeps some, in progressive order.
#include "base/geometry/torus.hpp"
#include "base/random/random.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"

#include <optional>
#include <span>

namespace poissonlab {
namespace {

std::size_t candidates_of(const Parameters& parameters, const SampleRequest& request)
{
    return request.points * static_cast<std::size_t>(parameters.integer("candidates"));
}

template <int D>
PointSet random_candidates(std::size_t count, const StreamKey& stream)
{
    std::vector<TorusPoint<D>> points(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto words = philox({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i >> 32), 0, 0}, stream);
        std::copy_n(words.begin(), D, points[i].begin());
    }
    return to_point_set<D>(std::span<const TorusPoint<D>>(points));
}

class EliminationSampler final : public DeviceSampler
{
public:
    EliminationSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                       const DeviceProvider& device)
        : DeviceSampler(engine, device), request_(request), candidates_(candidates_of(parameters, request))
    {
        if (device_) elimination_.emplace(*device_);
    }

    PointSet sample(std::uint32_t realization) override
    {
        const StreamKey stream = stream_key(request_.seed, Purpose::sample_elimination, realization);
        const PointSet candidates = request_.dimension == 2 ? random_candidates<2>(candidates_, stream)
                                                            : random_candidates<3>(candidates_, stream);
        if (!elimination_) return eliminate(candidates, request_.points, reference::removal_order);
        return eliminate(candidates, request_.points,
                         [&](const PointSet& points, const EliminationReach& reach, std::size_t count) {
                             return elimination_->removal_order(points, reach, count);
                         });
    }

    SetTraits traits() const override { return {.is_progressive = true}; }

private:
    SampleRequest request_;
    std::size_t candidates_;
    std::optional<SampleElimination> elimination_;
};

}

SamplerSpec sample_elimination_sampler()
{
    SamplerSpec spec = plain_spec(
        "sample-elimination", "Sample elimination",
        "random points without those that have others nearest; every prefix is well spread (Yuksel 2015)", {2, 3},
        {{.key = "candidates",
          .kind = ParameterSpec::Kind::integer,
          .help = "random points to begin with, for each point that is kept",
          .minimum = 1,
          .maximum = 30,
          .otherwise = std::int64_t{5}}});
    spec.memory_growth = MemoryGrowth::linear;
    spec.device_memory = [](const Parameters& parameters, const SampleRequest& request, const DeviceInfo&) {
        return SampleElimination::memory(request.dimension, candidates_of(parameters, request), request.points);
    };
    spec.kernels = {"point_grid.cl", "sample_elimination.cl"};
    spec.create = [](const Parameters& parameters, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<EliminationSampler>(parameters, request, engine, device);
    };
    return spec;
}

}
