// The sampler "farthest-point": what the config can ask of farthest point optimization.
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/optimized/farthest_point.hpp"
#include "host/sampling/started_sampler.hpp"

namespace poissonlab {
namespace {

DeviceMemory farthest_point_memory(const Parameters&, std::size_t points, int)
{
    return FarthestPointOptimization::memory(points);
}

class FarthestPointSampler final : public StartedSampler
{
public:
    FarthestPointSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                         const DeviceProvider& device)
        : StartedSampler("farthest point optimization", farthest_point_memory, parameters, request, engine, device),
          request_{.iterations = static_cast<std::size_t>(parameters.integer("iterations")),
                   .until_relative_radius = parameters.number("until_relative_radius")}
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const PointSet points = start(realization);
        LloydResult result = device_ ? FarthestPointOptimization(*device_).optimize(points, request_)
                                     : reference::move_to_farthest(points, request_);
        iterations_ = std::move(result.iterations);
        return std::move(result.points);
    }

private:
    LloydRequest request_;
};

}

SamplerSpec farthest_point_sampler()
{
    SamplerSpec spec = plain_spec(
        "farthest-point", "Farthest point optimization",
        "points that move to where their neighbours leave the largest empty circle (Schloemer and others 2011)", {2},
        {
            {.key = "iterations",
             .kind = ParameterSpec::Kind::integer,
             .help = "sweeps, at most, in which each point moves once",
             .maximum = 1'000'000,
             .symbol = "i",
             .otherwise = std::int64_t{10000}},
            start_parameter(),
            {.key = "until_relative_radius",
             .help = "stop after the first sweep that reaches this relative radius",
             .maximum = 1,
             .exclusive_minimum = true,
             .symbol = "until",
             .otherwise = 0.925},
        });
    describe_start(spec, farthest_point_memory);
    spec.kernels = {"farthest_point.cl", "point_grid.cl", "voronoi_2d.cl", "relaxation.cl"};
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<FarthestPointSampler>(given, request, engine, device);
    };
    return spec;
}

}
