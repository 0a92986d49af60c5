#include "tiles/tilings/tile_rows.hpp"

#include "tiles/tilings/row_arithmetic.hpp"

namespace poissonlab {

TileRows::TileRows(const Tiling& tiling) : tiling_(tiling), rows_(tiling.period().x) {}

void TileRows::fill(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles)
{
    switch (tiling_.algorithm()) {
    case DirectAlgorithm::corner:
        return fill_corner(x, y, tiles);
    case DirectAlgorithm::wang_two_hashes:
    case DirectAlgorithm::wang_one_hash:
        return fill_corner_sums(x, y, tiles);
    case DirectAlgorithm::wang_edge_hash:
        return fill_edges(x, y, tiles);
    }
}

void TileRows::fill_corner(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles)
{
    const Torus torus{tiling_.period()};
    const std::size_t points = tiles.size() + 1;
    const auto* north = rows_.row(0, tiling_.hash(), {x, torus.y(stepped(y, 1)), 1, 0, points});
    const auto* south = rows_.row(0, tiling_.hash(), {x, torus.y(y), 1, 0, points});
    index_corner_tiles(south, north, tiling_.tile_set().colors().horizontal, tiles);
}

void TileRows::fill_corner_sums(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles)
{
    const Torus torus{tiling_.period()};
    const WangColors colors = tiling_.tile_set().colors();
    const std::size_t points = tiles.size() + 1;
    const PointRow north_points{x, torus.y(stepped(y, 1)), 1, 0, points};
    const PointRow south_points{x, torus.y(y), 1, 0, points};
    const auto* north = rows_.row(0, tiling_.hash(), north_points);
    const auto* south = rows_.row(0, tiling_.hash(), south_points);
    north_.resize(tiles.size());
    south_.resize(tiles.size());
    add_colors(north, north + 1, colors.horizontal, north_);
    add_colors(south, south + 1, colors.horizontal, south_);
    if (tiling_.algorithm() == DirectAlgorithm::wang_two_hashes) {
        north = rows_.row(1, tiling_.vertical_hash(), north_points);
        south = rows_.row(1, tiling_.vertical_hash(), south_points);
    }
    vertical_.resize(points);
    add_colors(south, north, colors.vertical, vertical_);
    index_wang_tiles(north_.data(), south_.data(), vertical_.data(), colors, tiles);
}

void TileRows::fill_edges(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles)
{
    const Torus torus{tiling_.period()};
    const std::int64_t south_y = doubled(torus.y(y));
    const std::int64_t north_y = doubled(torus.y(stepped(y, 1)));
    const auto* north = rows_.row(0, tiling_.hash(), {x, north_y, 2, 1, tiles.size()});
    const auto* south = rows_.row(0, tiling_.hash(), {x, south_y, 2, 1, tiles.size()});
    const auto* vertical = rows_.row(2, tiling_.vertical_hash(), {x, stepped(south_y, 1), 2, 0, tiles.size() + 1});
    index_wang_tiles(north, south, vertical, tiling_.tile_set().colors(), tiles);
}

}
