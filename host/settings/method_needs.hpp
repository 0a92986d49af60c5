// A method needs of a device what its kernels need.
#pragma once

#include "host/device/kernel_program.hpp"
#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// Returns the needs of a method's kernels for sets of a dimension.
KernelNeeds needs_in(const SamplerSpec& method, int dimension);

/// Returns these needs, and those of the methods among its parameters, which it starts from.
KernelNeeds needs_of(const SamplerSpec& method, const Parameters& parameters, int dimension);

/// The method, whose sampler asks a device for what its kernels need as soon as it gets one: the error names the
/// method, and nothing is built.
SamplerSpec asking_for_needs(SamplerSpec method);

}
