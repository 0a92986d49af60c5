// Tile sets and tilings as the grids that pictures are drawn from.
#pragma once

#include "reports/drawings/cube_tile_image.hpp"
#include "reports/drawings/tile_image.hpp"
#include "tiles/tilings/cube_tiling.hpp"
#include "tiles/tilings/tile_set.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace poissonlab {

/// All tiles of a set in order of their indices; with columns = 0, as many as make the picture nearly square.
inline TileGrid tile_set_grid(const TileSet& tiles, std::size_t columns = 0)
{
    const auto nearly_square = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(tiles.size()))));
    TileGrid grid{tiles.kind(), tiles.colors(), columns > 0 ? columns : nearly_square, {}, true};
    for (std::uint64_t position = 0; position < tiles.size(); ++position) grid.tiles.push_back(tiles.index(position));
    return grid;
}

/// A window of a tiling.
inline TileGrid tiling_grid(const Tiling& tiling, const TileWindow& window)
{
    TileGrid grid{tiling.tile_set().kind(), tiling.tile_set().colors(), window.width, {}, false};
    tiling.stream(window, [&](auto, auto, std::span<const TileIndex> tiles) {
        grid.tiles.insert(grid.tiles.end(), tiles.begin(), tiles.end());
    });
    return grid;
}

/// All cubes of a set in order of their indices, so many in a row.
inline CubeGrid cube_set_grid(const TileSet& cubes, std::size_t columns)
{
    CubeGrid grid{cubes.colors().horizontal, {columns, (cubes.size() + columns - 1) / columns, 1}, {}, true};
    for (std::uint64_t position = 0; position < cubes.size(); ++position) grid.cubes.push_back(cubes.index(position));
    return grid;
}

/// A block of a tiling.
inline CubeGrid cube_tiling_grid(const CubeTiling& tiling, const CubeWindow& window)
{
    CubeGrid grid{tiling.tile_set().colors().horizontal, {window.width, window.height, window.depth}, {}, false};
    for (std::uint64_t z = 0; z < window.depth; ++z)
        for (std::uint64_t y = 0; y < window.height; ++y)
            for (std::uint64_t x = 0; x < window.width; ++x)
                grid.cubes.push_back(tiling.tile(window.x + static_cast<std::int64_t>(x),
                                                 window.y + static_cast<std::int64_t>(y),
                                                 window.z + static_cast<std::int64_t>(z)));
    return grid;
}

}
