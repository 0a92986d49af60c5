// The samplers "hat-tiles" and "spectre-tiles" in regions: each set is what a region cuts out of the tiling elsewhere.
#pragma once

#include "host/sampling/sampler.hpp"

#include <string>

namespace poissonlab {

/// Returns the sampler in regions of a tiling, "hat" or "spectre", from that of windows.
SamplerSpec region_monotile_sampler(const std::string& tiling, SamplerSpec in_windows);

}
