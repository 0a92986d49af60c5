// The parameters "density" and "density_from" of methods whose points follow a density: a picture or a formula.
#pragma once

#include "base/densities/density.hpp"
#include "host/sampling/sampler.hpp"

#include <optional>
#include <vector>

namespace poissonlab {

/// Describes these two parameters.
std::vector<ParameterSpec> density_parameters();

/// The density over the unit square that is given, or nothing: the same everywhere. Pictures are named relative to the
/// folder of the config. Throws InputError, with the place, for what is neither a picture nor a formula and for
/// pictures that are not square.
std::optional<Density> given_density(const Parameters& given);

/// A hash of the density: SamplerSpec::outside_input.
std::uint64_t density_hash(const Parameters& given);

}
