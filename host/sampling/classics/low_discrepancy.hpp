// The samplers "sobol" and "halton": low discrepancy sequences, scrambled or as they are.
//
// Sobol', On the distribution of points in a cube and the approximate evaluation of integrals, 1967; Halton, On the
// efficiency of certain quasi-random sequences, 1960. Scrambled by random permutations of digits, one for each value of
// the digits before: Owen, Randomly permuted (t,m,s)-nets and (t,s)-sequences, 1995.
#pragma once

#include "host/sampling/sampler.hpp"

#include <cstdint>

namespace poissonlab {

SamplerSpec sobol_sampler();
SamplerSpec halton_sampler();

/// Coordinate `axis` (0 to 2) of point `index` of the Sobol sequence, in units of 2^-32. Direction numbers of Joe and
/// Kuo, Constructing Sobol sequences with better two-dimensional projections, 2008.
std::uint32_t sobol_coordinate(std::uint32_t index, int axis);

}
