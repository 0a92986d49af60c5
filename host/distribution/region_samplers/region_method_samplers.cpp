#include "host/distribution/region_samplers/region_method_samplers.hpp"

#include "analysis/regions/framed_region.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_units.hpp"
#include "host/distribution/regions/region_points.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/sampling/regions/region_gaussian.hpp"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace poissonlab {
namespace {

/// Writes checked parameters into the settings, all but the region.
using ReadParameters = std::function<void(const Parameters&, const SampleRequest&, RegionPointSettings&)>;

/// A method in regions.
struct RegionMethodText
{
    RegionMethod method;
    std::string name, title, summary;
    std::vector<ParameterSpec> parameters;
    ReadParameters read;
    bool is_progressive = false; ///< the first points of its sets are sets of their own
};

/// A length of a region's own in which distances are measured that numbers of points decide.
double root_of_area(const SampleRequest& request) { return request.region->unit_length() * request.region->side(); }

/// The distance at which darts of a relative radius would be so many, boundaries aside.
double distance_at(double relative_radius, const SampleRequest& request)
{
    return min_distance_for(relative_radius, request.points, 2) * root_of_area(request);
}

RegionPointSettings settings_of(const RegionMethodText& text, const Parameters& given, const SampleRequest& request)
{
    RegionPointSettings settings;
    settings.method = text.method;
    const PlaneRegion& whole = request.region->own_polygons();
    settings.place.land = std::make_shared<const RegionLand>(RegionLand{whole, {}, whole});
    settings.place.boundary = *region_boundary_names.find(given.text("boundary"));
    text.read(given, request, settings);
    return settings;
}

/// The given parameter that decides how dense sets are; nothing where their number of points does.
std::optional<std::string> deciding_key(const Parameters& given)
{
    for (const char* key : {"min_distance", "relative_radius"})
        if (given.is_given(key)) return key;
    return std::nullopt;
}

/// An error of the whole set, at the parameter that decides it most, or at its method.
InputError error_of(const RegionMethodText& text, const Parameters& given, const SourceLocation& where,
                    const std::string& problem)
{
    if (const auto key = deciding_key(given)) return given.error(*key, problem);
    return InputError::at(where, fmt::format("sampler = \"{}\": {}", text.name, problem));
}

void check_method(const RegionMethodText& text, const Parameters& given, const SampleRequest& request,
                  const SourceLocation& where)
{
    if (text.method == RegionMethod::gaussian && request.points < least_points_of_region_gaussian())
        throw error_of(text, given, where,
                       fmt::format("{} points are too few: in a region at least {}", request.points,
                                   least_points_of_region_gaussian()));
    try {
        region_point_memory(settings_of(text, given, request), DeviceInfo{});
    } catch (const InputError& error) {
        throw error_of(text, given, where, error.what());
    }
}

/// Bridson's method is sequential by definition, and needs no device.
Engine engine_of(RegionMethod method, Engine asked)
{
    return method == RegionMethod::bridson ? Engine::reference : asked;
}

class RegionMethodSampler final : public DeviceSampler
{
public:
    RegionMethodSampler(const RegionMethodText& text, const Parameters& given, const SampleRequest& request,
                        Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine_of(text.method, engine), device), text_(text), given_(given), request_(request),
          settings_(settings_of(text, given, request)), place_{engine_of(text.method, engine), device, request.on_step}
    {
        traits_.is_progressive = text.is_progressive;
        traits_.sizes_vary = !settings_.place.points;
    }

    PointSet sample(std::uint32_t realization) override
    {
        try {
            const RegionDarts made = make_region_points(settings_, request_.seed, place_, realization);
            if (made.sure_distance > 0)
                traits_.proven_relative_radius =
                    relative_radius(made.sure_distance / root_of_area(request_), made.points.size(), 2);
            return made.file_points();
        } catch (const InputError& error) {
            throw error_of(text_, given_, {request_.region->name()},
                           fmt::format("realization {}: {}", realization, error.what()));
        }
    }

    SetTraits traits() const override { return traits_; }

private:
    RegionMethodText text_;
    Parameters given_;
    SampleRequest request_;
    RegionPointSettings settings_;
    DistributionPlace place_;
    SetTraits traits_;
};

/// Only darts know where the boundary is sampled first.
ParameterSpec boundary_parameter(RegionMethod method)
{
    std::vector<std::string> words = region_boundary_names.all();
    if (method != RegionMethod::darts) std::erase(words, std::string(region_boundary_names[RegionBoundary::on]));
    return {.key = "boundary",
            .kind = ParameterSpec::Kind::choice,
            .help = "what is inside: points, or whole disks of half the minimum distance around them" +
                    std::string(method == RegionMethod::darts ? "; or points that lie on the boundary first" : ""),
            .choices = words,
            .otherwise = std::string(region_boundary_names[RegionBoundary::inside])};
}

ParameterSpec distance_parameter(std::string unless_given)
{
    return {.key = "min_distance",
            .help = "the minimum distance",
            .unit = region_units,
            .maximum = 1e12,
            .exclusive_minimum = true,
            .symbol = "d",
            .unless_given = std::move(unless_given)};
}

ParameterSpec count_parameter(const char* key, const char* help, double least, double most, std::int64_t otherwise)
{
    return {.key = key,
            .kind = ParameterSpec::Kind::integer,
            .help = help,
            .minimum = least,
            .maximum = most,
            .otherwise = otherwise};
}

std::vector<std::string> kernels_of(RegionMethod method)
{
    switch (method) {
    case RegionMethod::darts:
        return {"dart_throwing.cl", "darts_in_order.cl", "darts_in_rounds.cl"};
    case RegionMethod::relaxation:
        return {"relaxation_dart_throwing.cl"};
    case RegionMethod::lloyd:
        return {"relaxation_dart_throwing.cl", "region_lloyd.cl"};
    case RegionMethod::elimination:
        return {"point_grid.cl", "sample_elimination.cl"};
    case RegionMethod::gaussian:
        return {"gaussian_blue_noise.cl", "point_grid.cl", "relaxation.cl"};
    case RegionMethod::bridson:
        return {};
    }
    return {};
}

SamplerSpec region_method_sampler(RegionMethodText text)
{
    text.parameters.push_back(boundary_parameter(text.method));
    SamplerSpec spec;
    spec.name = text.name;
    spec.title = text.title;
    spec.summary = text.summary;
    spec.dimensions = {2};
    spec.parameters = text.parameters;
    spec.kernels = kernels_of(text.method);
    spec.check = [text](const Parameters& given, const SampleRequest& request, const SourceLocation& where) {
        check_method(text, given, request, where);
    };
    if (text.method != RegionMethod::bridson) {
        spec.memory_growth = MemoryGrowth::linear;
        spec.device_memory = [text](const Parameters& given, const SampleRequest& request, const DeviceInfo& device) {
            return region_point_memory(settings_of(text, given, request), device);
        };
    }
    spec.create = [text](const Parameters& given, const SampleRequest& request, Engine engine,
                         const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        return std::make_unique<RegionMethodSampler>(text, given, request, engine, device);
    };
    return spec;
}

void read_count(const Parameters&, const SampleRequest& request, RegionPointSettings& settings)
{
    settings.place.points = request.points;
}

constexpr const char* to_points = "points";
constexpr const char* to_saturation = "saturation";

/// A distance alone means that no further point fits, as `distribute darts` has it.
bool is_to_saturation(const Parameters& given)
{
    if (given.is_given("stop")) return given.text("stop") == to_saturation;
    return given.is_given("min_distance");
}

void read_darts(const Parameters& given, const SampleRequest& request, RegionPointSettings& settings)
{
    if (given.is_given("min_distance")) settings.place.min_distance = given.number("min_distance");
    if (!is_to_saturation(given)) settings.place.points = request.points;
    if (given.is_given("relative_radius")) settings.place.relative_radius = given.number("relative_radius");
    if (!settings.place.points && !settings.place.min_distance)
        settings.place.min_distance = distance_at(saturation_relative_radius(2), request);
}

void check_darts(const Parameters& given, const SourceLocation& where)
{
    if (given.is_given("relative_radius") && given.is_given("min_distance"))
        throw given.error("relative_radius", "cannot be combined with min_distance");
    if (given.is_given("relative_radius") && is_to_saturation(given))
        throw given.error("relative_radius",
                          "cannot be combined with stop = \"saturation\"; min_distance sets the distance "
                          "here");
    if (!given.is_given("relative_radius") && !given.is_given("min_distance") && !is_to_saturation(given))
        throw InputError::at(where, "sampler = \"dart-throwing\": needs relative_radius, min_distance, or stop = "
                                    "\"saturation\"");
}

/// The relative radius of Bridson's sets on the torus, within a percent.
constexpr double bridson_radius = 0.73;

}

SamplerSpec region_dart_sampler()
{
    SamplerSpec spec = region_method_sampler(
        {.method = RegionMethod::darts,
         .name = "dart-throwing",
         .title = "Dart throwing",
         .summary = "random darts, rejected where nearer than the minimum distance to an earlier one",
         .parameters = {{.key = "relative_radius",
                         .help = "minimum distance over that of the densest packing of as many points in the region's "
                                 "area; boundaries leave room for some more than 0.77",
                         .maximum = 1,
                         .exclusive_minimum = true,
                         .symbol = "rho",
                         .unless_given = "needed unless min_distance, or stop = \"saturation\""},
                        {.key = "stop",
                         .kind = ParameterSpec::Kind::choice,
                         .help = "when to stop: at analysis.points points, or when no further point fits",
                         .choices = {to_points, to_saturation},
                         .unless_given = "points; saturation with min_distance"},
                        distance_parameter("with stop = \"saturation\" what gives about analysis.points points")},
         .read = read_darts});
    spec.check = [checked = spec.check](const Parameters& given, const SampleRequest& request,
                                        const SourceLocation& where) {
        check_darts(given, where);
        checked(given, request, where);
    };
    return spec;
}

SamplerSpec region_relaxation_sampler()
{
    return region_method_sampler(
        {.method = RegionMethod::relaxation,
         .name = "relaxation-dart-throwing",
         .title = "Relaxation dart throwing",
         .summary = "dart throwing with a radius that is reduced where darts keep failing; every prefix of a set is "
                    "well spread",
         .parameters = {{.key = "factor",
                         .help = "what the radius is multiplied by when darts keep failing",
                         .minimum = 0.01,
                         .maximum = 0.999999,
                         .otherwise = RegionPointSettings{}.factor},
                        count_parameter("attempts", "failed darts inside after which the radius is reduced", 1, 1e9,
                                        1000)},
         .read =
             [](const Parameters& given, const SampleRequest& request, RegionPointSettings& settings) {
                 settings.place.points = request.points;
                 settings.factor = given.number("factor");
                 settings.attempts = static_cast<std::uint32_t>(given.integer("attempts"));
             },
         .is_progressive = true});
}

SamplerSpec region_bridson_sampler()
{
    return region_method_sampler(
        {.method = RegionMethod::bridson,
         .name = "bridson",
         .title = "Bridson's dart throwing",
         .summary = "darts around the points that are there, until none finds room (Bridson 2007)",
         .parameters = {distance_parameter("what gives about analysis.points points"),
                        count_parameter("attempts", "darts around a point before it is given up", 1, 1e6, 30)},
         .read = [](const Parameters& given, const SampleRequest& request, RegionPointSettings& settings) {
             settings.place.min_distance =
                 given.is_given("min_distance") ? given.number("min_distance") : distance_at(bridson_radius, request);
             settings.attempts = static_cast<std::uint32_t>(given.integer("attempts"));
         }});
}

SamplerSpec region_lloyd_sampler()
{
    return region_method_sampler(
        {.method = RegionMethod::lloyd,
         .name = "lloyd",
         .title = "Lloyd relaxation",
         .summary = "random points, moved to the centroids of what their Voronoi cells have of the region, again and "
                    "again",
         .parameters = {count_parameter("iterations", "Lloyd iterations", 0, 1e6, 50)},
         .read = [](const Parameters& given, const SampleRequest& request, RegionPointSettings& settings) {
             read_count(given, request, settings);
             settings.iterations = static_cast<std::uint32_t>(given.integer("iterations"));
         }});
}

SamplerSpec region_elimination_sampler()
{
    return region_method_sampler(
        {.method = RegionMethod::elimination,
         .name = "sample-elimination",
         .title = "Sample elimination",
         .summary = "random points without those that have others nearest; every prefix is well spread (Yuksel 2015)",
         .parameters = {count_parameter("candidates", "random points to begin with, for each point that is kept", 1, 30,
                                        5)},
         .read =
             [](const Parameters& given, const SampleRequest& request, RegionPointSettings& settings) {
                 read_count(given, request, settings);
                 settings.candidates = static_cast<std::uint32_t>(given.integer("candidates"));
             },
         .is_progressive = true});
}

SamplerSpec region_gaussian_sampler()
{
    return region_method_sampler(
        {.method = RegionMethod::gaussian,
         .name = "gaussian-blue-noise",
         .title = "Gaussian blue noise",
         .summary = "relaxation darts, pushed apart by Gaussians around them and held by those of the region",
         .parameters = {count_parameter("iterations", "steps that all points take", 0, 1e6, 100)},
         .read = [](const Parameters& given, const SampleRequest& request, RegionPointSettings& settings) {
             read_count(given, request, settings);
             settings.iterations = static_cast<std::uint32_t>(given.integer("iterations"));
         }});
}

}
