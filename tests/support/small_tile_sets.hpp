// Parameters of tile sets that are built in a moment.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <ostream>

namespace poissonlab {

struct SmallSet
{
    const char* name;
    PoissonTileParameters parameters;
};

inline void PrintTo(const SmallSet& set, std::ostream* out) { *out << set.name; }

/// `number`: colours, or tiles of template tiles.
inline PoissonTileParameters tile_set_parameters(PoissonTileKind kind, int dimension, std::uint32_t number,
                                                 std::uint32_t points, double relative_radius)
{
    PoissonTileParameters p;
    p.kind = kind;
    p.dimension = dimension;
    p.colors = kind == PoissonTileKind::frame ? 1 : number;
    p.tiles = kind == PoissonTileKind::frame ? number : tile_count(kind, dimension, number);
    p.points_per_tile = points;
    p.relative_radius = relative_radius;
    p.lloyd_iterations = 20;
    return p;
}

inline PoissonTileParameters with_repulsion(PoissonTileParameters parameters)
{
    parameters.repulsion = true;
    return parameters;
}

inline PoissonTileParameters with_lloyd(PoissonTileParameters parameters, std::uint32_t iterations)
{
    parameters.lloyd_iterations = iterations;
    return parameters;
}

}
