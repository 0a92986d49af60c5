// Makes the mean of all tiles even: a step of gradient descent on the power of its transform at low frequencies.
//
// A tiling shows the mean tile at the frequencies of its lattice, docs/chain-tiles.md. Positions are whole units and
// frequencies whole cycles a tile, so phases are exact; their cosines and sines come from a table, so that the plain
// twin, host/tile_construction/reference/joint_relaxation.cpp, adds the same numbers in the same order.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/joint_nulling.h"

/// exp(-2 pi i k.x)
double2 wave(global const double2* circle, int2 frequency, int2 position)
{
    const uint phase = (uint)frequency.x * (uint)position.x + (uint)frequency.y * (uint)position.y;
    return circle[phase & (TURN - 1)];
}

/// The transform of the mean tile: a work-item a frequency.
kernel void transform_mean_tile(struct Nulling nulling, global const double2* circle, global const int2* positions,
                                global const double* weights, global const int2* frequencies,
                                global double2* transform)
{
    const uint k = get_global_id(0);
    if (k >= nulling.frequencies) return;
    const int2 frequency = frequencies[k];
    double2 sum = 0;
    for (uint i = 0; i < nulling.points; ++i) sum += weights[i] * wave(circle, frequency, positions[i]);
    transform[k] = sum;
}

/// The movements of points: a work-item a point.
kernel void descend(struct Nulling nulling, global const double2* circle, global const int2* positions,
                    global const double* weights, global const int2* frequencies, global const double2* transform,
                    global double2* displacements)
{
    const uint i = get_global_id(0);
    if (i >= nulling.points) return;
    double2 sum = 0;
    for (uint k = 0; k < nulling.frequencies; ++k) {
        const double2 e = wave(circle, frequencies[k], positions[i]);
        const double2 f = transform[k];
        const double slope = f.x * e.y - f.y * e.x; // imaginary part of conj(F) e
        const double2 frequency = convert_double2(frequencies[k]);
        sum += frequency * (slope / (frequency.x * frequency.x + frequency.y * frequency.y));
    }
    double2 movement = sum * (-nulling.step * weights[i]);
    const double length = sqrt(movement.x * movement.x + movement.y * movement.y);
    if (length > nulling.longest) movement *= nulling.longest / length;
    displacements[i] = movement;
}
