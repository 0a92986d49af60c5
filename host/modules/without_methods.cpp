// This function stands in for the order of sample elimination where a program lacks it: a set in progressive order asks
// for the module.
#include "base/errors/missing_module.hpp"
#include "host/sampling/optimized/ordered_sampler.hpp"

namespace poissonlab {

SamplerSpec in_progressive_order(SamplerSpec /*method*/) { throw MissingModule("methods"); }

}
