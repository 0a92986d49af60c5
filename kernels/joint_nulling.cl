// Makes the mean of all tiles even: a step of gradient descent on the power of its transform at low frequencies.
//
// A tiling shows the mean tile at the frequencies of its lattice, docs/chain-tiles.md. Positions are whole units and
// frequencies whole cycles a tile, so phases are exact; their cosines and sines come from a table, so that the plain
// twin, host/tile_construction/reference/joint_relaxation.cpp, adds the same numbers in the same order.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/tiles/joint_nulling.h"

/// exp(-2 pi i k.x)
double2 wave(global const double2* circle, global const int* frequency, global const int* position)
{
    uint phase = 0;
    for (uint axis = 0; axis < DIMENSION; ++axis) phase += (uint)frequency[axis] * (uint)position[axis];
    return circle[phase & (TURN - 1)];
}

/// The transform of the mean tile: a work-item a frequency.
kernel void transform_mean_tile(struct Nulling nulling, global const double2* circle, global const int* positions,
                                global const double* weights, global const int* frequencies,
                                global double2* transform)
{
    const uint k = get_global_id(0);
    if (k >= nulling.frequencies) return;
    double2 sum = 0;
    for (uint i = 0; i < nulling.points; ++i)
        sum += weights[i] * wave(circle, frequencies + DIMENSION * k, positions + DIMENSION * i);
    transform[k] = sum;
}

/// The movements of points: a work-item a point.
kernel void descend(struct Nulling nulling, global const double2* circle, global const int* positions,
                    global const double* weights, global const int* frequencies, global const double2* transform,
                    global double* displacements)
{
    const uint i = get_global_id(0);
    if (i >= nulling.points) return;
    double movement[DIMENSION];
    for (uint axis = 0; axis < DIMENSION; ++axis) movement[axis] = 0;
    for (uint k = 0; k < nulling.frequencies; ++k) {
        global const int* frequency = frequencies + DIMENSION * k;
        const double2 e = wave(circle, frequency, positions + DIMENSION * i);
        const double2 f = transform[k];
        const double slope = f.x * e.y - f.y * e.x; // imaginary part of conj(F) e
        double squared = 0;
        for (uint axis = 0; axis < DIMENSION; ++axis) squared += (double)frequency[axis] * (double)frequency[axis];
        const double part = slope / squared;
        for (uint axis = 0; axis < DIMENSION; ++axis) movement[axis] += frequency[axis] * part;
    }
    double squared = 0;
    for (uint axis = 0; axis < DIMENSION; ++axis) {
        movement[axis] *= -nulling.step * weights[i];
        squared += movement[axis] * movement[axis];
    }
    const double length = sqrt(squared);
    const double scale = length > nulling.longest ? nulling.longest / length : 1;
    for (uint axis = 0; axis < DIMENSION; ++axis) displacements[DIMENSION * i + axis] = movement[axis] * scale;
}
