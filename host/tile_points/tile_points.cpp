#include "host/tile_points/tile_points.hpp"

#include "base/errors/errors.hpp"
#include "kernels/common/tiles/tile_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <memory>

namespace poissonlab {
namespace {

constexpr std::uint32_t max_block_size = 65536;

/// Numbers that stream() hands over at once, unless a tile has more: 16 MiB.
constexpr std::size_t values_per_piece = std::size_t{1} << 22;

/// Tiles that stream() makes at once; fewer on small devices.
std::size_t tiles_per_piece(std::size_t values_per_tile, const DeviceInfo& device)
{
    const std::uint64_t bytes = std::min(device.max_allocation_bytes, device.global_memory_bytes / 8);
    const std::uint64_t values = std::min<std::uint64_t>(values_per_piece, bytes / sizeof(std::uint32_t));
    return std::max<std::size_t>(1, values / values_per_tile);
}

std::size_t values_of_tile(const PoissonTileParameters& p)
{
    return std::size_t{p.points_per_tile} * static_cast<std::size_t>(p.dimension);
}

/// Longer runs are refused: kernels divide the numbers of tiles below 2^31.
constexpr std::uint32_t max_run = std::uint32_t{1} << 30;

/// A run of a block. n / width = n * reciprocal >> shift for all n below 2^31, where width is at most 2^16: with 2^b
/// the power of two that is not below the width, shift = 31 + b and reciprocal = 2^shift / width rounded up, which
/// makes the product too large by less than n < 2^shift / width.
contract::tile_points::Run run_of(const TileBlock& block, const TileRun& run)
{
    const std::uint32_t width = block.size[0];
    const std::uint64_t row = run.first / width;
    const auto shift = 31 + static_cast<std::uint32_t>(std::bit_width(width - 1));
    return {.x = static_cast<std::uint32_t>(run.first % width),
            .y = static_cast<std::uint32_t>(row % block.size[1]),
            .z = static_cast<std::uint32_t>(row / block.size[1]),
            .count = run.count,
            .width = width,
            .height = block.size[1],
            .reciprocal = static_cast<std::uint32_t>(((std::uint64_t{1} << shift) + width - 1) / width),
            .shift = shift};
}

}

void check(const TileBlock& block, int dimension)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t size = block.size[axis];
        if (size < 1 || size > max_block_size)
            throw InputError(fmt::format("a window of {} tiles along an axis: must be 1 to {}", size, max_block_size));
        if (std::int64_t{block.lowest[axis]} + size > INT32_MAX)
            throw InputError(fmt::format("a window from {} on: places of tiles have 32 bits", block.lowest[axis]));
    }
    if (dimension == 2 && (block.lowest[2] != 0 || block.size[2] != 1))
        throw InputError("a window with layers: the tiles are two-dimensional");
}

std::uint64_t torus_place(std::uint32_t unit, std::uint32_t tiles)
{
    const std::uint64_t size = std::uint64_t{tile_units} * tiles;
    const auto overhang = static_cast<std::uint64_t>(tile_units / 2);
    // Points of chains may be outside, up to half a tile: above, or below modulo 2^32.
    if (unit < size) return unit;
    return unit < size + overhang ? unit - size : unit + size - (std::uint64_t{1} << 32);
}

void append_torus_points(std::span<const std::uint32_t> units, std::uint32_t period, std::vector<double>& coordinates)
{
    const auto size = static_cast<double>(std::uint64_t{tile_units} * period);
    for (const std::uint32_t unit : units) coordinates.push_back(static_cast<double>(torus_place(unit, period)) / size);
}

NeededBuffers TilePointGenerator::Buffers::needed(const PoissonTileParameters& p, std::size_t piece)
{
    return {{units, p.tiles * values_of_tile(p)}, {tiles, piece}, {points, piece * values_of_tile(p)}};
}

TilePointGenerator::TilePointGenerator(Device device, const PoissonTileSet& tiles, std::size_t work_group_size)
    : device_(std::move(device)), parameters_(tiles.parameters),
      work_group_size_(work_group_size > 0 ? work_group_size
                                           : std::min<std::size_t>(256, device_.info().max_work_group_size)),
      values_per_tile_(values_of_tile(parameters_)), look_up_(kernel("look_up_tiles", "float")),
      place_floats_(kernel("place_points", "float")), place_integers_(kernel("place_points", "uint"))
{
    reserve(device_, buffers_.needed(parameters_, 0));
    buffers_.units.write(tiles.points);
}

/// Constants for the compiler: loops over a tile's points are unrolled, remainders by the colours are
/// products.
Kernel TilePointGenerator::kernel(const char* name, const char* value)
{
    const auto number = [](std::uint32_t n) { return std::to_string(n) + "u"; };
    const StoredScale scale = stored_scale(parameters_.border);
    return device_.kernel(kernel_program("tile_points.cl", {{"KIND", static_cast<std::uint32_t>(parameters_.kind)},
                                                            {"DIMENSION", parameters_.dimension},
                                                            {"COLORS", number(parameters_.colors)},
                                                            {"TILES", number(parameters_.tiles)},
                                                            {"POINTS", number(parameters_.points_per_tile)},
                                                            {"LOW", scale.low},
                                                            {"STEP", scale.step},
                                                            {"VALUE", value}}),
                          name);
}

template <class Value>
void TilePointGenerator::place_values(Kernel& place, const PoissonTiling& tiling, const TileBlock& block,
                                      const TileRun& run, Buffer<Value>& points)
{
    check(block, parameters_.dimension);
    if (run.count > max_run) throw InputError(fmt::format("a run of {} tiles: must be at most {}", run.count, max_run));
    reserve(device_, buffers_.tiles, run.count);
    const contract::tile_points::Run tiles = run_of(block, run);
    const contract::tile_points::Window window{.seed = tiling.seed,
                                               .period = tiling.period,
                                               .west = block.lowest[0],
                                               .south = block.lowest[1],
                                               .bottom = block.lowest[2]};
    look_up_.run(run.count, work_group_size_, tiles, window, buffers_.tiles);
    place.run(run.count, work_group_size_, tiles, buffers_.tiles, buffers_.units, points);
}

void TilePointGenerator::place(const PoissonTiling& tiling, const TileBlock& block, const TileRun& run,
                               Buffer<float>& points)
{
    place_values(place_floats_, tiling, block, run, points);
}

void TilePointGenerator::place(const PoissonTiling& tiling, const TileBlock& block, const TileRun& run,
                               Buffer<std::uint32_t>& points)
{
    place_values(place_integers_, tiling, block, run, points);
}

void TilePointGenerator::stream(const PoissonTiling& tiling, const TileBlock& block, const Sink& sink)
{
    stream(tiling, block, 0, block.tiles(), sink);
}

void TilePointGenerator::stream(const PoissonTiling& tiling, const TileBlock& block, std::uint64_t first,
                                std::uint64_t end, const Sink& sink)
{
    const std::size_t most = tiles_per_piece(values_per_tile_, device_.info());
    reserve(device_, buffers_.needed(parameters_, std::min<std::uint64_t>(most, end - first)));
    for (; first < end; first += most) {
        const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(most, end - first));
        place(tiling, block, {first, count}, buffers_.points);
        piece_.resize(count * values_per_tile_);
        buffers_.points.read(std::span(piece_));
        sink(piece_);
    }
}

PointSet TilePointGenerator::generate_torus(std::uint32_t seed, std::uint32_t period)
{
    PointSet set{parameters_.dimension, {}};
    const TileBlock block{{}, {period, period, parameters_.dimension == 3 ? period : 1}};
    check(block, parameters_.dimension);
    set.coordinates.reserve(block.tiles() * values_per_tile_);
    stream({seed, static_cast<std::int32_t>(period)}, block,
           [&](std::span<const std::uint32_t> units) { append_torus_points(units, period, set.coordinates); });
    return set;
}

DeviceMemory TilePointGenerator::memory(const PoissonTileParameters& p, std::uint64_t tiles, const DeviceInfo& device)
{
    return memory_of(Buffers{}.needed(p, std::min<std::uint64_t>(tiles, tiles_per_piece(values_of_tile(p), device))));
}

UnitStream device_stream(const Device& device, const PoissonTileSet& tiles)
{
    return [generator = std::make_shared<TilePointGenerator>(device, tiles)](
               const PoissonTiling& tiling, const TileBlock& block, std::uint64_t first, std::uint64_t end,
               const auto& sink) { generator->stream(tiling, block, first, end, sink); };
}

UnitStream reference_stream(const PoissonTileSet& tiles)
{
    return [&tiles](const PoissonTiling& tiling, const TileBlock& block, std::uint64_t first, std::uint64_t end,
                    const auto& sink) {
        const auto dimension = static_cast<std::size_t>(tiles.parameters.dimension);
        for (std::uint64_t index = first; index < end; ++index) {
            const std::uint64_t row = index / block.size[0];
            const std::array<std::uint32_t, 3> place{static_cast<std::uint32_t>(index % block.size[0]),
                                                     static_cast<std::uint32_t>(row % block.size[1]),
                                                     static_cast<std::uint32_t>(row / block.size[1])};
            TileBlock tile = block;
            tile.size = {1, 1, 1};
            for (std::size_t axis = 0; axis < 3; ++axis)
                tile.lowest[axis] = static_cast<std::int32_t>(block.lowest[axis] + std::int64_t{place[axis]});
            std::vector<std::uint32_t> units = reference::exact_tile_points(tiles, tiling, tile);
            for (std::size_t i = 0; i < units.size(); ++i) units[i] += place[i % dimension] * units_per_tile;
            sink(units);
        }
    };
}

}
