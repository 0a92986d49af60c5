// tile_darts.cl and tile_relaxation.cl share these constants and records with their host code,
// host/tile_construction/filling/tile_filler.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(tile_filling)

enum
{
    TILE_BITS = 16,      ///< coordinates are units of which a tile's side has 2^16
    FAR_LENGTH = 32767,  ///< longer lengths along an axis count as this: no distance that is asked for is as large
    BATCH = 32,          ///< darts that a work-group looks at together
    MAX_DARTS = 1 << 22, ///< of a filling, whole batches: one that needs more is given up
    MAX_ITEMS = 256,     ///< of a work-group
    MAX_REACHES = 3,
    MAX_MONOMIALS = 19,  ///< up to order 3, in space
    HALF_TILE_BITS = 15, ///< moments are taken from the middle of a tile
    COARSE_BITS = 5,     ///< that slopes of moments leave out of coordinates, so that sums of their products are exact
    NEAR_POINTS = 4,     ///< a moment is near if all points and so many more make up for what it lacks, each of which
    NEAR_SHIFT = 2,      ///< moves by 2^-NEAR_SHIFT of a unit,
    ALIKE_SHIFT = 1      ///< or by half a unit among first moments alone: points move alike then, by whole units
};

/// A condition on moments that has less than this part of its own left, beside those before it, is dropped.
REAL(LEAST_PIVOT, 0x1p-30)

/// Entries of the list of points around a point: their number, the points, and the point itself, at least once.
DERIVED(LIST_WORDS, (size_t DIMENSION), DIMENSION == 2 ? 64 : 256)

/// Bounds of folded coordinates, see tiles/poisson/tile_regions.hpp.
struct Regions
{
    int width, pair_one, pair_sum, corner_one, corner_two, corner_three;
};

/// The tori that a launch works on.
struct Tori
{
    ulong cells; ///< in which points may lie, as bits
    struct Regions regions;
    uint capacity;   ///< entries of a torus for each axis
    uint copies;     ///< images of each point: 1, or 2^DIMENSION for the torus of one tile
    uint in_polygon; ///< else in cells: points lie inside of the polygon whose corners are the held points, in order
    uint keep_tiles; ///< points do not leave the tile that they are in
};

/// The arguments of throw_tile_darts.
struct Darts
{
    struct Tori tori;
    uint attempt, zone, key_x, key_y; ///< of random numbers
    int low;                          ///< of the box that darts fall into, along each axis
    uint extent;                      ///< of the box
    uint levels;                      ///< squared distances
    uint attempts;                    ///< failures in a row before the next
};

/// The arguments of relax_tiles.
struct Relaxation
{
    struct Tori tori;
    ulong surrounding_cells; ///< in which surroundings move; 0: they are held
    double spacing;          ///< mean distance of points; units
    uint iterations;
    uint keeps_last;          ///< else the best iterate
    uint wanted;              ///< squared distance
    int reaches[MAX_REACHES]; ///< half widths of the boxes that are looked into for Voronoi neighbours, in this order
    uint reach_count;
    int listed; ///< half the width of the box, in 2D the radius of the disk, whose points are listed for each
    int slack;  ///< how much larger it is, as lists stand for several iterations
    uint max_moving; ///< lists of a torus: as many as move, in whole vectors
};

/// The arguments of repel_tiles.
struct Repulsion
{
    struct Tori tori;
    double distance; ///< closer points are pushed apart; units
    uint passes, wanted;
    uint surroundings_moved; ///< in relax_tiles
    uint monomials;          ///< whose sums over active points are brought to what is wanted
};

END_CONTRACT
