// The sampler "relaxation-dart-throwing": what the config can ask of relaxation dart throwing, and what it is
// told when that is impossible.
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace poissonlab {
namespace {

/// A set that needs more darts than this would take weeks.
constexpr double most_relaxation_darts = 1e15;

RelaxationDartThrowingRequest request_for(const Parameters& parameters, const SampleRequest& request)
{
    RelaxationDartThrowingRequest result;
    result.dimension = request.dimension;
    result.points = request.points;
    result.initial_radius = parameters.number("initial_radius");
    result.factor = parameters.number("factor");
    result.attempts = static_cast<std::uint64_t>(parameters.integer("attempts"));
    return result;
}

/// The darts that fail before the radius is that of a saturated set, from below: `attempts` a level.
double least_darts(const RelaxationDartThrowingRequest& request)
{
    const double final_radius =
        0.5 * min_distance_for(saturation_relative_radius(request.dimension), request.points, request.dimension);
    const double levels = std::log(final_radius / request.initial_radius) / std::log(request.factor);
    return std::max(levels, 0.0) * static_cast<double>(request.attempts);
}

void check_effort(const Parameters& parameters, const SampleRequest& request, const SourceLocation& where)
{
    const double darts = least_darts(request_for(parameters, request));
    if (darts <= most_relaxation_darts) return;
    const std::string problem = fmt::format(
        "{} points would take some {:.0e} darts; take a smaller factor or fewer attempts", request.points, darts);
    for (const char* key : {"factor", "attempts"}) {
        if (parameters.is_given(key)) throw parameters.error(key, problem);
    }
    throw InputError::at(where, "sampler = \"relaxation-dart-throwing\": " + problem);
}

class RelaxationDartThrowingSampler final : public DeviceSampler
{
public:
    RelaxationDartThrowingSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                                  const DeviceProvider& device)
        : DeviceSampler(engine, device), request_(request_for(parameters, request)), seed_(request.seed)
    {
        if (device_) thrower_.emplace(*device_);
    }

    PointSet sample(std::uint32_t realization) override
    {
        request_.stream = stream_key(seed_, Purpose::relaxation_dart_throwing, realization);
        RelaxationDarts darts =
            thrower_ ? thrower_->throw_darts(request_) : reference::throw_relaxation_darts(request_);
        return std::move(darts.points);
    }

    SetTraits traits() const override { return {.is_progressive = true}; }

private:
    RelaxationDartThrowingRequest request_;
    std::uint64_t seed_;
    std::optional<RelaxationDartThrower> thrower_;
};

}

SamplerSpec relaxation_dart_throwing_sampler()
{
    SamplerSpec spec;
    spec.name = "relaxation-dart-throwing";
    spec.title = "Relaxation dart throwing";
    spec.summary = "dart throwing with a radius that is reduced where darts keep failing; every prefix of a set is "
                   "well spread";
    spec.dimensions = {2, 3};
    const RelaxationDartThrowingRequest otherwise;
    spec.parameters = {
        {.key = "initial_radius",
         .help = "r, half the minimum distance, to begin with",
         .unit = "units of the torus' side",
         .maximum = 0.5,
         .exclusive_minimum = true,
         .symbol = "r0",
         .otherwise = otherwise.initial_radius},
        {.key = "factor",
         .help = "what the radius is multiplied by when darts keep failing",
         .maximum = 1,
         .exclusive_minimum = true,
         .exclusive_maximum = true,
         .otherwise = otherwise.factor},
        {.key = "attempts",
         .kind = ParameterSpec::Kind::integer,
         .help = "failed darts in a row after which the radius is reduced",
         .minimum = 1,
         .maximum = static_cast<double>(max_relaxation_attempts),
         .otherwise = static_cast<std::int64_t>(otherwise.attempts)},
    };
    spec.check = check_effort;
    spec.memory_growth = MemoryGrowth::linear;
    spec.device_memory = [](const Parameters& parameters, const SampleRequest& request, const DeviceInfo&) {
        return RelaxationDartThrower::memory(request_for(parameters, request));
    };
    spec.kernels = {"relaxation_dart_throwing.cl"};
    spec.create = [](const Parameters& parameters, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<RelaxationDartThrowingSampler>(parameters, request, engine, device);
    };
    return spec;
}

}
