// The contract of sector_darts.cl, its host code, host/sampling/sectors/sector_darts.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(sector_darts)

enum
{
    LOGARITHMIC, ///< variants
    LINEAR,
    BOUNDARY,
    GROWING = 0, ///< states of a set
    FULL,
    OUT_OF_ROOM,
    FIRST_USE = 0, ///< of random numbers: the first dart, the choice of a point, and later darts
    CHOICE_USE,
    DART_USE,
    MAX_NEIGHBOURS = 96,   ///< disks of half the distance that a disk of 4.5 times it holds: 73 by area
    MAX_RANGES = 64,       ///< of free angles around a point
    MAX_SECTORS = 128,     ///< of a region
    SECTORS_PER_POINT = 6, ///< that all regions have in the mean, at any time
    LEAST_SECTORS = 1024
};

REAL(UNITS, 4294967296.0)   ///< of the torus' side
REAL(LEAST_ANGLE, 1e-9)     ///< narrower slivers are dropped
REAL(LEAST_AREA, 1e-12)     ///< the same of the square of the distance
REAL(REJECTED_RADIUS, 1e-6) ///< of the disk that a rejected dart takes from its region, in distances
REAL(REJECTED_ANGLE, 1e-9)  ///< half of what it takes from a circle

/// The values that all sets of a call share.
struct SectorRules
{
    ulong distance; ///< least distance of two points, units
    double reach;   ///< least distance at which darts are thrown, units
    uint variant;
    uint sets;
    uint grid_bits; ///< cells along an axis: two to this
    uint capacity;  ///< points of a set
    uint sectors;   ///< of all regions of a set
    uint leaves;    ///< of the tree of areas: a power of two
    uint steps;     ///< of each set in one call
    uint unused;
};

/// A set between two calls.
struct GrowingSet
{
    ulong draws;
    uint key_x, key_y; ///< of random numbers
    uint points;
    uint open; ///< points with room beside them; of logarithmic sets, regions that are not empty
    uint state;
    uint leaves;       ///< of the tree so far
    uint used_sectors; ///< those from here on were never in use
    uint free_sector;  ///< the first of those that are no longer in use, and one; 0: none
};

/// An arc as a distance for each direction: of a circle's two intersections with a ray, the nearer or the farther.
struct SectorArc
{
    double x, y; ///< of the circle's centre
    double radius;
    double side; ///< 1: the farther, -1: the nearer
};

/// All places between two directions and two arcs.
struct Sector
{
    double begin, end;
    struct SectorArc inner, outer;
    double area;
};

/// A sector of a region that is kept, and the next one of the region and one; 0: the last.
struct KeptSector
{
    struct Sector sector;
    ulong next;
};

END_CONTRACT
