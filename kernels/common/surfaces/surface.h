// Surfaces of triangles as kernels see them: the contract of surface_darts.cl and surface_elimination.cl with their host
// code in host/sampling/surfaces.
//
// Coordinates are whole numbers from 0 to 2^COORDINATE_BITS, in units of the surface's grid.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(surface)

enum
{
    COORDINATE_BITS = 30,
    BARYCENTRIC_BITS = 31, ///< shares of a triangle's corners are in units of 2^-31
    NORMAL_BITS = 15,      ///< normals are vectors about 2^15 long
    SLACK = 4,             ///< units by which places of pieces and darts may be wrong, altogether
    LIMIT = 16             ///< units: pieces whose edges are no longer are divided no further
};

/// Set in `halvings` of a piece that is divided no further.
#define LAST_PIECE 0x80000000u

enum DartState
{
    UNDECIDED,
    ACCEPTED,
    REJECTED,   ///< by a dart of the same batch
    COVERED     ///< by a point of former batches
};

enum PieceState
{
    PIECE_OPEN,   ///< part of it may be uncovered
    PIECE_COVERED, ///< by one disk, all of it
    PIECE_SMALL    ///< it is within the limit, and its centre is covered
};

struct Triangle
{
    int corners[9]; ///< x, y, z of each
    int normal[3];
};

/// A part of a triangle: shares of its second and third corner at each of the piece's corners.
struct Piece
{
    uint triangle;
    uint halvings; ///< its area is that of the triangle, halved so often
    uint shares[6];
};

/// A point on the surface.
struct SurfacePoint
{
    int place[3];
    uint triangle;
    uint shares[2]; ///< of its second and third corner; the first one has the rest
    uint next;      ///< in the chain of its bucket, and one; 0: none
    uint number;    ///< of a dart, in its batch; of points 0
};

/// When two points are in conflict, and where the cells are in which such points are looked for.
struct SurfaceRule
{
    ulong squared;    ///< points nearer than its root are in conflict,
    ulong covered;    ///< pieces are covered by points whose squared distance from their corners is less
    int least_cosine; ///< where their normals' product is no less
    uint cell;        ///< side of a cell: twice the distance at least
    uint bucket_mask; ///< a power of two less one
    uint first;       ///< of several classes: the place of the other one's buckets among those of all
};

/// Darts that are thrown together.
struct SurfaceBatch
{
    ulong total;       ///< the sum of the pieces' weights
    ulong first;       ///< number of the first dart
    uint darts;
    uint guide_bits;   ///< 2^guide_bits entries of the guide to weights
    uint key_x, key_y; ///< of random numbers
    uint bucket_mask;  ///< of the darts' own buckets
    uint pieces;
};

END_CONTRACT
