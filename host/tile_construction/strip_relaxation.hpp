// Relaxing all tiles of a set with strips together: docs/chain-tiles.md says what that is and what it gains.
//
// Not of Lagae's dissertation, which relaxes pieces one after the other. Points stay in the regions that the strips
// divide tiles into, so what the regions keep apart stays apart; the rest is pushed apart again at the end.
#pragma once

#include "host/tile_construction/joint/joint_relaxation.hpp"
#include "host/tile_construction/piece_store.hpp"
#include "host/tile_construction/tile_construction.hpp"

namespace poissonlab {

/// Makes the joint iterations that are asked for, with nulling and equal moments if these are. `pieces` have the
/// minimum distance, and have it afterwards: what cannot be pushed apart goes back to where it was, at the latest with
/// everything around it.
void relax_together(StripPieces& pieces, const PoissonTileParameters& parameters, const JointEngines& engines,
                    const ConstructionOptions& options, ConstructionReport& report);

}
