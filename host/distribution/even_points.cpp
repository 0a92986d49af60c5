#include "host/distribution/even_points.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"
#include "host/config/sampler_registry.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_sampling/tile_samplers.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The seed of tile sets: which tiling is made of them is another matter.
constexpr std::uint64_t tile_set_seed = 1;

constexpr double most_tiles_along_a_side = 65'536;

/// A position within a side as a part of 2^32.
std::uint32_t part_of_side(std::uint64_t place, std::uint32_t tiles)
{
    return static_cast<std::uint32_t>((place << 16) / tiles); // units of 1/65,536
}

SquarePoints tiling_points(const PoissonTileSet& tiles, std::size_t points, double width, double height,
                           std::uint64_t seed, const DistributionPlace& place)
{
    const EvenTileGrid grid = tile_grid(points, tiles.parameters.points_per_tile, width, height);
    const TileBlock block{{}, {grid.columns, grid.rows, 1}};
    const PoissonTiling tiling{stream_key(seed, Purpose::tile_choice, 0)[0],
                               static_cast<std::int32_t>(std::max(grid.columns, grid.rows))};
    SquarePoints square;
    const auto append = [&](std::span<const std::uint32_t> units) {
        stop_if_interrupted();
        for (std::size_t i = 0; i < units.size(); ++i) {
            const std::uint32_t side = i % 2 == 0 ? grid.columns : grid.rows;
            square.push_back(part_of_side(torus_place(units[i], side), side));
        }
    };
    if (place.engine == Engine::reference)
        append(reference::exact_tile_points(tiles, tiling, block));
    else
        TilePointGenerator(place.device(), tiles).stream(tiling, block, append);
    return square;
}

SquarePoints sampled_points(const SamplerChoice& method, std::size_t points, double width, double height,
                            std::uint64_t seed, const DistributionPlace& place)
{
    const double longest = std::max(width, height);
    const double area = width * height / (longest * longest);
    const SampleRequest request{static_cast<std::size_t>(std::llround(static_cast<double>(points) / area)), 2, seed,
                                place.on_step};
    const SamplerSpec& spec = *method.spec;
    if (std::ranges::find(spec.dimensions, 2) == spec.dimensions.end())
        throw InputError(fmt::format("sampler \"{}\": has no sets in the plane", spec.name));
    if (spec.check) spec.check(method.parameters, request, {spec.name});
    if (spec.device_memory && place.engine == Engine::opencl) {
        const DeviceInfo& device = place.device().info();
        check_fits(fmt::format("sampler \"{}\"", spec.name), spec.device_memory(method.parameters, request, device),
                   device);
    }
    const PointSet set = spec.create(method.parameters, request, place.engine, place.device)->sample(0);
    SquarePoints square;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const double x = set[i][0] * longest / width, y = set[i][1] * longest / height;
        if (x >= 1 || y >= 1) continue;
        square.push_back(static_cast<std::uint32_t>(x * 4294967296.0));
        square.push_back(static_cast<std::uint32_t>(y * 4294967296.0));
    }
    return square;
}

}

EvenTileGrid tile_grid(std::size_t points, std::uint32_t points_per_tile, double width, double height)
{
    const double tiles = static_cast<double>(points) / points_per_tile;
    const double rows = std::sqrt(tiles * height / width);
    if (rows > most_tiles_along_a_side || rows * width / height > most_tiles_along_a_side)
        throw InputError(
            fmt::format("{} points: are more than 65536 tiles of {} points along a side", points, points_per_tile));
    EvenTileGrid best;
    double least = INFINITY;
    const auto try_rows = [&](double count) {
        if (count < 1) return;
        for (const double columns : {std::floor(tiles / count), std::floor(tiles / count) + 1}) {
            if (columns < 1) continue;
            const double wrong =
                std::abs(std::log(columns * count / tiles)) + std::abs(std::log(columns / count * height / width));
            if (wrong >= least) continue;
            least = wrong;
            best = {static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(count)};
        }
    };
    for (int around = -1; around <= 2; ++around) try_rows(std::floor(rows) + around);
    return best;
}

SamplerChoice default_even_method()
{
    const SamplerSpec& spec = *find_sampler("corner-tiles");
    Parameters parameters(spec.parameters);
    parameters.set("colors", std::int64_t{3});
    parameters.set("points_per_tile", std::int64_t{32});
    return {&spec, parameters};
}

SquarePoints even_points(const EvenMethod& method, std::size_t points, double width, double height, std::uint64_t seed,
                         const DistributionPlace& place)
{
    if (const auto* tiles = std::get_if<PoissonTileSet>(&method))
        return tiling_points(*tiles, points, width, height, seed, place);
    const SamplerChoice& sampler = std::get<SamplerChoice>(method);
    const auto built = plane_tile_set(sampler.spec->name, sampler.parameters, tile_set_seed);
    if (!built || sampler.parameters.number("density") < 1)
        return sampled_points(sampler, points, width, height, seed, place);
    if (sampler.spec->check) sampler.spec->check(sampler.parameters, {points, 2, tile_set_seed}, {sampler.spec->name});
    const CachedTileSet cached =
        cached_tile_set(*built, place.engine, place.device, tile_cache_folder(), place.on_step);
    return tiling_points(cached.set, points, width, height, seed, place);
}

PixelPlaces warp_points(const Density& density, const SquarePoints& points, const DistributionPlace& place)
{
    const WarpTable table(density);
    if (place.engine == Engine::reference) return reference::warp_points(table, points);
    Device& device = place.device();
    check_fits("warping", PointWarper::memory(table.width, table.height, points.size() / 2), device.info());
    return PointWarper(device, table).warp(points);
}

}
