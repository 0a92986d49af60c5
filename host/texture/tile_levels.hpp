// Tiles that are brighter or darker than others make islands on the lattice. Their light is levelled: smooth fields,
// which all tiles share that share a corner or an edge, change it by a few grey levels, and no seam by anything.
//
// A tiling's islands are measured by the variance of means over squares as large as a tile, which begin at multiples of
// half a tile. They follow from the mean light of the quarters of tiles: a square that is a tile has
// its four quarters; one over an edge has two of each of two tiles, which chance brings together at that edge; one over
// a corner has a quarter of each of four. The field is a sum of hats, products of sin^2 or cos^2 along both axes, over
// all corners, middles of edges and middles of tiles. Hats of edges and corners are flat in the ring, where those of
// tiles are 0, so that what tiles share changes in all of them alike. The sum of all hats is 1 everywhere. Their
// heights make the variance of squares plus a weight times the field's mean square least (Tikhonov's regularisation;
// conjugate gradients), in each channel by itself. All channels have one weight: the largest that leaves no more
// variance of their sum than the exemplar has. Fields thus have a small mean square.
#pragma once

#include "tiles/texture/texture_set.hpp"

#include <span>
#include <vector>

namespace poissonlab {

/// Variances of means over squares of T x T pixels in parts of the variance of pixels. Sums over channels count.
struct SquareVariances
{
    double exemplar = 0, tiling = 0;
    bool is_known = false; ///< the exemplar has at least four tiles a side, and thus squares enough to tell

    /// True if the tiling has clearly more.
    bool is_uneven() const;
};

/// Measures what a set shows.
SquareVariances square_variances(const TextureSet& set);

/// The change of each number that a set shows, before it is rounded, so that the variance comes near the
/// exemplar's.
std::vector<double> level_changes(const TextureSet& set, std::span<const double> shown);

}
