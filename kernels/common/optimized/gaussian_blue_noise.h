// The contract of gaussian_blue_noise.cl, its host code, host/sampling/optimized/gaussian_blue_noise.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"
#include "kernels/common/grid_part.h"

CONTRACT(gaussian_blue_noise)

enum
{
    BLOCK_POINTS = 8, ///< points that a work-item owns
    FIELD_CELLS = 8   ///< cells of a density along each axis in a listed cell of the grid of points
};

/// Pairs farther apart than so many sigma are left out, where Gaussians are below 2 to the power of CUT_EXPONENT.
REAL(CUT_OFF, 5.8)
REAL(CUT_EXPONENT, -0.5 * CUT_OFF * CUT_OFF * 1.4426950408889634)

/// The arguments of sum_gaussians. Lengths are in units of 2^-32 of the torus' side.
struct Gaussians
{
    double step;    ///< displacement for a unit of force; of the torus' side
    float exponent; ///< the Gaussian is 2^(exponent * squared distance)
    float near;     ///< in no set are all points farther apart from each other than so many cells
    uint first, end; ///< of the sorted points, those that are asked about
    uint stride;     ///< of coordinates
    uint unused;
};

/// The width and the pull that a density gives a place: see host/sampling/optimized/gaussian_field.hpp.
struct DensityCell
{
    float x, y;     ///< displacement of a point that is there; of the torus' side
    float excess;   ///< energy of the density there beyond that of a density that is the same everywhere
    float exponent; ///< as in Gaussians, which are as wide as there are few points
    int is_empty;   ///< 1 where the density is 0, which no point enters
};

END_CONTRACT
