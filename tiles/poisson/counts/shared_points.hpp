// The share of points that the tiles of a set have in common.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

namespace poissonlab {

/// The share of a tile's points that a second tile has at the same places, on average over all pairs of tiles of the
/// set, a tile with itself among them: the probability that a point of a tiling is there a tile further as well. With
/// strips over corners of C colours it is (c / C + e / C^2 + i / C^4) / N, of the points in the regions of corners and
/// edges and in the interior.
double shared_points(const PoissonTileSet& set);

}
