// Moving the points of all tiles together so that all tiles get the same moments: docs/chain-tiles.md.
//
// Points of borders belong to many tiles, so the conditions of all tiles are one linear system, sparse, which conjugate
// gradients solve in a fixed order.
#pragma once

#include "host/tile_construction/joint/stored_points.hpp"

namespace poissonlab {

/// Adds the least movement after which the moments of all tiles, up to the order that is asked for, are nearly their
/// mean. What counts is the mean square over a tiling, so points that many tiles have move no farther than others.
/// Memory: 8 bytes a point of a tile that moves, axis and condition; 2.5 GB for 65,536 tiles of 64 points with chains.
void add_moment_step(std::vector<Displacement>& displacements, const StoredPoints& points, const OwnPoints& own_points,
                     const PoissonTileParameters& parameters);

}
