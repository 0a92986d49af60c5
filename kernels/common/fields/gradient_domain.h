// The contract of gradient_domain.cl and its host code, host/texture/gradient_domain.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(gradient_domain)

struct GradientDomainSizes
{
    int size;          ///< pixels along a side of a tile
    int channels;      ///< of a pixel, each of which is a problem of its own
    int sweeps;        ///< over all pixels
    double relaxation; ///< factor of each step: 1 to 2
};

END_CONTRACT
