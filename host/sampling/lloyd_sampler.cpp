// The sampler "lloyd": what the config can ask of Lloyd relaxation, and of the repulsion after it.
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/repulsion.hpp"
#include "host/sampling/started_sampler.hpp"

namespace poissonlab {
namespace {

/// Memory that an iteration needs, and CGAL's much more, limit what is worth asking for.
constexpr std::int64_t max_iterations = 1'000'000;

RepulsionRequest repulsion_request(double relative_radius, std::size_t points, int dimension)
{
    return {min_distance_for(relative_radius, points, dimension)};
}

/// The memory of relaxation, or of repulsion after it, whichever is larger.
DeviceMemory relaxation_memory(const Parameters& parameters, std::size_t points, int dimension)
{
    const DeviceMemory relaxation = LloydRelaxation::memory(dimension, points);
    if (!parameters.flag("repulsion")) return relaxation;
    const RepulsionRequest repulsion = repulsion_request(parameters.number("until_relative_radius"), points, dimension);
    return either(relaxation, Repulsion::memory(dimension, points, repulsion));
}

class LloydSampler final : public StartedSampler
{
public:
    LloydSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                 const DeviceProvider& device)
        : StartedSampler("Lloyd relaxation", relaxation_memory, parameters, request, engine, device),
          request_(lloyd_request(parameters)), repels_(parameters.flag("repulsion"))
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const Domain torus;
        const PointSet points = start(realization);
        LloydResult result = device_ ? LloydRelaxation(*device_).relax(points, torus, request_)
                                     : reference::relax(points, torus, request_);
        iterations_ = std::move(result.iterations);
        if (repels_) {
            const RepulsionRequest repulsion =
                repulsion_request(request_.until_relative_radius, points.size(), points.dimension);
            result.points = device_ ? Repulsion(*device_).repel(result.points, torus, repulsion).points
                                    : reference::repel(result.points, torus, repulsion).points;
        }
        return std::move(result.points);
    }

private:
    LloydRequest request_;
    bool repels_;
};

std::vector<ParameterSpec> parameters()
{
    using Kind = ParameterSpec::Kind;
    return {
        {.key = "iterations",
         .kind = Kind::integer,
         .help = "Lloyd iterations, at most; 0 with repulsion = true for repulsion alone",
         .maximum = max_iterations,
         .symbol = "i"},
        start_parameter(),
        {.key = "until_relative_radius",
         .help = "stop at the first iterate that has this relative radius; the aim of repulsion as well",
         .maximum = 1,
         .exclusive_minimum = true,
         .symbol = "until",
         .unless_given = "all iterations are made"},
        {.key = "keep",
         .kind = Kind::choice,
         .help = "the iterate to give: the last, or the best, of the largest relative radius",
         .choices = {"last", "best"},
         .otherwise = "last"},
        {.key = "repulsion",
         .kind = Kind::boolean,
         .help = "push apart what is closer than until_relative_radius after the last iteration",
         .otherwise = false},
    };
}

void check_lloyd(const Parameters& parameters, const SampleRequest&, const SourceLocation& where)
{
    if (!parameters.is_given("iterations"))
        throw InputError::at(where, "sampler = \"lloyd\": needs iterations, such as 100");
    if (parameters.flag("repulsion") && !parameters.is_given("until_relative_radius")) {
        throw parameters.error("repulsion", "needs until_relative_radius, the relative radius that it is to reach");
    }
}

}

LloydRequest lloyd_request(const Parameters& parameters)
{
    LloydRequest request{.iterations = static_cast<std::size_t>(parameters.integer("iterations")),
                         .keep_best = parameters.text("keep") == "best"};
    if (parameters.is_given("until_relative_radius"))
        request.until_relative_radius = parameters.number("until_relative_radius");
    return request;
}

SamplerSpec lloyd_sampler()
{
    SamplerSpec spec;
    spec.name = "lloyd";
    spec.title = "Lloyd relaxation";
    spec.summary = "points of another method, moved to the centroids of their Voronoi cells again and again";
    spec.dimensions = {2, 3};
    spec.parameters = parameters();
    spec.check = check_lloyd;
    describe_start(spec, relaxation_memory);
    spec.kernels = {"point_grid.cl", "voronoi_2d.cl", "relaxation.cl", "repulsion.cl"};
    spec.kernels_in_space = {"voronoi_3d_fast.cl", "voronoi_3d_slow.cl"};
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<LloydSampler>(given, request, engine, device);
    };
    return spec;
}

}
