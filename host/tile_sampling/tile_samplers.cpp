#include "host/tile_sampling/tile_samplers.hpp"

#include "base/geometry/lattice.hpp"
#include "base/random/random.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/tile_construction/tile_construction.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>

namespace poissonlab {
namespace {

constexpr double max_tiles = 1'048'576;

/// The kind and dimension of the tiles that a sampler's name stands for.
struct TileMethod
{
    PoissonTileKind kind;
    int dimension;
};

PoissonTileParameters tile_parameters(const TileMethod& method, const Parameters& given, std::uint64_t seed)
{
    const auto integer = [&](const char* key, std::int64_t otherwise) {
        return static_cast<std::uint32_t>(given.has(key) ? given.integer(key) : otherwise);
    };
    PoissonTileParameters p;
    p.kind = method.kind;
    p.dimension = method.dimension;
    p.colors = integer("colors", 1);
    p.tiles = method.kind == PoissonTileKind::frame ? integer("tiles", 1)
                                                    : tile_count(method.kind, method.dimension, p.colors);
    p.points_per_tile = integer("points_per_tile", 64);
    p.relative_radius = given.has("relative_radius") ? given.number("relative_radius") : 0.75;
    if (given.has("filling") && given.text("filling") == "dart-throwing") set_dart_throwing(p);
    p.lloyd_iterations = integer("lloyd_iterations", 20);
    p.repulsion = given.has("repulsion") && given.flag("repulsion");
    p.seed = seed;
    return p;
}

class TileSampler final : public DeviceSampler
{
public:
    TileSampler(const PoissonTileParameters& parameters, const SampleRequest& request, Engine engine,
                const DeviceProvider& device)
        : DeviceSampler(engine, device), seed_(request.seed),
          side_(tiling_side(request.points, parameters.points_per_tile, parameters.dimension))
    {
        const auto begin = std::chrono::steady_clock::now();
        CachedTileSet cached = cached_tile_set(parameters, engine, device, tile_cache_folder(), request.on_step);
        tiles_ = std::move(cached.set);
        tile_set_ = std::move(cached.record);
        if (device_) generator_.emplace(*device_, tiles_);
        const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
        preparation_seconds_ = all.count() - build_seconds() - cached.waiting_seconds;
    }

    PointSet sample(std::uint32_t realization) override
    {
        const std::uint32_t tiling = stream_key(seed_, Purpose::tile_choice, realization)[0];
        return generator_ ? generator_->generate_torus(tiling, side_) : reference::torus_points(tiles_, tiling, side_);
    }

    std::optional<TileSetRecord> tile_set() const override { return tile_set_; }
    std::uint32_t tiles_along_axis() const override { return side_; }
    double preparation_seconds() const override { return preparation_seconds_; }

private:
    std::uint64_t seed_;
    std::uint32_t side_;
    double preparation_seconds_ = 0;
    PoissonTileSet tiles_;
    TileSetRecord tile_set_;
    std::optional<TilePointGenerator> generator_;
};

ParameterSpec integer_spec(std::string key, std::string help, double minimum, double maximum, std::string symbol)
{
    ParameterSpec spec;
    spec.key = std::move(key);
    spec.kind = ParameterSpec::Kind::integer;
    spec.help = std::move(help);
    spec.minimum = minimum;
    spec.maximum = maximum;
    spec.symbol = std::move(symbol);
    return spec;
}

std::vector<ParameterSpec> parameter_specs(const TileMethod& method)
{
    std::vector<ParameterSpec> specs;
    if (method.kind == PoissonTileKind::frame) {
        specs.push_back(integer_spec("tiles", "T, tiles of the set", 1, max_tiles, "T"));
    } else {
        const char* what = method.kind == PoissonTileKind::edge ? "C, colours of edges; the set has C^12 tiles"
                           : method.dimension == 3              ? "C, colours of corners; the set has C^8 tiles"
                                                                : "C, colours of corners; the set has C^4 tiles";
        const double most = method.kind == PoissonTileKind::edge ? 3 : method.dimension == 3 ? 4 : 32;
        specs.push_back(integer_spec("colors", what, 1, most, "C"));
    }
    specs.push_back(integer_spec("points_per_tile", "N, points of each tile; default 64", min_points_per_tile,
                                 max_points_per_tile, "N"));

    ParameterSpec radius;
    radius.key = "relative_radius";
    radius.help = "rho that every tiling has at least; default 0.75";
    radius.maximum = 1;
    radius.exclusive_minimum = true;
    radius.exclusive_maximum = true;
    radius.symbol = "rho";
    specs.push_back(radius);

    ParameterSpec filling;
    filling.key = "filling";
    filling.kind = ParameterSpec::Kind::choice;
    filling.help = "how tiles are filled before relaxation; default relaxation-dart-throwing";
    filling.choices = {"dart-throwing", "relaxation-dart-throwing"};
    specs.push_back(filling);

    specs.push_back(
        integer_spec("lloyd_iterations", "Lloyd iterations of each piece; default 20", 0, 100'000, "lloyd"));

    ParameterSpec repulsion;
    repulsion.key = "repulsion";
    repulsion.kind = ParameterSpec::Kind::boolean;
    repulsion.help = "push apart what Lloyd relaxation left too close: needed above 0.75 or 0.8";
    specs.push_back(repulsion);
    return specs;
}

/// The size of the tile set is what every config has to name.
const char* size_key(const TileMethod& method) { return method.kind == PoissonTileKind::frame ? "tiles" : "colors"; }

/// The place of a parameter in the config or, if its default holds, that of the tile set's size.
const SourceLocation& place_of(const Parameters& parameters, const std::string& key, const TileMethod& method)
{
    return parameters.location(parameters.has(key) ? key : size_key(method));
}

void check_parameters(const TileMethod& method, const std::string& sampler, const Parameters& parameters,
                      const SampleRequest& request, const SourceLocation& where)
{
    const char* size = size_key(method);
    if (!parameters.has(size))
        throw InputError(fmt::format("{}: sampler = \"{}\": needs {}", to_string(where), sampler, size));
    const PoissonTileParameters tiles = tile_parameters(method, parameters, request.seed);
    try {
        check(tiles);
    } catch (const InputError& error) {
        // The message begins with the parameter's name.
        const std::string message = error.what();
        const std::string key = message.substr(0, message.find(' '));
        throw InputError(to_string(place_of(parameters, key, method)) + ": " + message);
    }
    if (tiling_side(request.points, tiles.points_per_tile, method.dimension) > 65'536)
        throw InputError(fmt::format("{}: sampler = \"{}\": {} points are more than 65536 tiles along an axis",
                                     to_string(where), sampler, request.points));
}

/// The number of tiles of a set's tiling.
std::uint64_t tiles_of_sets(const PoissonTileParameters& tiles, std::size_t points)
{
    return lattice_cells(tiling_side(points, tiles.points_per_tile, tiles.dimension), tiles.dimension);
}

/// Building the tile set, then taking points from it.
DeviceMemory device_memory(const PoissonTileParameters& tiles, std::size_t points, const DeviceInfo& device)
{
    return either(construction_memory(tiles, device),
                  TilePointGenerator::memory(tiles, tiles_of_sets(tiles, points), device));
}

SamplerSpec tile_sampler(const TileMethod& method, std::string name, std::string title, std::string summary)
{
    SamplerSpec spec;
    spec.name = name;
    spec.title = std::move(title);
    spec.summary = std::move(summary);
    spec.dimensions = {method.dimension};
    spec.parameters = parameter_specs(method);
    spec.check = [method, name](const Parameters& parameters, const SampleRequest& request,
                                const SourceLocation& where) {
        check_parameters(method, name, parameters, request, where);
    };
    spec.most_points = [method](const Parameters& parameters, const SampleRequest& request) -> std::size_t {
        const PoissonTileParameters tiles = tile_parameters(method, parameters, request.seed);
        return tiles_of_sets(tiles, request.points) * tiles.points_per_tile;
    };
    spec.device_memory = [method](const Parameters& parameters, const SampleRequest& request,
                                  const DeviceInfo& device) {
        return device_memory(tile_parameters(method, parameters, request.seed), request.points, device);
    };
    // A set of one tile has one tiling.
    spec.is_deterministic = [method](const Parameters& parameters) {
        return parameters.integer(size_key(method)) == 1;
    };
    spec.create = [method](const Parameters& parameters, const SampleRequest& request, Engine engine,
                           const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        try {
            return std::make_unique<TileSampler>(tile_parameters(method, parameters, request.seed), request, engine,
                                                 device);
        } catch (const InputError& error) { // the radius could not be reached
            throw InputError(to_string(place_of(parameters, "relative_radius", method)) + ": " + error.what());
        }
    };
    return spec;
}

}

std::uint32_t tiling_side(std::size_t points, std::uint32_t points_per_tile, int dimension)
{
    const auto wanted = static_cast<double>(points) / points_per_tile;
    const double root = std::floor(dimension == 2 ? std::sqrt(wanted) : std::cbrt(wanted));
    const double below = std::max(1.0, root);
    const bool above_is_nearer = std::pow(below + 1, dimension) - wanted < wanted - std::pow(below, dimension);
    return static_cast<std::uint32_t>(above_is_nearer ? below + 1 : below);
}

std::vector<SamplerSpec> tile_samplers()
{
    return {tile_sampler({PoissonTileKind::corner, 2}, "corner-tiles", "Corner-based Poisson disk tiles",
                         "a tiling with Poisson disk tiles by the colours of their corners"),
            tile_sampler({PoissonTileKind::edge, 2}, "edge-tiles", "Edge-based Poisson disk tiles",
                         "a tiling with Poisson disk tiles by the colours of their edges, C = 2: 4,096 tiles"),
            tile_sampler({PoissonTileKind::frame, 2}, "template-tiles", "Template Poisson disk tiles",
                         "a tiling with tiles that have the same points near their borders"),
            tile_sampler({PoissonTileKind::corner, 3}, "sphere-tiles", "Corner-based Poisson sphere tiles",
                         "a 3D tiling with Poisson sphere tiles by the colours of their corners")};
}

}
