// The sampler "gaussian-blue-noise": what the config can ask of it.
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/started_sampler.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

DeviceMemory gaussian_memory(const Parameters& parameters, std::size_t points, int dimension)
{
    return GaussianBlueNoise::memory(parameters.number("sigma"), points, dimension);
}

class GaussianSampler final : public StartedSampler
{
public:
    GaussianSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                    const DeviceProvider& device)
        : StartedSampler("Gaussian blue noise", gaussian_memory, parameters, request, engine, device),
          request_{.iterations = static_cast<std::size_t>(parameters.integer("iterations")),
                   .sigma = parameters.number("sigma"),
                   .step = parameters.is_given("step")
                               ? parameters.number("step")
                               : usual_gaussian_step(parameters.number("sigma"), request.dimension)}
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const PointSet points = start(realization);
        const std::size_t least = least_gaussian_points(request_.sigma, points.dimension);
        if (points.size() < least) throw too_few(parameters_, points.size(), least);
        LloydResult result =
            device_ ? GaussianBlueNoise(*device_).descend(points, request_) : reference::descend(points, request_);
        iterations_ = std::move(result.iterations);
        return std::move(result.points);
    }

    static InputError too_few(const Parameters& parameters, std::size_t points, std::size_t least)
    {
        const std::string what = fmt::format("{} points are too few: Gaussians of this width reach around the torus; "
                                             "at least {}",
                                             points, least);
        for (const char* key : {"sigma", "start", "iterations"})
            if (parameters.is_given(key)) return parameters.error(key, what);
        return InputError("gaussian-blue-noise: " + what);
    }

private:
    GaussianRequest request_;
};

std::vector<ParameterSpec> gaussian_parameters()
{
    return {
        {.key = "iterations",
         .kind = ParameterSpec::Kind::integer,
         .help = "steps that all points take",
         .maximum = 1'000'000,
         .symbol = "i",
         .otherwise = std::int64_t{1000}},
        {.key = "sigma",
         .help = "width of the Gaussians",
         .unit = "mean distances of points",
         .minimum = 0.3,
         .maximum = 4,
         .otherwise = 1.0},
        {.key = "step",
         .help = "movement for a unit of force, stable below 1.7 times the default",
         .unit = "mean distances of points",
         .maximum = 1,
         .exclusive_minimum = true,
         .unless_given = "0.25 in 2D, 0.1 / sigma in 3D"},
        start_parameter(),
    };
}

void check_gaussians(const Parameters& parameters, const SampleRequest& request, const SourceLocation& where)
{
    const std::size_t least = least_gaussian_points(parameters.number("sigma"), request.dimension);
    const std::size_t points = most_started_points(parameters, request);
    if (points >= least) return;
    if (parameters.is_given("sigma")) throw GaussianSampler::too_few(parameters, points, least);
    throw InputError::at(where, fmt::format("sampler = gaussian-blue-noise: needs at least {} points in {}D, where its "
                                            "Gaussians do not reach around the torus; here are {}",
                                            least, request.dimension, points));
}

}

SamplerSpec gaussian_blue_noise_sampler()
{
    SamplerSpec spec = plain_spec("gaussian-blue-noise", "Gaussian blue noise",
                                  "points that descend the sum of the Gaussians of all pairs (Ahmed, Ren, Wonka 2022)",
                                  {2, 3}, gaussian_parameters());
    spec.check = check_gaussians;
    describe_start(spec, gaussian_memory);
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<GaussianSampler>(given, request, engine, device);
    };
    return spec;
}

}
