#include "host/tile_construction/piece_store.hpp"

#include "host/tile_construction/filling/tile_filling.hpp"

#include <algorithm>

namespace poissonlab {

PartCounts part_counts(const PiecePoints& points, std::uint8_t axes, int dimension)
{
    PartCounts counts{};
    for (const TilePosition& point : points) {
        unsigned part = 0;
        for (int k = 0; k < dimension; ++k) {
            if (!(axes >> k & 1) && point[k] >= 0) part |= 1u << k;
        }
        ++counts[part];
    }
    return counts;
}

PieceStore::PieceStore(const PoissonTileParameters& parameters)
{
    for (std::uint8_t axes = 0; axes < all_axes(parameters.dimension); ++axes)
        pieces_[axes].resize(piece_count(parameters, axes));
}

void PieceStore::place(const PlacedPiece& piece, std::vector<TilePosition>& points) const
{
    for (const TilePosition& point : at(piece.axes, piece.variant)) {
        TilePosition position{};
        for (std::size_t k = 0; k < 3; ++k) position[k] = wrapped(point[k] + piece.base[k] * tile_units);
        points.push_back(position);
    }
}

std::vector<TilePosition> PieceStore::placed(std::span<const PlacedPiece> pieces) const
{
    std::vector<TilePosition> points;
    for (const PlacedPiece& piece : pieces) place(piece, points);
    return points;
}

unsigned cell_number(const PlacedPiece& piece, int dimension)
{
    unsigned base = 0;
    for (int k = 0; k < dimension; ++k) base |= static_cast<unsigned>(piece.base[k] & 1) << k;
    return cell_number(piece.axes, base, dimension);
}

PiecePoints cut_out(std::span<const TilePosition> points, const TileRegions& regions, std::uint8_t axes,
                    const std::array<std::int8_t, 3>& base, bool is_one_tile)
{
    const int dimension = regions.dimension;
    const unsigned wanted = cell_number({axes, base, 0}, dimension);
    PiecePoints cut;
    for (const TilePosition& point : points) {
        const unsigned cell = cell_at(regions, point);
        if ((cell & all_axes(dimension)) != axes || (!is_one_tile && cell != wanted)) continue;
        TilePosition relative = point;
        for (int k = 0; k < dimension; ++k) {
            const auto corner = static_cast<std::int32_t>(cell >> dimension >> k & 1);
            relative[k] = shortest(point[k] - corner * tile_units);
        }
        cut.push_back(relative);
    }
    return cut;
}

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
        std::vector<UnitPosition> points = own_border_points(pieces.borders, p, tile);
        points.insert(points.end(), pieces.interiors[tile].begin(), pieces.interiors[tile].end());
        std::ranges::stable_sort(points, {}, [&](const UnitPosition& point) { return class_of(point, p); });
        for (const UnitPosition& point : points) append(point);
    }
    return set;
}

}
