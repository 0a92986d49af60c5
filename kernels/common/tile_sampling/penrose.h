// The contract of penrose.cl and its host code, host/tile_sampling/penrose/.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(penrose)

enum
{
    POINT,
    OLD_POINT,
    THIN,
    THIN_TWIN,
    FAT,
    FAT_TWIN,
    INDICES = 21,       ///< structural indices
    ROWS = 21,          ///< of the table: importances of a level
    DEEPEST = 30,       ///< level of tiles
    SCALES = 32,        ///< those of all levels, and what tells them from the next ones
    TURNS = 20,         ///< directions
    FRACTION_BITS = 56, ///< of places
    UNIT_BITS = 32,     ///< of points
    WAITING = 61        ///< most triangles that wait while one is divided down to the deepest level
};

/// tiles/penrose/penrose_tiles.hpp says more.
struct Tile
{
    long place[4];
    ulong value;
    uint kind, direction, digits, level;
};

/// A level: the ring's unit vectors as places, and the importances that end there.
struct Scale
{
    long axis_x[4], axis_y[4];         ///< 1, z, z^2, z^3
    long turn_x[TURNS], turn_y[TURNS]; ///< a unit of the table's vectors, by direction
    long reach;                        ///< farther away no point moves that comes from a triangle of this level
    ulong ones[2];                     ///< values of the digit pairs 01 and 10
    ulong rows[ROWS];                  ///< the first importance of each row
};

/// A square window of points, and how dense they are.
struct Request
{
    ulong importance;        ///< where the density has full weight
    long low_x, low_y, side; ///< units of 2^-32
    long root_x, root_y;     ///< first corner of the root, units of 2^-56
    uint width, height;      ///< of the density
    uint tiles;
    uint unused;
};

END_CONTRACT
