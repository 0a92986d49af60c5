// The smallest distance within tiles, of sets that are tiled.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.7 calls it the intra tile radius, beside that of the
// whole tiling: where it is the larger one, tiles do not fit at their borders.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

namespace poissonlab {

/// The smallest distance between two points of one tile, in unit lengths, of a toroidal tiling of `tiles` tiles along
/// each axis; infinite where no tile has two. A tile is a square (a cube) with its lower borders, and places on borders
/// may be off by 2^-17 tiles, half of the step in which points of tiles are placed.
double min_distance_within_tiles(const PointSet& points, int tiles);

/// Finds the smallest distance within tiles for a set on disk, of which the strips that touch a row (layer) of tiles
/// are in memory at a time.
double min_distance_within_tiles(const PointStrips& points, int tiles);

}
