// The sampler "dodecagonal": a sequence on the vertices of a dodecagonal tiling, of any density.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

SamplerSpec dodecagonal_sampler();

}
