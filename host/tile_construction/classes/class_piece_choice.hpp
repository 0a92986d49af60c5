// The choice among candidates for a piece whose points have classes: as piece_choice.hpp, with what each class has too
// much or too little of as area, in which the few points of a coarse class count more.
#pragma once

#include "host/tile_construction/boundary_stages.hpp"
#include "host/tile_construction/classes/class_filling.hpp"
#include "host/tile_construction/piece_store.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace poissonlab {

/// The pieces of each class.
using ClassPieceStores = std::vector<PieceStore>;

class ClassPieceChoice
{
public:
    /// `pieces` has those of earlier stages.
    ClassPieceChoice(const PoissonTileParameters& parameters, const TileRegions& regions,
                     const ClassPieceStores& pieces, bool is_last)
        : parameters_(parameters), regions_(regions), pieces_(pieces), is_last_(is_last)
    {}

    /// Notes all pieces that were made on a torus, if it keeps the wanted distances.
    void consider(const BoundaryTorus& torus, const ClassFilledTorus& filled);

    /// Is there a candidate for every piece of this torus?
    bool has_all(const BoundaryTorus& torus) const;

    /// The largest part of the wanted distances that tori kept which failed.
    std::uint32_t best_failure() const { return best_failure_; }

    /// Puts the best candidates into the stores.
    void take(ClassPieceStores& pieces) const;

private:
    using Candidate = std::vector<PiecePoints>; ///< by class

    const PoissonTileParameters& parameters_;
    const TileRegions& regions_;
    const ClassPieceStores& pieces_;
    bool is_last_;
    std::uint32_t best_failure_ = 0;
    std::map<std::pair<std::uint8_t, std::uint32_t>, std::vector<Candidate>> candidates_; ///< by axes and variant
};

}
