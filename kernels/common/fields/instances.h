// The contract of instances.cl and its host code, host/distribution/instances/instances.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(instances)

// Purposes of random numbers: see pobjects_bits in runtime/object_distribution.h. Scales take six.
enum
{
    PURPOSE_MODEL = 100,
    PURPOSE_INSTANCE_TURN = 101,
    PURPOSE_TILT = 102,
    PURPOSE_TILT_DIRECTION = 103,
    PURPOSE_SCALE = 104,
    SCALE_CONSTANT = 0, ///< a
    SCALE_UNIFORM = 1,  ///< a to b
    SCALE_NORMAL = 2    ///< mean a, standard deviation b
};
REAL(LEAST_SCALE, 0.001)
REAL(WHOLE_TURN, 6.283185307179586) ///< 2 pi, as a double has it

/// Instances of a scene, and its borders in units.
struct InstanceScene
{
    double unit;                        ///< tiles a unit
    double left, bottom, width, height; ///< of the window
    double inner, outer, thickness;     ///< of the ring; in the plane there is none
    double scale_a, scale_b;
    double tilt; ///< the largest one
    uint scale_kind;
    uint models;
};

/// Tiles of a block: rows from south to north, layer by layer.
struct InstanceTiles
{
    ulong begin; ///< of the block's tiles, how many come before the first one
    uint tiles;
    uint columns, rows; ///< of a layer
    int west, south, below; ///< the block's first tile
};

struct PlacedInstance
{
    double position[3]; ///< units
    double turn, scale, tilt, tilt_direction;
    int tile[3];
    uint index, id, model;
    uint is_inside; ///< the scene's borders: 0 or 1
    uint unused;
};

END_CONTRACT
