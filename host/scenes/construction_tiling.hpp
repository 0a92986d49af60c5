// Which Poisson tile lies where in a stochastic tiling.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.5: corner tiles as they are;
// edge-based tiles by the edges of a Wang tiling, of the tile and of its neighbours; template tiles at
// random.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <variant>

namespace poissonlab {

class ConstructionTiling
{
public:
    /// 2D. Throws InputError for numbers of colours that tilings cannot have.
    explicit ConstructionTiling(const PoissonTileParameters& parameters);

    /// The number of the tile whose lower left corner is (x, y).
    std::uint32_t tile(std::int64_t x, std::int64_t y) const;

private:
    std::uint32_t edge_based_tile(const Tiling& wang, std::int64_t x, std::int64_t y) const;

    PoissonTileParameters parameters_;
    std::variant<Tiling, ColorHash> source_; ///< the hash function: of template tiles
};

}
