#include "host/tile_construction/strip_pieces.hpp"

#include <algorithm>

namespace poissonlab {

TilePosition relative_to_base(const TilePosition& position)
{
    return {shortest(position[0]), shortest(position[1]), shortest(position[2])};
}

TilePosition placed_at(const TilePosition& point, const std::array<std::int8_t, 3>& base)
{
    TilePosition position = point;
    for (std::size_t k = 0; k < 3; ++k) position[k] += base[k] * tile_units;
    return position;
}

bool is_in_tile(const TilePosition& position)
{
    return std::ranges::all_of(position, [](std::int32_t x) { return x >= 0 && x < tile_units; });
}

std::vector<UnitPosition> own_border_points(const PieceStore& borders, const PoissonTileParameters& p,
                                            std::uint32_t tile)
{
    std::vector<UnitPosition> points;
    for (const PlacedPiece& piece : pieces_around(p, tile))
        for (const TilePosition& point : borders.at(piece.axes, piece.variant))
            if (const TilePosition position = placed_at(point, piece.base); is_in_tile(position))
                points.push_back(position);
    return points;
}

TilePosition on_torus(const TilePosition& relative)
{
    return {wrapped(relative[0]), wrapped(relative[1]), wrapped(relative[2])};
}

PoissonTileSet tile_set_of(const StripPieces& pieces, const PoissonTileParameters& p)
{
    PoissonTileSet set{p, 0, {}};
    const auto append = [&](const TilePosition& point) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(p.dimension); ++k)
            set.points.push_back(static_cast<std::uint16_t>(point[k]));
    };
    for (std::uint32_t tile = 0; tile < p.tiles; ++tile) {
        for (const UnitPosition& point : own_border_points(pieces.borders, p, tile)) append(point);
        for (const TilePosition& point : pieces.interiors[tile]) append(point);
    }
    return set;
}

}
