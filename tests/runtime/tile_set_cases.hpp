// Tile sets of every kind and dimension, to go through.
#pragma once

#include "tests/support/random_tile_set.hpp"

#include <vector>

namespace poissonlab {

inline std::vector<PoissonTileSet> tile_sets_of_every_kind()
{
    return {random_tile_set(PoissonTileKind::corner, 2, 3, 7),
            random_tile_set(PoissonTileKind::corner, 2, 4, 64),
            random_tile_set(PoissonTileKind::corner, 2, 8, 16),
            random_tile_set(PoissonTileKind::corner, 3, 2, 11),
            random_tile_set(PoissonTileKind::corner, 3, 3, 16),
            random_tile_set(PoissonTileKind::edge, 2, 2, 5),
            random_tile_set(PoissonTileKind::edge, 2, 1, 40),
            random_tile_set(PoissonTileKind::frame, 2, 1, 4, 13),
            random_tile_set(PoissonTileKind::frame, 2, 1, 32, 1),
            random_chain_set(3, 20),
            random_chain_set(2, 5),
            random_class_set(3, {3, 4, 9}),
            with_random_ranks(random_class_set(2, {4, 1, 7})),
            with_random_ranks(random_chain_set(2, 7)),
            with_random_ranks(random_tile_set(PoissonTileKind::corner, 3, 2, 12)),
            with_random_ranks(random_tile_set(PoissonTileKind::frame, 2, 1, 9, 3))};
}

inline std::string name_of(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    return kind_name(p) + ", " + std::to_string(p.colors) + " colours, " + std::to_string(p.points_per_tile) +
           " points";
}

}
