#include "host/sampling/started_sampler.hpp"

#include "host/sampling/baselines.hpp"

#include <fmt/format.h>

#include <utility>

namespace poissonlab {

ParameterSpec start_parameter()
{
    static const SamplerSpec random = random_sampler();
    return {.key = "start",
            .kind = ParameterSpec::Kind::sampler,
            .help = "the method that makes the sets to begin with",
            .otherwise = std::make_shared<const SamplerChoice>(SamplerChoice{&random, {}})};
}

std::size_t most_started_points(const Parameters& parameters, const SampleRequest& request)
{
    const SamplerChoice& start = parameters.sampler("start");
    return start.spec->most_points ? start.spec->most_points(start.parameters, request) : request.points;
}

void describe_start(SamplerSpec& spec, const MemoryOfPoints& memory)
{
    spec.follows_start = true;
    spec.most_points = most_started_points;
    spec.memory_growth = MemoryGrowth::linear;
    // The method's own memory comes beside what the start keeps.
    spec.device_memory = [memory](const Parameters& parameters, const SampleRequest& request,
                                  const DeviceInfo& device) {
        const SamplerChoice& start = parameters.sampler("start");
        DeviceMemory sum = memory(parameters, most_started_points(parameters, request), request.dimension);
        if (start.spec->device_memory) sum = sum + start.spec->device_memory(start.parameters, request, device);
        return sum;
    };
}

StartedSampler::StartedSampler(std::string what, MemoryOfPoints memory, const Parameters& parameters,
                               const SampleRequest& request, Engine engine, const DeviceProvider& device)
    : DeviceSampler(engine, device), parameters_(parameters), what_(std::move(what)), memory_(std::move(memory))
{
    const SamplerChoice& start = parameters.sampler("start");
    start_ = start.spec->create(start.parameters, request, engine, device);
}

PointSet StartedSampler::start(std::uint32_t realization)
{
    PointSet start = start_->sample(realization);
    if (!device_) return start;
    const DeviceMemory memory = memory_(parameters_, start.size(), start.dimension);
    const std::string what = fmt::format("{} of {} points", what_, start.size());
    if (!parameters_.is_given("start")) {
        check_fits(what, memory, device_->info());
    } else if (!fits(memory, device_->info())) {
        throw parameters_.error("start", fmt::format("{} {}; start from fewer points, or set engine = \"reference\", "
                                                     "which needs no device",
                                                     what, comparison(memory, device_->info())));
    }
    return start;
}

}
