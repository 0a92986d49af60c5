// All methods of making point sets that a config can name.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// In the order in which help and errors list them.
const SamplerRegistry& sampler_registry();

}
