// The construction of tile sets whose borders are chains of points: docs/chain-tiles.md.
//
// Corner points, chains between them through points of relaxed tori, then the points inside of each tile; then all
// tiles are relaxed together. Not of Lagae's dissertation, whose tiles have strips.
#pragma once

#include "host/tile_construction/joint/joint_relaxation.hpp"
#include "host/tile_construction/tile_construction.hpp"

namespace poissonlab {

/// Fillers for the tori that chains are found in, and for the insides of tiles: see chain_torus_settings() and
/// chain_interior_settings().
struct ChainEngines
{
    TileFiller& tori;
    TileFiller& interiors;
    JointEngine& joint;
};

/// Tori are relaxed as pieces of strips are.
FillSettings chain_torus_settings(const PoissonTileParameters& parameters);

/// Points inside of tiles are thrown and pushed apart; relaxation is left to the iterations of all tiles together.
FillSettings chain_interior_settings(const PoissonTileParameters& parameters);

/// Constructs a tile set as construct_tile_set() does, for parameters with chains.
ConstructedTileSet construct_chain_tiles(const PoissonTileParameters& parameters, const ChainEngines& engines,
                                         const ConstructionOptions& options = {});

}
