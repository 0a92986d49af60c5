// The samplers "best-candidate" and "bridson": Poisson disk like sets as most programs make them.
//
// Mitchell, Spectrally optimal sampling for distribution ray tracing, 1991; Bridson, Fast Poisson disk sampling in
// arbitrary dimensions, 2007. Both on the torus, and sequential by definition: realizations are what runs side by side.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// `best-candidate`: each point is the candidate that is farthest from all points so far.
SamplerSpec best_candidate_sampler();

/// `bridson`: darts around points that are there, until none of them finds room. Nearly saturated.
SamplerSpec bridson_sampler();

}
