#include "host/tile_construction/piece_balance.hpp"

#include "host/tile_construction/boundary_stages.hpp"

#include <bit>

namespace poissonlab {

double PieceBalance::mean_in_part(std::uint8_t axes) const
{
    const int across = parameters_.dimension - std::popcount(axes);
    return mean(axes) / (1 << across);
}

double PieceBalance::uneven(std::uint8_t axes, std::uint32_t variant, const PiecePoints& points) const
{
    const PartCounts counts = part_counts(points, axes, parameters_.dimension);
    std::vector<PlacedPiece> neighbours;
    if (is_last_) neighbours = earlier_neighbours(parameters_, axes, variant);
    double sum = 0;
    for (unsigned part = 0; part < 1u << parameters_.dimension; ++part) {
        if (part & axes) continue;
        std::array<int, 3> tile{};
        for (int k = 0; k < parameters_.dimension; ++k) tile[k] = (axes | part) >> k & 1 ? 0 : -1;
        const double excess = counts[part] - mean_in_part(axes) + carried(neighbours, tile);
        sum += excess * excess;
    }
    return sum;
}

double PieceBalance::carried(const std::vector<PlacedPiece>& neighbours, const std::array<int, 3>& tile) const
{
    double sum = 0;
    for (const PlacedPiece& piece : neighbours) {
        bool touches = true;
        unsigned part = 0;
        for (int k = 0; k < parameters_.dimension; ++k) {
            const bool extends = piece.axes >> k & 1;
            touches &= piece.base[k] == tile[k] || (!extends && piece.base[k] == tile[k] + 1);
            if (!extends && piece.base[k] == tile[k]) part |= 1u << k;
        }
        if (!touches) continue;
        const PartCounts counts = part_counts(pieces_.at(piece.axes, piece.variant), piece.axes, parameters_.dimension);
        // A corner touches two edges of its tile (three faces), an edge two corners (two faces).
        const int sharing =
            parameters_.kind == PoissonTileKind::edge ? 2 : parameters_.dimension - std::popcount(piece.axes);
        sum += (counts[part] - mean_in_part(piece.axes)) / sharing;
    }
    return sum;
}

}
