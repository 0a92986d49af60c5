#include "host/sampling/optimized/ordered_sampler.hpp"

#include "host/sampling/device_sampler.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace poissonlab {
namespace {

/// The memory of putting so many points into order, of which half come first.
DeviceMemory ordering_memory(std::size_t points, int dimension)
{
    return SampleElimination::memory(dimension, points, std::max<std::size_t>(1, points / 2));
}

/// All else that a sampler says is said by the one that makes the sets.
class OrderedSampler final : public DeviceSampler
{
public:
    OrderedSampler(std::unique_ptr<Sampler> made, Parameters parameters, Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine, device), made_(std::move(made)), parameters_(std::move(parameters))
    {
        if (device_) elimination_.emplace(*device_);
    }

    PointSet sample(std::uint32_t realization) override
    {
        if (made_->traits().is_window)
            throw parameters_.error("order",
                                    "cannot be combined with this method: its sets are windows of the plane, and "
                                    "the order needs a torus; leave it out");
        const PointSet points = made_->sample(realization);
        const auto begin = std::chrono::steady_clock::now();
        const double built_before = build_seconds();
        PointSet ordered = in_order(points);
        const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
        ordering_seconds_ = all.count() - (build_seconds() - built_before);
        return ordered;
    }

    void expect(std::uint32_t first, std::uint32_t count) override { made_->expect(first, count); }

    /// Its share of the time of sets that are made side by side is that of making it, and its own time of ordering.
    SetTraits traits() const override
    {
        SetTraits traits = made_->traits();
        traits.is_progressive = true;
        if (traits.shared_seconds) *traits.shared_seconds += ordering_seconds_;
        return traits;
    }

private:
    PointSet in_order(const PointSet& points)
    {
        if (!elimination_) return eliminate(points, points.size(), reference::removal_order);
        return eliminate(points, points.size(),
                         [&](const PointSet& left, const EliminationReach& reach, std::size_t count) {
                             return elimination_->removal_order(left, reach, count);
                         });
    }

    std::unique_ptr<Sampler> made_;
    double ordering_seconds_ = 0; ///< of the last set
    Parameters parameters_;
    std::optional<SampleElimination> elimination_;
};

}

SamplerSpec in_progressive_order(SamplerSpec method)
{
    SamplerSpec spec = method;
    spec.memory_growth = MemoryGrowth::linear;
    spec.device_memory = [method](const Parameters& parameters, const SampleRequest& request,
                                  const DeviceInfo& device) {
        const std::size_t points = method.most_points ? method.most_points(parameters, request) : request.points;
        const DeviceMemory memory = ordering_memory(points, request.dimension);
        return method.device_memory ? memory + method.device_memory(parameters, request, device) : memory;
    };
    spec.create = [method = std::move(method)](const Parameters& parameters, const SampleRequest& request,
                                               Engine engine,
                                               const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<OrderedSampler>(method.create(parameters, request, engine, device), parameters, engine,
                                                device);
    };
    return spec;
}

}
