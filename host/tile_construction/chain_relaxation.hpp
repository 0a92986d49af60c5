// One iteration of relaxing all tiles of a set with chains together: docs/chain-tiles.md.
#pragma once

#include "host/tile_construction/joint/joint_relaxation.hpp"
#include "tiles/poisson/chain_pieces.hpp"

#include <cstdint>

namespace poissonlab {

/// Moves insides and, if asked for, chains by the mean of what Lloyd relaxation does to their copies and by nulling;
/// shifts chains towards the balance of all, and mends them. Afterwards chains are sound, and points inside of their
/// borders; the minimum distance is not looked at.
void relax_together(ChainPieces& pieces, const PoissonTileParameters& parameters, JointEngine& engine,
                    std::uint32_t iteration, bool chains_move);

/// Moves insides by nulling alone, so that moments stay nearly as they are.
void even_insides(ChainPieces& pieces, const PoissonTileParameters& parameters, JointEngine& engine);

/// Moves chains so that tiles can have equal moments, and mends them: a step of those that iterations make as well.
void even_out_chains(ChainPieces& pieces, const PoissonTileParameters& parameters);

}
