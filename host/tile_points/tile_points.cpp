#include "host/tile_points/tile_points.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

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

/// Longer runs are refused: kernels divide the numbers of tiles below 2^31.
constexpr std::uint32_t max_run = std::uint32_t{1} << 30;

/// n / width = n * factor >> shift for all n below 2^31, where width is at most 2^16: with 2^b the power of
/// two that is not below the width, shift = 31 + b and factor = 2^shift / width rounded up, which makes the
/// product too large by less than n < 2^shift / width.
struct Reciprocal
{
    std::uint32_t factor;
    std::uint32_t shift;
};

Reciprocal reciprocal_of(std::uint32_t width)
{
    const auto shift = 31 + static_cast<std::uint32_t>(std::bit_width(width - 1));
    return {static_cast<std::uint32_t>(((std::uint64_t{1} << shift) + width - 1) / width), shift};
}

/// The place in the block at which a run starts.
std::array<std::uint32_t, 3> first_place(const TileBlock& block, const TileRun& run)
{
    const std::uint64_t row = run.first / block.size[0];
    return {static_cast<std::uint32_t>(run.first % block.size[0]), static_cast<std::uint32_t>(row % block.size[1]),
            static_cast<std::uint32_t>(row / block.size[1])};
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

void append_torus_points(std::span<const std::uint32_t> units, std::uint32_t period, std::vector<double>& coordinates)
{
    const double side = 65536.0 * period;
    for (const std::uint32_t unit : units) coordinates.push_back(unit / side);
}

TilePointGenerator::TilePointGenerator(Device device, const PoissonTileSet& tiles, std::size_t work_group_size)
    : device_(std::move(device)), parameters_(tiles.parameters),
      work_group_size_(work_group_size == 0 ? 256 : work_group_size),
      values_per_tile_(std::size_t{parameters_.points_per_tile} * static_cast<std::size_t>(parameters_.dimension)),
      units_(device_.buffer<std::uint16_t>(tiles.points.size())), look_up_(kernel("look_up_tiles", "float")),
      place_floats_(kernel("place_points", "float")), place_integers_(kernel("place_points", "uint"))
{
    units_.write(tiles.points);
}

/// Constants for the compiler: loops over a tile's points are unrolled, remainders by the colours are
/// products.
Kernel TilePointGenerator::kernel(const char* name, const char* value)
{
    const auto number = [](std::uint32_t n) { return std::to_string(n) + "u"; };
    return device_.kernel(kernel_program("tile_points.cl", {{"KIND", static_cast<std::uint32_t>(parameters_.kind)},
                                                            {"DIMENSION", parameters_.dimension},
                                                            {"COLORS", number(parameters_.colors)},
                                                            {"TILES", number(parameters_.tiles)},
                                                            {"POINTS", number(parameters_.points_per_tile)},
                                                            {"VALUE", value}}),
                          name);
}

void TilePointGenerator::look_up(const PoissonTiling& tiling, const TileBlock& block, const TileRun& run)
{
    const auto [x, y, z] = first_place(block, run);
    const auto [factor, shift] = reciprocal_of(block.size[0]);
    reserve(device_, tiles_, run.count);
    look_up_.run(run.count, work_group_size_, tiling.seed, tiling.period, block.lowest[0], block.lowest[1],
                 block.lowest[2], block.size[0], factor, shift, block.size[1], x, y, z, run.count, tiles_);
}

template <class Value>
void TilePointGenerator::place_values(Kernel& place, const PoissonTiling& tiling, const TileBlock& block,
                                      const TileRun& run, Buffer<Value>& points)
{
    check(block, parameters_.dimension);
    if (run.count > max_run) throw InputError(fmt::format("a run of {} tiles: must be at most {}", run.count, max_run));
    look_up(tiling, block, run);
    const auto [x, y, z] = first_place(block, run);
    const auto [factor, shift] = reciprocal_of(block.size[0]);
    place.run(run.count, work_group_size_, tiles_, units_, block.size[0], factor, shift, block.size[1], x, y, z,
              run.count, points);
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

void TilePointGenerator::stream(const PoissonTiling& tiling, const TileBlock& block,
                                const std::function<void(std::span<const std::uint32_t> units)>& sink)
{
    const std::size_t most = tiles_per_piece(values_per_tile_, device_.info());
    const std::uint64_t tiles = block.tiles();
    std::vector<std::uint32_t> values;
    Buffer<std::uint32_t> points =
        device_.buffer<std::uint32_t>(std::min<std::uint64_t>(most, tiles) * values_per_tile_);
    for (std::uint64_t first = 0; first < tiles; first += most) {
        const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(most, tiles - first));
        place(tiling, block, {first, count}, points);
        values.resize(count * values_per_tile_);
        points.read(std::span(values));
        sink(values);
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
    const std::size_t values_per_tile = std::size_t{p.points_per_tile} * static_cast<std::size_t>(p.dimension);
    const std::uint64_t piece = std::min<std::uint64_t>(tiles, tiles_per_piece(values_per_tile, device));
    DeviceMemory memory;
    memory.add_buffer<std::uint16_t>(p.tiles * values_per_tile);
    return memory.add_buffer<std::uint32_t>(piece).add_buffer<std::uint32_t>(piece * values_per_tile);
}

}
