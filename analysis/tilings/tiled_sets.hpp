// The share of a tiling's power that lies on the lattice of its tiles' frequencies: what repeats with the tiles.
//
// The smallest distance within tiles, of sets that are tiled.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.7 calls it the intra tile radius, beside that of the
// whole tiling: where it is the larger one, tiles do not fit at their borders.
#pragma once

#include "analysis/spectra/half_spectrum.hpp"
#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

namespace poissonlab {

/// Throws MissingModule if this program was built without measures of tiled sets. Long work on such sets calls this
/// function first.
void need_tile_measures();

/// The power at all frequencies f = M (a, b[, c]) but 0 over that at all frequencies but 0, of those below half of the
/// spectrum's size along each axis. `tiles` is M, at least 1: with one tile it is 1. Random points have about M^-d.
///
/// A point that two places of a tiling have in common with probability s, wherever it is, adds s to this share, so that
/// tiles whose shared points are random have s + (1 - s) M^-d. Throws InputError for fewer tiles than 1.
double lattice_share(const HalfSpectrum& periodogram, int tiles);

/// The smallest distance between two points of one tile, in unit lengths, of a toroidal tiling of `tiles` tiles along
/// each axis; infinite where no tile has two. A tile is a square (a cube) with its lower borders, and places on borders
/// may be off by 2^-17 tiles, half of the step in which points of tiles are placed.
double min_distance_within_tiles(const PointSet& points, int tiles);

/// Finds the smallest distance within tiles for a set on disk, of which the strips that touch a row (layer) of tiles
/// are in memory at a time.
double min_distance_within_tiles(const PointStrips& points, int tiles);

}
