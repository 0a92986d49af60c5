// The plain C++ twin of kernels/tile_points.cl: a loop over tiles, with the look-up that engines use.
#include "host/tile_points/tile_points.hpp"

namespace poissonlab::reference {
namespace {

/// The tiles of a block in its order: the tile's coordinates, its place in the block.
template <class Visit>
void for_each_tile(const PoissonTileSet& tiles, const PoissonTiling& tiling, const TileBlock& block, const Visit& visit)
{
    const ptiles_tiling look_up = runtime_tiling(tiles, tiling);
    const auto at = [&](std::size_t axis, std::uint32_t place) {
        return block.lowest[axis] + static_cast<std::int32_t>(place);
    };
    for (std::uint32_t z = 0; z < block.size[2]; ++z)
        for (std::uint32_t y = 0; y < block.size[1]; ++y)
            for (std::uint32_t x = 0; x < block.size[0]; ++x)
                visit(tiles.tile(ptiles_tile(&look_up, at(0, x), at(1, y), at(2, z))), std::array{x, y, z});
}

}

std::vector<float> tile_points(const PoissonTileSet& tiles, const PoissonTiling& tiling, const TileBlock& block)
{
    check(block, tiles.parameters.dimension);
    const auto dimension = static_cast<std::size_t>(tiles.parameters.dimension);
    const StoredScale scale = stored_scale(tiles.parameters.border);
    std::vector<float> values;
    for_each_tile(tiles, tiling, block, [&](std::span<const std::uint16_t> units, std::array<std::uint32_t, 3> place) {
        for (std::size_t n = 0; n < units.size(); ++n)
            values.push_back(static_cast<float>(scale.step * units[n]) / 65536 +
                             (static_cast<float>(place[n % dimension]) + static_cast<float>(scale.low) / 65536));
    });
    return values;
}

std::vector<std::uint32_t> exact_tile_points(const PoissonTileSet& tiles, const PoissonTiling& tiling,
                                             const TileBlock& block)
{
    check(block, tiles.parameters.dimension);
    const auto dimension = static_cast<std::size_t>(tiles.parameters.dimension);
    const StoredScale scale = stored_scale(tiles.parameters.border);
    std::vector<std::uint32_t> values;
    for_each_tile(tiles, tiling, block, [&](std::span<const std::uint16_t> units, std::array<std::uint32_t, 3> place) {
        for (std::size_t n = 0; n < units.size(); ++n)
            values.push_back((place[n % dimension] << tile_bits) +
                             static_cast<std::uint32_t>(scale.position(units[n])));
    });
    return values;
}

PointSet torus_points(const PoissonTileSet& tiles, std::uint32_t seed, std::uint32_t period)
{
    const int dimension = tiles.parameters.dimension;
    PointSet set{dimension, {}};
    append_torus_points(exact_tile_points(tiles, {seed, static_cast<std::int32_t>(period)},
                                          {{}, {period, period, dimension == 3 ? period : 1}}),
                        period, set.coordinates);
    return set;
}

}
