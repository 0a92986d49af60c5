#include "host/tile_points/unit_stream.hpp"

#include <array>
#include <memory>
#include <vector>

namespace poissonlab {

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
