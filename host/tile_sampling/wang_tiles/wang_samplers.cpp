
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "host/sampling/device_sampler.hpp"
#include "host/tile_sampling/tile_samplers.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "host/tile_sampling/wang_tiles/averaged_tiles.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>

namespace poissonlab {
namespace {

constexpr WordTable<AveragedVariant, 2> averaged_variants{
    {{{AveragedVariant::exact, "exact"}, {AveragedVariant::one_surrounding, "one-surrounding"}}}};

/// Tiles, and how good each of the states was that they came from.
struct BuiltTiles
{
    WangPoints points;
    std::vector<IterationRecord> iterations;
};

double mean_size(const WangPoints& points)
{
    double sum = 0;
    for (const auto& tile : points.tiles) sum += static_cast<double>(tile.size());
    return sum / static_cast<double>(wang_point_tiles);
}

class WangTileSampler final : public DeviceSampler
{
public:
    /// `build` is given the device that is the engine, or null, and the seed of a tile set: `sets` of them, of the
    /// request's seed and those after it.
    WangTileSampler(const SampleRequest& request, std::uint32_t sets, Engine engine, const DeviceProvider& device,
                    const std::function<BuiltTiles(Device*, std::uint64_t seed)>& build)
        : DeviceSampler(engine, device), seed_(request.seed)
    {
        const auto begin = std::chrono::steady_clock::now();
        for (std::uint32_t i = 0; i < sets; ++i) built_.push_back(build(device_, request.seed + i));
        const double size = std::max(1.0, mean_size(built_.front().points));
        side_ = std::min(tiling_side(request.points, size, 2), 65'536U);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        preparation_seconds_ = seconds - build_seconds();
    }

    PointSet sample(std::uint32_t realization) override
    {
        last_ = realization % built_.size();
        const StreamKey key = stream_key(seed_, Purpose::wang_tilings, realization);
        return wang_torus(built_[last_].points, std::uint64_t{key[0]} << 32 | key[1], side_);
    }

    SetTraits traits() const override
    {
        SetTraits traits;
        traits.sizes_vary = tiles_differ();
        traits.tiles_along_axis = side_;
        traits.tile_sets = static_cast<std::uint32_t>(built_.size());
        traits.tile_set.emplace();
        traits.tile_set->tiles = wang_point_tiles;
        traits.tile_set->points_per_tile = static_cast<std::uint64_t>(std::lround(mean_size(built_.front().points)));
        traits.iterations = built_[last_].iterations;
        traits.preparation_seconds = preparation_seconds_;
        return traits;
    }

private:
    /// Tiles of darts have different numbers of points.
    bool tiles_differ() const
    {
        for (const BuiltTiles& built : built_)
            for (const auto& tile : built.points.tiles)
                if (tile.size() != built_.front().points.tiles.front().size()) return true;
        return false;
    }

    std::uint64_t seed_;
    std::vector<BuiltTiles> built_;
    std::size_t last_ = 0; ///< set of the last sample()
    std::uint32_t side_ = 1;
    double preparation_seconds_ = 0;
};

double shade_distance(const Parameters& given)
{
    return min_distance_for(given.number("relative_radius"), static_cast<std::size_t>(given.integer("points_per_tile")),
                            2);
}

BuiltTiles shade_tiles(const Parameters& given, std::uint64_t seed)
{
    const double distance = shade_distance(given) * tile_units;
    BuiltTiles built{throw_shade_tiles(static_cast<std::uint64_t>(std::ceil(distance * distance)),
                                       static_cast<std::uint32_t>(given.integer("attempts")), seed),
                     {}};
    return built;
}

/// The relative radius of tilings, which is that of the two nearest points that can be near; and that of the two
/// nearest of one tile, where tiles have two.
IterationRecord record_of(const WangPoints& points)
{
    const std::size_t size = points.tiles.front().size();
    const auto radius = [&](std::int64_t squared) {
        return relative_radius(std::sqrt(static_cast<double>(squared)) / tile_units, size, 2);
    };
    const std::int64_t within = squared_distance_within(points);
    IterationRecord record{radius(std::min(within, squared_distance_across(points))), 0};
    if (size > 1) record.relative_radius_within_tiles = radius(within);
    return record;
}

BuiltTiles averaged_tiles(const Parameters& given, const SampleRequest& request, Device* device, std::uint64_t seed)
{
    const AveragedVariant variant = *averaged_variants.find(given.text("variant"));
    BuiltTiles built{start_averaged_tiles(static_cast<std::uint32_t>(given.integer("points_per_tile")), seed), {}};
    const auto iterations = static_cast<std::uint32_t>(given.integer("iterations"));
    std::optional<AveragedTiles> kernels;
    if (device) kernels.emplace(*device);
    for (std::uint32_t i = 0; i <= iterations; ++i) {
        built.iterations.push_back(record_of(built.points));
        if (i == iterations) break;
        if (request.on_step) request.on_step(fmt::format("averaged tiles: iteration {} of {}", i + 1, iterations));
        built.points = kernels ? kernels->average_once(built.points, variant, i, seed)
                               : average_once(built.points, variant, i, seed);
    }
    return built;
}

ParameterSpec points_per_tile_spec()
{
    return {.key = "points_per_tile",
            .kind = ParameterSpec::Kind::integer,
            .help = "N, points of each tile",
            .minimum = 1,
            .maximum = 4096,
            .symbol = "N",
            .otherwise = std::int64_t{32}};
}

SamplerSpec described(std::string name, std::string title, std::string summary, std::vector<ParameterSpec> parameters)
{
    SamplerSpec spec;
    spec.name = std::move(name);
    spec.title = std::move(title);
    spec.summary = std::move(summary);
    spec.dimensions = {2};
    spec.parameters = std::move(parameters);
    spec.parameters.push_back(tile_sets_parameter());
    spec.most_points = [](const Parameters& given, const SampleRequest& request) -> std::size_t {
        // The nearest number of whole tiles may be one row and column more.
        return 3 * request.points / 2 + 4 * static_cast<std::size_t>(given.integer("points_per_tile"));
    };
    return spec;
}

}

SamplerSpec shade_tile_sampler()
{
    using Kind = ParameterSpec::Kind;
    SamplerSpec spec =
        described("shade-tiles", "Shade's tiles",
                  "a tiling of 8 Wang tiles, made by darts that keep away from all tiles that may lie beside",
                  {points_per_tile_spec(),
                   {.key = "relative_radius",
                    .help = "rho of N points: the distance that darts keep; fewer than N fit",
                    .maximum = 1,
                    .exclusive_minimum = true,
                    .symbol = "rho",
                    .otherwise = 0.7},
                   {.key = "attempts",
                    .kind = Kind::integer,
                    .help = "failed darts in a row after which tiles are done",
                    .minimum = 1,
                    .maximum = 10'000'000,
                    .symbol = "F",
                    .otherwise = std::int64_t{100'000}}});
    spec.check = [](const Parameters& given, const SampleRequest&, const SourceLocation& where) {
        const double distance = shade_distance(given);
        if (distance >= 0.5)
            throw InputError::at(
                given.is_given("relative_radius") ? given.location("relative_radius") : where,
                fmt::format("sampler = \"shade-tiles\": a distance of {:.3f} tiles: must be less than half "
                            "a tile; more points_per_tile, or a smaller relative_radius",
                            distance));
    };
    // The darts of eight tiles wait for each other, and take milliseconds: the host throws them.
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine, const DeviceProvider& device) {
        return std::make_unique<WangTileSampler>(request, sets_of(given), Engine::reference, device,
                                                 [&](Device*, std::uint64_t seed) { return shade_tiles(given, seed); });
    };
    return spec;
}

SamplerSpec averaged_tile_sampler()
{
    using Kind = ParameterSpec::Kind;
    SamplerSpec spec = described(
        "averaged-tiles", "Averaged tiles",
        "a tiling of 8 Wang tiles whose points are relaxed in the mean of all surroundings",
        {points_per_tile_spec(),
         {.key = "iterations",
          .kind = Kind::integer,
          .help = "moves of all points",
          .maximum = 100'000,
          .symbol = "i",
          .otherwise = std::int64_t{30}},
         {.key = "variant",
          .kind = Kind::choice,
          .help = "a point's move: the mean over all 4,096 surroundings of its tile (Hiller and others 2001), or "
                  "that in a random one (Cohen and others 2003)",
          .choices = averaged_variants.all(),
          .otherwise = std::string(averaged_variants[AveragedVariant::exact])}});
    spec.check = [](const Parameters&, const SampleRequest&, const SourceLocation&) {};
    spec.kernels = {"averaged_tiles.cl"};
    spec.memory_growth = MemoryGrowth::fixed;
    spec.device_memory = [](const Parameters& given, const SampleRequest&, const DeviceInfo&) {
        if (given.integer("iterations") == 0) return DeviceMemory{};
        return AveragedTiles::memory(static_cast<std::size_t>(given.integer("points_per_tile")));
    };
    spec.create = [](const Parameters& given, const SampleRequest& request, Engine engine,
                     const DeviceProvider& device) {
        return std::make_unique<WangTileSampler>(
            request, sets_of(given), engine, device,
            [&](Device* used, std::uint64_t seed) { return averaged_tiles(given, request, used, seed); });
    };
    return spec;
}

}
