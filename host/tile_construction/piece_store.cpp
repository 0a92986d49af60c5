#include "host/tile_construction/piece_store.hpp"

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
        TilePosition relative{};
        for (int k = 0; k < dimension; ++k) {
            const auto corner = static_cast<std::int32_t>(cell >> dimension >> k & 1);
            relative[k] = shortest(point[k] - corner * tile_units);
        }
        cut.push_back(relative);
    }
    return cut;
}

}
