// How far the pieces of a tile set reach, and how far points are apart at least whose cells have no tile in common:
// the second part of the proof in tile_certificate.hpp.
#pragma once

#include "tiles/poisson/proof/shared_pieces.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// The smallest and largest coordinates of points, relative to the base of their cell.
struct Extents
{
    UnitPosition low{INT32_MAX, INT32_MAX, INT32_MAX};
    UnitPosition high{INT32_MIN, INT32_MIN, INT32_MIN};

    bool are_empty() const { return low[0] > high[0]; }
    void include(const UnitPosition& position);
    void include(const Extents& other);
};

/// The extents of the pieces of all variants by their axes, those of the interiors of all tiles last.
std::vector<Extents> piece_extents(const PoissonTileSet& set, const SharedPieces& pieces);

/// The lower bound of the squared distance of a point of one set from a point of the other one whose cell has no tile
/// in common with the cell of the first. The sets may be the same.
std::uint64_t squared_separation(const std::vector<Extents>& one, const std::vector<Extents>& other, int dimension);

}
