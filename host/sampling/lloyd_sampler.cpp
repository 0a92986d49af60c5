// The sampler "lloyd": what the config can ask of Lloyd relaxation, and of the repulsion after it.
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/lloyd_sets.hpp"
#include "host/sampling/repulsion.hpp"
#include "host/sampling/sets_ahead.hpp"
#include "host/sampling/started_sampler.hpp"

#include <algorithm>

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

/// The most sets that are relaxed side by side: few enough for some to be finished soon, and stored. 0 where that is
/// not all that is asked of each.
std::size_t sets_at_once(const LloydRequest& request, std::size_t points, int dimension)
{
    if (points == 0 || dimension != 2 || request.keep_best || request.until_relative_radius <= 1) return 0;
    constexpr std::size_t moves_at_once = std::size_t{1} << 26; // seconds
    constexpr std::size_t points_of_record = 64;                // so that records of iterations stay few
    const std::size_t moves = std::max(points, points_of_record) * (request.iterations + 1);
    return std::min(LloydSets::most_sets(points), moves_at_once / moves);
}

class LloydSampler final : public StartedSampler
{
public:
    LloydSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                 const DeviceProvider& device)
        : StartedSampler("Lloyd relaxation", relaxation_memory, parameters, request, engine, device),
          request_(lloyd_request(parameters)), repels_(parameters.flag("repulsion"))
    {}

    void expect(std::uint32_t first, std::uint32_t count) override { sets_.expect(first, count); }

    PointSet sample(std::uint32_t realization) override
    {
        LloydResult result = device_ ? sets_.take(realization, *device_, [&] { return relax_from(realization); })
                                     : reference::relax(start(realization), {}, request_);
        iterations_ = std::move(result.iterations);
        if (repels_) {
            const PointSet& points = result.points;
            const RepulsionRequest repulsion =
                repulsion_request(request_.until_relative_radius, points.size(), points.dimension);
            result.points = device_ ? Repulsion(*device_).repel(points, {}, repulsion).points
                                    : reference::repel(points, {}, repulsion).points;
        }
        return std::move(result.points);
    }

    SetTraits traits() const override
    {
        SetTraits traits = StartedSampler::traits();
        if (!repels_) traits.shared_seconds = sets_.seconds();
        return traits;
    }

private:
    bool are_faster(std::size_t sets, std::size_t points) const
    {
        return LloydSets::are_faster(device_->info(), sets, points) &&
               fits(LloydSets::memory(sets, points), device_->info());
    }

    /// The start of a realization, and those of the sets that are relaxed beside it.
    std::vector<PointSet> starts_from(std::uint32_t realization)
    {
        std::vector<PointSet> starts{start(realization)};
        const std::size_t points = starts[0].size(), most = sets_at_once(request_, points, starts[0].dimension);
        const std::uint32_t count = sets_.expected_from(realization, most);
        if (StartedSampler::traits().sizes_vary || most == 0 || !are_faster(count, points)) return starts;
        try {
            while (starts.size() < count && starts.back().size() == points)
                starts.push_back(start(realization + static_cast<std::uint32_t>(starts.size())));
        } catch (const InputError&) {
            // A start that fails does so again in its turn, after the sets before it were stored.
        }
        if (starts.back().size() != points) starts.pop_back();
        return starts;
    }

    /// Relaxes the set of a realization, and those that are expected after it where they are faster side by side.
    std::vector<LloydResult> relax_from(std::uint32_t realization)
    {
        const std::vector<PointSet> starts = starts_from(realization);
        const bool has_few = sets_at_once(request_, starts[0].size(), starts[0].dimension) > 0;
        if (has_few && are_faster(starts.size(), starts[0].size()))
            return LloydSets(*device_).relax(starts, request_.iterations);
        return {LloydRelaxation(*device_).relax(starts[0], {}, request_)};
    }

    LloydRequest request_;
    bool repels_;
    SetsAhead<LloydResult> sets_;
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
    spec.device_memory = [of_one = spec.device_memory](const Parameters& given, const SampleRequest& request,
                                                       const DeviceInfo& device) {
        const std::size_t points = most_started_points(given, request);
        const bool is_processor = device.type == "CPU";
        const std::size_t sets = is_processor ? sets_at_once(lloyd_request(given), points, request.dimension) : 0;
        return of_one(given, request, device) + LloydSets::memory(sets, points);
    };
    spec.kernels = {"point_grid.cl", "voronoi_2d.cl", "relaxation.cl", "lloyd_sets.cl", "repulsion.cl"};
    spec.kernels_in_space = {"voronoi_3d_fast.cl", "voronoi_3d_slow.cl"};
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<LloydSampler>(given, request, engine, device);
    };
    return spec;
}

}
