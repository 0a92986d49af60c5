// How far the parts of a piece are from the number of points that they should have, see piece_choice.hpp.
#pragma once

#include "host/tile_construction/piece_store.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

class PieceBalance
{
public:
    /// For tiles with `points` points each that count, all or those of a class. `pieces` has those of earlier stages
    /// and must, as the others, outlive this. `is_last`: next are the interiors.
    PieceBalance(std::uint32_t points, const PoissonTileParameters& parameters, const TileRegions& regions,
                 const PieceStore& pieces, bool is_last)
        : points_(points), parameters_(parameters), regions_(regions), pieces_(pieces), is_last_(is_last)
    {}

    /// The number of points that pieces with these axes have on average.
    double mean(std::uint8_t axes) const { return points_ * regions_.volume(axes); }

    /// The sum of the squares of what the tiles around would have too many points.
    double uneven(std::uint8_t axes, std::uint32_t variant, const PiecePoints& points) const;

private:
    double mean_in_part(std::uint8_t axes) const;

    /// The number of points that pieces of earlier stages lack in the tile at offset `tile`, as far as this piece is to
    /// make up for them.
    double carried(const std::vector<PlacedPiece>& neighbours, const std::array<int, 3>& tile) const;

    std::uint32_t points_;
    const PoissonTileParameters& parameters_;
    const TileRegions& regions_;
    const PieceStore& pieces_;
    bool is_last_;
};

}
