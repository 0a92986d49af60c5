#include "host/tile_sampling/tile_samplers.hpp"

#include "base/geometry/lattice.hpp"
#include "base/random/random.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/tile_construction/tile_construction.hpp"
#include "host/tile_points/point_levels.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

constexpr double max_tiles = 1'048'576;
constexpr double most_sets = 64;

bool knows_chains(const PoissonTileFamily& family)
{
    return family.dimension == 2 && family.kind != PoissonTileKind::edge;
}

PoissonTileParameters tile_parameters(const PoissonTileFamily& family, const Parameters& given, std::uint64_t seed)
{
    const auto integer = [&](const char* key) { return static_cast<std::uint32_t>(given.integer(key)); };
    const bool is_template = family.kind == PoissonTileKind::frame;
    PoissonTileParameters p;
    p.kind = family.kind;
    p.dimension = family.dimension;
    p.colors = is_template ? 1 : integer("colors");
    p.tiles = is_template ? integer("tiles") : tile_count(p.kind, p.dimension, p.colors);
    p.points_per_tile = integer("points_per_tile");
    p.relative_radius = given.number("relative_radius");
    if (given.text("filling") == tile_fillings[TileFilling::dart_throwing]) set_dart_throwing(p);
    p.lloyd_iterations = integer("lloyd_iterations");
    p.repulsion = given.flag("repulsion");
    p.ranked = given.flag("ranked");
    std::optional<std::uint32_t> iterations;
    std::optional<bool> nulling;
    std::optional<std::uint32_t> moments;
    if (given.is_given("joint_iterations")) iterations = integer("joint_iterations");
    if (given.is_given("null_peaks")) nulling = given.flag("null_peaks");
    if (given.is_given("equal_moments")) moments = integer("equal_moments");
    const bool has_strips = !knows_chains(family);
    set_border(p, has_strips ? TileBorder::strip : *tile_borders.find(given.text("border")), iterations, nulling,
               moments);
    if (given.is_given("repulsion")) p.repulsion = given.flag("repulsion");
    p.seed = seed;
    return p;
}

double density_of(const Parameters& given) { return given.number("density"); }

class TileSampler final : public DeviceSampler
{
public:
    TileSampler(const TileSetChoice& choice, const SampleRequest& request, Engine engine, const DeviceProvider& device)
        : DeviceSampler(engine, device), seed_(request.seed), density_(choice.density),
          side_(tiling_side(request.points, choice.density * choice.first.points_per_tile, choice.first.dimension)),
          sets_(choice, request, engine, device)
    {
        if (device_)
            for (const PoissonTileSet& set : sets_.all()) generators_.emplace_back(*device_, set);
    }

    PointSet sample(std::uint32_t realization) override
    {
        const std::size_t set = realization % sets_.all().size();
        const std::uint32_t tiling = stream_key(seed_, Purpose::tile_choice, realization)[0];
        PointSet points = generators_.empty() ? reference::torus_points(sets_.all()[set], tiling, side_)
                                              : generators_[set].generate_torus(tiling, side_);
        return at_density(std::move(points), density_, sets_.all()[set], tiling, side_);
    }

    SetTraits traits() const override
    {
        SetTraits traits = sets_.traits();
        traits.sizes_vary = density_ < 1 && !sets_.all().front().parameters.ranked; // chance leaves out about as many
        traits.tiles_along_axis = side_;
        return traits;
    }

private:
    std::uint64_t seed_;
    double density_;
    std::uint32_t side_;
    SeriesTileSets sets_;
    std::vector<TilePointGenerator> generators_;
};

const char* size_key(const PoissonTileFamily& family)
{
    return family.kind == PoissonTileKind::frame ? "tiles" : "colors";
}

/// The size of the tile set is what every config has to name.
ParameterSpec size_spec(const PoissonTileFamily& family)
{
    using Kind = ParameterSpec::Kind;
    if (family.kind == PoissonTileKind::frame)
        return {.key = "tiles",
                .kind = Kind::integer,
                .help = "T, tiles of the set",
                .minimum = 1,
                .maximum = max_tiles,
                .symbol = "T"};
    const bool has_edges = family.kind == PoissonTileKind::edge;
    const bool in_space = family.dimension == 3;
    return {.key = "colors",
            .kind = Kind::integer,
            .help = has_edges  ? "C, colours of edges; the set has C^12 tiles"
                    : in_space ? "C, colours of corners; the set has C^8 tiles"
                               : "C, colours of corners; the set has C^4 tiles",
            .minimum = 1,
            .maximum = has_edges  ? 3.0
                       : in_space ? 4.0
                                  : 32.0,
            .symbol = "C"};
}

std::vector<ParameterSpec> parameter_specs(const PoissonTileFamily& family)
{
    using Kind = ParameterSpec::Kind;
    std::vector<ParameterSpec> specs{
        size_spec(family),
        {.key = "points_per_tile",
         .kind = Kind::integer,
         .help = "N, points of each tile",
         .minimum = min_points_per_tile,
         .maximum = max_points_per_tile,
         .symbol = "N",
         .otherwise = std::int64_t{64}},
        {.key = "relative_radius",
         .help = "rho that every tiling has at least",
         .maximum = 1,
         .exclusive_minimum = true,
         .exclusive_maximum = true,
         .symbol = "rho",
         .otherwise = 0.75},
        {.key = "filling",
         .kind = Kind::choice,
         .help = "how tiles are filled before relaxation",
         .choices = tile_fillings.all(),
         .otherwise = tile_fillings[TileFilling::relaxation_dart_throwing]},
        {.key = "lloyd_iterations",
         .kind = Kind::integer,
         .help = "Lloyd iterations of each piece",
         .maximum = 100'000,
         .symbol = "lloyd",
         .otherwise = std::int64_t{20}},
        {.key = "repulsion",
         .kind = Kind::boolean,
         .help = "push apart what Lloyd relaxation left too close: needed above 0.75 or 0.8",
         .otherwise = false},
    };
    specs.push_back({.key = "ranked",
                     .kind = Kind::boolean,
                     .help = "order points, so that any part of them is spread evenly: see density",
                     .otherwise = false});
    specs.push_back({.key = "density",
                     .help = "part of the points that is kept: those of the lowest ranks, without ranks at random",
                     .maximum = 1,
                     .exclusive_minimum = true,
                     .symbol = "density",
                     .otherwise = 1.0});
    if (knows_chains(family))
        specs.push_back({.key = "border",
                         .kind = Kind::choice,
                         .help = "what tiles share: strips of points, or chains, which leave no seam",
                         .choices = tile_borders.all(),
                         .otherwise = tile_borders[TileBorder::strip]});
    specs.push_back({.key = "joint_iterations",
                     .kind = Kind::integer,
                     .help = "relaxations of all tiles together",
                     .maximum = 100'000,
                     .symbol = "joint",
                     .unless_given = knows_chains(family) ? "20 with chains, 0 with strips" : "0"});
    specs.push_back({.key = "null_peaks",
                     .kind = Kind::boolean,
                     .help = "in these, make the mean tile even, so that tilings show less of their lattice",
                     .unless_given = "true where there are joint iterations"});
    specs.push_back(
        {.key = "equal_moments",
         .kind = Kind::integer,
         .help = "order up to which all tiles have the same moments, so that tilings are even at all scales",
         .maximum = max_moment_order,
         .symbol = "moments",
         .unless_given = "0"});
    specs.push_back(tile_sets_parameter());
    return specs;
}

void check_parameters(const PoissonTileFamily& family, const std::string& sampler, const Parameters& parameters,
                      const SampleRequest& request, const SourceLocation& where)
{
    const char* size = size_key(family);
    if (!parameters.is_given(size))
        throw InputError::at(where, fmt::format("sampler = \"{}\": needs {}", sampler, size));
    const PoissonTileParameters tiles = tile_parameters(family, parameters, request.seed);
    try {
        check(tiles);
    } catch (const InputError& error) {
        throw error.moved_to(place_of_tile_parameter(parameters, error.key(), family));
    }
    const double density = density_of(parameters);
    if (tiles.ranked && density * tiles.points_per_tile <= 0.5)
        throw invalid_value(place_of_tile_parameter(parameters, "density", family), "density",
                            fmt::format("{}", density),
                            fmt::format("must be more than {}, or nothing is left of {} ranked points per tile",
                                        0.5 / tiles.points_per_tile, tiles.points_per_tile));
    if (tiling_side(request.points, density * tiles.points_per_tile, family.dimension) > 65'536)
        throw InputError::at(where, fmt::format("sampler = \"{}\": {} points are more than 65536 tiles along an axis",
                                                sampler, request.points));
}

/// The number of tiles of a set's tiling.
std::uint64_t tiles_of_sets(const PoissonTileParameters& tiles, double density, std::size_t points)
{
    return lattice_cells(tiling_side(points, density * tiles.points_per_tile, tiles.dimension), tiles.dimension);
}

/// Building the tile sets, one after the other, then taking points from them.
DeviceMemory device_memory(const TileSetChoice& choice, std::size_t points, const DeviceInfo& device)
{
    DeviceMemory taking;
    const std::uint64_t tiles = tiles_of_sets(choice.first, choice.density, points);
    for (std::uint32_t i = 0; i < choice.sets; ++i)
        taking = taking + TilePointGenerator::memory(choice.first, tiles, device);
    return either(construction_memory(choice.first, device), taking);
}

std::string sampler_name(const PoissonTileFamily& family)
{
    return std::string(poisson_tile_families[family]) + "-tiles";
}

SamplerSpec tile_sampler(const PoissonTileFamily& family, std::string title, std::string summary)
{
    const std::string name = sampler_name(family);
    SamplerSpec spec;
    spec.name = name;
    spec.title = std::move(title);
    spec.summary = std::move(summary);
    spec.dimensions = {family.dimension};
    spec.parameters = parameter_specs(family);
    spec.check = [family, name](const Parameters& parameters, const SampleRequest& request,
                                const SourceLocation& where) {
        check_parameters(family, name, parameters, request, where);
    };
    spec.most_points = [family](const Parameters& parameters, const SampleRequest& request) -> std::size_t {
        const PoissonTileParameters tiles = tile_parameters(family, parameters, request.seed);
        return tiles_of_sets(tiles, density_of(parameters), request.points) * tiles.points_per_tile;
    };
    spec.memory_growth = MemoryGrowth::limited;
    spec.device_memory = [family](const Parameters& parameters, const SampleRequest& request,
                                  const DeviceInfo& device) {
        return device_memory(tile_set_choice(family, parameters, request), request.points, device);
    };
    // A set of one tile has one tiling, but for what chance leaves out of it.
    spec.is_deterministic = [family](const Parameters& parameters) {
        return parameters.integer(size_key(family)) == 1 && sets_of(parameters) == 1 &&
               (parameters.flag("ranked") || density_of(parameters) == 1);
    };
    spec.kernels = {"tile_darts.cl", "tile_relaxation.cl", "tile_points.cl"};
    spec.create = [family](const Parameters& parameters, const SampleRequest& request, Engine engine,
                           const DeviceProvider& device) -> std::unique_ptr<Sampler> {
        try {
            return std::make_unique<TileSampler>(tile_set_choice(family, parameters, request), request, engine, device);
        } catch (const InputError& error) { // the radius could not be reached
            throw error.moved_to(place_of_tile_parameter(parameters, "relative_radius", family));
        }
    };
    return spec;
}

}

TileSetChoice tile_set_choice(const PoissonTileFamily& family, const Parameters& parameters,
                              const SampleRequest& request)
{
    return {tile_parameters(family, parameters, request.seed), sets_of(parameters), density_of(parameters)};
}

const SourceLocation& place_of_tile_parameter(const Parameters& parameters, const std::string& key,
                                              const PoissonTileFamily& family)
{
    return parameters.location(parameters.is_given(key) ? key : size_key(family));
}

std::vector<ParameterSpec> tile_set_parameters(const PoissonTileFamily& family)
{
    std::vector<ParameterSpec> specs = parameter_specs(family);
    std::erase_if(specs, [](const ParameterSpec& spec) { return spec.key == "density" || spec.key == "sets"; });
    return specs;
}

PoissonTileParameters tile_set_parameters_of(const PoissonTileFamily& family, const Parameters& given,
                                             std::uint64_t seed)
{
    return tile_parameters(family, given, seed);
}

std::optional<PoissonTileParameters> plane_tile_set(const std::string& sampler, const Parameters& parameters,
                                                    std::uint64_t seed)
{
    for (const auto& [family, word] : poisson_tile_families.entries)
        if (family.dimension == 2 && sampler_name(family) == sampler) return tile_parameters(family, parameters, seed);
    return std::nullopt;
}

ParameterSpec tile_sets_parameter()
{
    return {.key = "sets",
            .kind = ParameterSpec::Kind::integer,
            .help = "tile sets, of this seed and those after it, that realizations take in turn: errors are then "
                    "between sets",
            .minimum = 1,
            .maximum = most_sets,
            .symbol = "sets",
            .otherwise = std::int64_t{1}};
}

std::uint32_t tiling_side(std::size_t points, double points_per_tile, int dimension)
{
    const auto wanted = static_cast<double>(points) / points_per_tile;
    const double root = std::floor(dimension == 2 ? std::sqrt(wanted) : std::cbrt(wanted));
    const double below = std::max(1.0, root);
    const bool above_is_nearer = std::pow(below + 1, dimension) - wanted < wanted - std::pow(below, dimension);
    return static_cast<std::uint32_t>(above_is_nearer ? below + 1 : below);
}

SamplerSpec corner_tile_sampler()
{
    return tile_sampler({PoissonTileKind::corner, 2}, "Corner-based Poisson disk tiles",
                        "a tiling with Poisson disk tiles by the colours of their corners");
}

SamplerSpec edge_tile_sampler()
{
    return tile_sampler({PoissonTileKind::edge, 2}, "Edge-based Poisson disk tiles",
                        "a tiling with Poisson disk tiles by the colours of their edges, C = 2: 4,096 tiles");
}

SamplerSpec template_tile_sampler()
{
    return tile_sampler({PoissonTileKind::frame, 2}, "Template Poisson disk tiles",
                        "a tiling with tiles that have the same points near their borders");
}

SamplerSpec sphere_tile_sampler()
{
    return tile_sampler({PoissonTileKind::corner, 3}, "Corner-based Poisson sphere tiles",
                        "a 3D tiling with Poisson sphere tiles by the colours of their corners");
}

}
