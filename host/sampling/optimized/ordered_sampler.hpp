// The parameter `order`, which goes with every method: its sets in an order whose first parts are well spread.
//
// Points stay where they are; sample elimination (Yuksel 2015, section 4) says which of them come first.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// The description of a method with its sets in progressive order; all else is as the method has it. Its sampler throws
/// InputError for windows of the plane, since distances are those of the torus.
SamplerSpec in_progressive_order(SamplerSpec method);

}
