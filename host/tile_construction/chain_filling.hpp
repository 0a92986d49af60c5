// The insides of tiles with chains: points are thrown into the polygon of a tile's chains, or pushed apart there.
#pragma once

#include "host/tile_construction/chain_construction.hpp"
#include "tiles/poisson/chain_geometry.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <vector>

namespace poissonlab {

// The corner points of tiles with chains: one a colour, spread so that their lattice shows as little as it can.

/// Offsets from the lattice point, by colour: of many random choices in a disk of 0.7 spacings, that whose mean
/// transform has the least fourth power at the frequencies that points of this density should not have. Even units.
std::vector<UnitPosition> spread_corners(const PoissonTileParameters& parameters);

class MomentTargets;

/// The corner point and the chains that tilings take from a tile.
std::vector<UnitPosition> own_border_points(const ChainPieces& pieces, const PoissonTileParameters& parameters,
                                            std::uint32_t tile);

/// Fills tiles, each on its own, with so many points that the tile has its number, and with moments if any are asked
/// for.
class ChainFiller
{
public:
    using Tiles = std::vector<std::uint32_t>;

    ChainFiller(ChainPieces& pieces, const PoissonTileParameters& parameters, TileFiller& interiors,
                const ConstructionOptions& options, ConstructionReport& report)
        : p_(parameters), pieces_(pieces), interiors_(interiors), options_(options), report_(report),
          wanted_(chain_interior_settings(parameters).wanted)
    {}

    /// Throws all points anew. Returns the tiles that could not be filled.
    Tiles fill_anew(Tiles open, std::uint32_t stage_number, std::uint32_t round,
                    const MomentTargets* moments = nullptr);

    /// Pushes the points of tiles apart. Returns the tiles that do not get the minimum distance.
    Tiles repel(const Tiles& open, const MomentTargets* moments = nullptr);

private:
    FillProblem problem_of(std::uint32_t tile, const MomentTargets* moments) const;

    /// Takes over what has the distance, and returns the other tiles.
    Tiles fill(const Tiles& tiles, const std::vector<FillProblem>& problems, std::uint32_t stage_number,
               std::uint32_t attempt, const MomentTargets* moments);

    const PoissonTileParameters& p_;
    ChainPieces& pieces_;
    TileFiller& interiors_;
    const ConstructionOptions& options_;
    ConstructionReport& report_;
    const std::uint64_t wanted_; ///< squared distance of points before they are rounded
};

}
