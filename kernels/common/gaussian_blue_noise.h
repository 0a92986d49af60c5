// The contract of gaussian_blue_noise.cl, its host code, host/sampling/optimized/gaussian_blue_noise.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(gaussian_blue_noise)

enum
{
    WINDOW_REACH = 2, ///< cells on either side of a point's own
    SUM_LANES = 8     ///< sums that are kept apart until all neighbours are added
};

/// The arguments of sum_gaussians. Lengths are in mean distances of points, N^(-1/dimension).
struct Gaussians
{
    double step;       ///< displacement for a unit of force; of the torus' side
    float scale;       ///< a unit of 2^-32
    float exponent;    ///< the Gaussian is 2^(exponent * squared distance)
    float squared_cut; ///< farther pairs are left out
    uint points;
    uint grid_size; ///< cells along each axis: 1, or at least 2 WINDOW_REACH + 1
    uint stride;    ///< of coordinates
};

/// The width and the pull that a density gives a place: see host/sampling/optimized/gaussian_field.hpp.
struct DensityCell
{
    float x, y;        ///< displacement of a point that is there; of the torus' side
    float excess;      ///< energy of the density there beyond that of a density that is the same everywhere
    float exponent;    ///< as in Gaussians, which are as wide as there are few points
    float squared_cut; ///< as in Gaussians
    int reach;         ///< cells of the grid on either side of a point's own, half of all at most; ~reach where the
                       ///< density is 0, which no point enters
};

END_CONTRACT
