// The sampler "gaussian-blue-noise": what the config can ask of it.
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/density_parameters.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/started_sampler.hpp"
#include "host/sampling/warp/warp.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// The density that is given; one that is the same everywhere is none.
std::shared_ptr<const Density> followed_density(const Parameters& parameters)
{
    auto density = given_density(parameters);
    if (!density || std::ranges::adjacent_find(density->weights, std::ranges::not_equal_to{}) == density->weights.end())
        return nullptr;
    return std::make_shared<const Density>(std::move(*density));
}

DeviceMemory memory_with(const Density* density, double sigma, std::size_t points, int dimension)
{
    return density == nullptr ? GaussianBlueNoise::memory(sigma, points, dimension)
                              : GaussianBlueNoise::memory(gaussian_field_shape(*density, sigma, points), points);
}

DeviceMemory gaussian_memory(const Parameters& parameters, std::size_t points, int dimension)
{
    return memory_with(followed_density(parameters).get(), parameters.number("sigma"), points, dimension);
}

/// Even points, warped as the density is: they crowd where it is large.
PointSet warped_start(const PointSet& points, const WarpTable& table)
{
    SquarePoints even;
    for (const double c : points.coordinates) even.push_back(static_cast<std::uint32_t>(c * 0x1p32));
    PointSet warped{2, {}};
    for (const std::uint64_t place : reference::warp_points(table, even))
        warped.coordinates.push_back(place_coordinate(place, table.width));
    return warped;
}

/// The number that the start is asked for: the points of the coarsest level.
SampleRequest start_request(const Parameters& parameters, SampleRequest request)
{
    request.points = level_points(request.points, request.dimension, parameters.integer("levels")).front();
    return request;
}

class GaussianSampler final : public StartedSampler
{
public:
    GaussianSampler(const Parameters& parameters, const SampleRequest& request, Engine engine,
                    const DeviceProvider& device, const std::shared_ptr<const Density>& density)
        : StartedSampler(
              "Gaussian blue noise",
              [density](const Parameters& given, std::size_t points, int dimension) {
                  return memory_with(density.get(), given.number("sigma"), points, dimension);
              },
              parameters, start_request(parameters, request), engine, device),
          density_(density), asked_(request), request_(gaussian_request(parameters, request.dimension))
    {}

    PointSet sample(std::uint32_t realization) override
    {
        PointSet points = start(realization);
        const std::size_t least = least_gaussian_points(request_.sigma, points.dimension);
        if (points.size() < least) throw too_few(parameters_, points.size(), least);
        iterations_.clear();
        if (density_) points = follow_density(points);
        points = descended(points);
        const auto levels = level_points(asked_.points, asked_.dimension, parameters_.integer("levels"));
        for (std::size_t level = 1; level < levels.size(); ++level)
            points = descended(split_points(points, levels[level]));
        return points;
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
    /// The start in places that the density chooses; from now on the density has a field for as many points.
    PointSet follow_density(const PointSet& points)
    {
        if (!table_) table_.emplace(*density_);
        if (!request_.field || points.size() != field_points_)
            request_.field = std::make_shared<const GaussianField>(
                gaussian_field(*density_, request_.sigma, request_.step, points.size()));
        field_points_ = points.size();
        return warped_start(points, *table_);
    }

    /// Moves the points of a level; the records of its iterations follow those of the levels before.
    PointSet descended(const PointSet& points)
    {
        LloydResult result =
            device_ ? GaussianBlueNoise(*device_).descend(points, request_) : reference::descend(points, request_);
        iterations_.insert(iterations_.end(), result.iterations.begin(), result.iterations.end());
        return std::move(result.points);
    }

    std::shared_ptr<const Density> density_;
    SampleRequest asked_;
    GaussianRequest request_;
    std::optional<WarpTable> table_;
    std::size_t field_points_ = 0; ///< for which the field is
};

std::vector<ParameterSpec> gaussian_parameters()
{
    std::vector<ParameterSpec> parameters{
        {.key = "iterations",
         .kind = ParameterSpec::Kind::integer,
         .help = "steps that all points take, on each level",
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
        {.key = "levels",
         .kind = ParameterSpec::Kind::integer,
         .help = "coarser sets to begin with, of a quarter (3D: an eighth) as many points each, whose points are then "
                 "split: large sets get even at large distances in fewer iterations",
         .maximum = 10,
         .otherwise = std::int64_t{0}},
        start_parameter(),
    };
    for (ParameterSpec& spec : density_parameters()) parameters.push_back(std::move(spec));
    return parameters;
}

/// Densities are over the plane, and for sets of one level.
void check_density(const Parameters& parameters, const SampleRequest& request)
{
    if (parameters.is_given("density")) {
        if (request.dimension != 2) throw parameters.error("density", "is for sets in 2D");
        if (parameters.integer("levels") > 0)
            throw parameters.error("levels", "cannot be combined with a density; leave it out");
    }
    given_density(parameters);
}

void check_gaussians(const Parameters& parameters, const SampleRequest& request, const SourceLocation& where)
{
    check_density(parameters, request);
    const std::size_t least = least_gaussian_points(parameters.number("sigma"), request.dimension);
    const bool has_levels = parameters.integer("levels") > 0;
    if (has_levels && parameters.sampler("start").spec->has_own_points)
        throw parameters.error(
            "levels", "cannot be combined with a start whose sets have their own number of points; leave it out");
    const std::size_t points = most_started_points(parameters, start_request(parameters, request));
    if (points >= least) return;
    if (has_levels)
        throw parameters.error(
            "levels", fmt::format("the coarsest sets would have {} points, and need at least {}", points, least));
    if (parameters.is_given("sigma")) throw GaussianSampler::too_few(parameters, points, least);
    throw InputError::at(where, fmt::format("Gaussian blue noise needs at least {} points in {}D, where its "
                                            "Gaussians do not reach around the torus; here are {}",
                                            least, request.dimension, points));
}

/// The finest level takes the most; the start makes sets for the coarsest one.
DeviceMemory memory_of_levels(const Parameters& parameters, const SampleRequest& request, const DeviceInfo& device)
{
    const SamplerChoice& start = parameters.sampler("start");
    const SampleRequest coarsest = start_request(parameters, request);
    const bool has_levels = parameters.integer("levels") > 0;
    const std::size_t points = has_levels ? request.points : most_started_points(parameters, request);
    const DeviceMemory memory = gaussian_memory(parameters, points, request.dimension);
    if (!start.spec->device_memory) return memory;
    return memory + start.spec->device_memory(start.parameters, coarsest, device);
}

}

GaussianRequest gaussian_request(const Parameters& parameters, int dimension)
{
    const double sigma = parameters.number("sigma");
    return {.iterations = static_cast<std::size_t>(parameters.integer("iterations")),
            .sigma = sigma,
            .step = parameters.is_given("step") ? parameters.number("step") : usual_gaussian_step(sigma, dimension)};
}

SamplerSpec gaussian_blue_noise_sampler()
{
    SamplerSpec spec = plain_spec("gaussian-blue-noise", "Gaussian blue noise",
                                  "points that descend the sum of the Gaussians of all pairs (Ahmed, Ren, Wonka 2022)",
                                  {2, 3}, gaussian_parameters());
    spec.check = check_gaussians;
    describe_start(spec, gaussian_memory);
    spec.device_memory = memory_of_levels;
    spec.outside_input = density_hash;
    spec.kernels = {"gaussian_blue_noise.cl", "point_grid.cl", "relaxation.cl"};
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<GaussianSampler>(given, request, engine, device, followed_density(given));
    };
    return spec;
}

}
