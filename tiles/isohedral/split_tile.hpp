// Isohedral tiles that a path divides in two, so that a tiling has tiles of two shapes.
//
// Kaplan and Salesin, Dihedral Escherization, 2004. Where no two tiles of one shape have an edge in common, it is one
// of the patterns of Dress, The 37 combinatorial types of regular "Heaven and Hell" patterns in the euclidean plane,
// 1986.
#pragma once

#include "tiles/isohedral/isohedral_tile.hpp"

namespace poissonlab {

struct TileSplit
{
    std::size_t from = 0, to = 2; ///< corners of the tile, which the path joins
    PlaneCurve path;              ///< from (0, 0) to (1, 0); none: straight
};

struct SplitTile
{
    std::array<std::vector<PlanePoint>, 2>
        parts;             ///< counterclockwise: with the edges from `from` to `to`, and the rest
    std::size_t alike = 0; ///< edges of the tile across which parts of one shape meet
};

/// Throws InputError for corners that the tile does not have or that are equal, and for paths that meet the outline.
SplitTile split_tile(const IsohedralTile& tile, const TileSplit& split);

}
