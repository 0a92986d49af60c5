// A proof of the minimum distance of every tiling of a tile set whose borders are chains: docs/chain-tiles.md, theorem.
//
// Looked at, in whole numbers: that all tiles hold the same shared pieces; all distances among the points of a tile
// and its border; the length of every link; that every border is a simple polygon with the tile's own points inside;
// and that chains keep to their cones and near their edges, so that those without a common tile stay apart.
#pragma once

#include "tiles/poisson/proof/tile_certificate.hpp"

namespace poissonlab {

/// Certifies a set with chains, as certify() does sets with strips. Throws InputError, a sentence that names the tile
/// or the chain, where the theorem does not hold.
TileCertificate certify_chains(const PoissonTileSet& set);

}
