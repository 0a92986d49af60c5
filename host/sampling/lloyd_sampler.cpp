// The sampler "lloyd": what the config can ask of Lloyd relaxation, and of the repulsion after it.
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/baselines.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/repulsion.hpp"

#include <fmt/format.h>

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

class LloydSampler final : public DeviceSampler
{
public:
    LloydSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                 const DeviceProvider& device)
        : DeviceSampler(engine, device), parameters_(parameters)
    {
        const SamplerChoice& start = parameters.sampler("start");
        start_ = start.spec->create(start.parameters, request, engine, device);
        request_.iterations = static_cast<std::size_t>(parameters.integer("iterations"));
        if (parameters.is_given("until_relative_radius")) {
            request_.until_relative_radius = parameters.number("until_relative_radius");
        }
        request_.keep_best = parameters.text("keep") == "best";
        repels_ = parameters.flag("repulsion");
    }

    PointSet sample(std::uint32_t realization) override
    {
        const Domain torus;
        const PointSet start = start_->sample(realization);
        if (device_) check_memory(start);
        LloydResult result = device_ ? LloydRelaxation(*device_).relax(start, torus, request_)
                                     : reference::relax(start, torus, request_);
        iterations_ = std::move(result.iterations);
        if (repels_) {
            const RepulsionRequest repulsion =
                repulsion_request(request_.until_relative_radius, start.size(), start.dimension);
            result.points = device_ ? Repulsion(*device_).repel(result.points, torus, repulsion).points
                                    : reference::repel(result.points, torus, repulsion).points;
        }
        return std::move(result.points);
    }

    bool sizes_vary() const override { return start_->sizes_vary(); }
    std::vector<IterationRecord> iterations() const override { return iterations_; }

private:
    /// Starts from files and programs have as many points as they have.
    void check_memory(const PointSet& start) const
    {
        const DeviceMemory memory = relaxation_memory(parameters_, start.size(), start.dimension);
        const std::string what = fmt::format("Lloyd relaxation of {} points", start.size());
        if (!parameters_.is_given("start")) return check_fits(what, memory, device_->info());
        if (!fits(memory, device_->info()))
            throw parameters_.error("start",
                                    fmt::format("{} {}; start from fewer points, or set engine = \"reference\", "
                                                "which needs no device",
                                                what, comparison(memory, device_->info())));
    }

    Parameters parameters_;
    std::unique_ptr<Sampler> start_;
    LloydRequest request_;
    bool repels_ = false;
    std::vector<IterationRecord> iterations_;
};

std::vector<ParameterSpec> parameters()
{
    using Kind = ParameterSpec::Kind;
    static const SamplerSpec random = random_sampler();
    return {
        {.key = "iterations",
         .kind = Kind::integer,
         .help = "Lloyd iterations, at most; 0 with repulsion = true for repulsion alone",
         .maximum = max_iterations,
         .symbol = "i"},
        {.key = "start",
         .kind = Kind::sampler,
         .help = "the method that makes the sets to begin with",
         .otherwise = std::make_shared<const SamplerChoice>(SamplerChoice{&random, {}})},
        {.key = "until_relative_radius",
         .help = "stop at the first iterate that has this relative radius; the aim of repulsion as well",
         .maximum = 1,
         .exclusive_minimum = true,
         .symbol = "until",
         .unless_given = "by default all iterations are made"},
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

std::size_t most_relaxed_points(const Parameters& parameters, const SampleRequest& request)
{
    const SamplerChoice& start = parameters.sampler("start");
    return start.spec->most_points ? start.spec->most_points(start.parameters, request) : request.points;
}

/// Beside what the start keeps.
DeviceMemory device_memory(const Parameters& parameters, const SampleRequest& request, const DeviceInfo& device)
{
    const SamplerChoice& start = parameters.sampler("start");
    DeviceMemory memory = relaxation_memory(parameters, most_relaxed_points(parameters, request), request.dimension);
    if (start.spec->device_memory) memory = memory + start.spec->device_memory(start.parameters, request, device);
    return memory;
}

void check_lloyd(const Parameters& parameters, const SampleRequest&, const SourceLocation& where)
{
    if (!parameters.is_given("iterations")) throw InputError::at(where, "sampler = \"lloyd\": needs iterations");
    if (parameters.flag("repulsion") && !parameters.is_given("until_relative_radius")) {
        throw parameters.error("repulsion", "needs until_relative_radius, the relative radius that it is to reach");
    }
}

}

SamplerSpec lloyd_sampler()
{
    SamplerSpec spec;
    spec.name = "lloyd";
    spec.title = "Lloyd relaxation";
    spec.summary = "points of another method, moved to the centroids of their Voronoi cells again and again";
    spec.dimensions = {2, 3};
    spec.parameters = parameters();
    spec.follows_start = true;
    spec.check = check_lloyd;
    spec.most_points = most_relaxed_points;
    spec.device_memory = device_memory;
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<LloydSampler>(given, request, engine, device);
    };
    return spec;
}

}
