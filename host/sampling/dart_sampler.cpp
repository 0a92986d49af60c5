#include "host/sampling/dart_sampler.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/device_sampler.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

/// Saturated sets on tori of equal size differ in their number of points: its variance is S(0) N, with the
/// structure factor at zero frequency S(0) = 0.059 in 2D and 0.050 in 3D (Zhang and Torquato 2013).
constexpr double saturation_structure_factor = 0.06;

bool to_saturation(const Parameters& parameters) { return parameters.text("stop") == "saturation"; }

/// The minimum distance of the sets: asked for, or derived from the number of points.
double min_distance_of(const Parameters& parameters, const SampleRequest& request)
{
    if (!to_saturation(parameters)) {
        return min_distance_for(parameters.number("relative_radius"), request.points, request.dimension);
    }
    if (parameters.is_given("min_distance")) return parameters.number("min_distance");
    return min_distance_for(saturation_relative_radius(request.dimension), request.points, request.dimension);
}

DartThrowingRequest darts_of(const Parameters& parameters, const SampleRequest& request)
{
    DartThrowingRequest darts;
    darts.dimension = request.dimension;
    darts.min_distance = min_distance_of(parameters, request);
    if (!to_saturation(parameters)) darts.points = request.points;
    return darts;
}

/// The most points that a set has: at saturation, six standard deviations above the mean.
std::size_t most_points(const Parameters& parameters, const SampleRequest& request)
{
    if (!to_saturation(parameters)) return request.points;
    const double ratio = saturation_relative_radius(request.dimension) /
                         relative_radius(min_distance_of(parameters, request), 1, request.dimension);
    const double mean = std::pow(ratio, request.dimension);
    return static_cast<std::size_t>(mean + 6.0 * std::sqrt(saturation_structure_factor * mean)) + 1;
}

/// Is a relative radius out of reach by more than six standard deviations of the number of points at
/// saturation?
bool is_hopeless(double relative_radius, const SampleRequest& request)
{
    const auto n = static_cast<double>(request.points);
    const double expected =
        n * std::pow(saturation_relative_radius(request.dimension) / relative_radius, request.dimension);
    return expected + 6.0 * std::sqrt(saturation_structure_factor * expected) < n;
}

void check_points(const std::string& name, const Parameters& parameters, const SampleRequest& request,
                  const SourceLocation& where)
{
    if (!parameters.is_given("relative_radius")) {
        throw InputError::at(where,
                             fmt::format("sampler = \"{}\": needs relative_radius, or stop = \"saturation\"", name));
    }
    if (parameters.is_given("min_distance")) {
        throw parameters.error("min_distance", "needs stop = \"saturation\"; relative_radius sets the distance here");
    }
    if (is_hopeless(parameters.number("relative_radius"), request)) {
        throw parameters.error("relative_radius",
                               fmt::format("dart throwing of {} points saturates at a relative radius of about {:.4f} "
                                           "in {}D; ask for less",
                                           request.points, saturation_relative_radius(request.dimension),
                                           request.dimension));
    }
}

void check_saturation(const Parameters& parameters)
{
    if (parameters.is_given("relative_radius")) {
        throw parameters.error("relative_radius",
                               "cannot be combined with stop = \"saturation\"; min_distance sets the distance here");
    }
}

/// The grid of cells grows as the distance shrinks, whatever the number of points.
void check_memory(const Parameters& parameters, const SampleRequest& request)
{
    const double min_distance = min_distance_of(parameters, request);
    if (level_0_cells(min_distance, request.dimension) <= max_level_0_cells) return;
    const double smallest = std::sqrt(static_cast<double>(request.dimension)) /
                            std::pow(max_level_0_cells, 1.0 / request.dimension) * 1.001;
    for (const char* key : {"min_distance", "relative_radius"}) {
        if (!parameters.is_given(key)) continue;
        const double scale = parameters.number(key) / min_distance;
        throw parameters.error(key, fmt::format("needs a finer grid than memory has room for; at least {:.3g} for {} "
                                                "points in {}D",
                                                smallest * scale, request.points, request.dimension));
    }
    throw parameters.error("stop", fmt::format("{} points are too many", request.points));
}

class DartSampler final : public DeviceSampler
{
public:
    DartSampler(const DartMethod& method, const Parameters& parameters, const SampleRequest& request, Engine engine,
                const DeviceProvider& device)
        : DeviceSampler(engine, device), parameters_(parameters), request_(request), purpose_(method.purpose),
          throw_darts_(method.thrower(device_))
    {}

    PointSet sample(std::uint32_t realization) override
    {
        DartThrowingRequest request = darts_of(parameters_, request_);
        request.stream = stream_key(request_.seed, purpose_, realization);
        PointSet points = throw_darts_(request);
        if (!to_saturation(parameters_) && points.size() < request_.points)
            throw saturated_early(points.size(), realization);
        return points;
    }

    SetTraits traits() const override { return {.sizes_vary = to_saturation(parameters_)}; }

private:
    /// The radius at which the set would have reached its size grows with the number of points as a length
    /// does.
    InputError saturated_early(std::size_t reached, std::uint32_t realization) const
    {
        const double asked = parameters_.number("relative_radius");
        const double share = static_cast<double>(reached) / static_cast<double>(request_.points);
        return parameters_.error(
            "relative_radius",
            fmt::format("realization {} is saturated with {} of {} points: no further one fits; a relative radius of "
                        "about {:.4f} can be reached",
                        realization, reached, request_.points, asked * std::pow(share, 1.0 / request_.dimension)));
    }

    Parameters parameters_;
    SampleRequest request_;
    Purpose purpose_;
    ThrowDarts throw_darts_;
};

std::vector<ParameterSpec> dart_parameters()
{
    return {
        {.key = "relative_radius",
         .help = "minimum distance over that of the densest packing of as many points; at most about 0.77 in 2D",
         .maximum = 1,
         .exclusive_minimum = true,
         .symbol = "rho",
         .unless_given = "needed unless stop = \"saturation\""},
        {.key = "stop",
         .kind = ParameterSpec::Kind::choice,
         .help = "when to stop: at analysis.points points, or when no further point fits",
         .choices = {"points", "saturation"},
         .otherwise = "points"},
        {.key = "min_distance",
         .help = "with stop = \"saturation\": the minimum distance",
         .unit = "units of the torus' side",
         .maximum = 1,
         .exclusive_minimum = true,
         .symbol = "d",
         .unless_given = "by default what gives about analysis.points points"},
    };
}

}

SamplerSpec dart_sampler(const DartMethod& method)
{
    SamplerSpec spec;
    spec.name = method.name;
    spec.title = method.title;
    spec.summary = method.summary;
    spec.dimensions = method.dimensions;
    spec.parameters = dart_parameters();
    spec.check = [name = method.name](const Parameters& given, const SampleRequest& request,
                                      const SourceLocation& where) {
        if (to_saturation(given)) {
            check_saturation(given);
        } else {
            check_points(name, given, request, where);
        }
        check_memory(given, request);
    };
    spec.most_points = most_points;
    spec.kernels = method.kernels;
    spec.memory_growth = MemoryGrowth::linear;
    spec.device_memory = [memory = method.memory](const Parameters& given, const SampleRequest& request,
                                                  const DeviceInfo& device) {
        return memory(darts_of(given, request), device);
    };
    spec.create = [method](const Parameters& given, const SampleRequest& request, Engine engine,
                           const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<DartSampler>(method, given, request, engine, device);
    };
    return spec;
}

SamplerSpec dart_throwing_sampler()
{
    return dart_sampler({.name = "dart-throwing",
                         .title = "Dart throwing",
                         .summary = "random darts, rejected where nearer than the minimum distance to an earlier one",
                         .dimensions = {2, 3},
                         .purpose = Purpose::dart_throwing,
                         .kernels = {"dart_throwing.cl", "darts_in_order.cl", "darts_in_rounds.cl"},
                         .memory = DartThrower::memory,
                         .thrower = thrower_by<DartThrower, reference::throw_darts>});
}

}
