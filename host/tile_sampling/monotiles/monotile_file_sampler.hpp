// Windows of a file with hats or spectres as the sets of a series: the parameters "tiles" and "density" of the samplers
// of hats and spectres.
#pragma once

#include "host/sampling/sampler.hpp"
#include "tiles/monotiles/monotile_file.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

std::vector<ParameterSpec> monotile_file_parameters();

/// True if the sets are those of a file.
bool has_monotile_file(const Parameters& given);

/// Throws InputError, with the place, for a file that does not have points in this tiling ("hat", "spectre"), and for
/// parameters that do not go together, such as many points and a small density.
void check_monotile_file(const std::string& tiling, const Parameters& given, const SampleRequest& request);

/// Returns a hash of the file's bytes: SamplerSpec::outside_input.
std::uint64_t monotile_file_hash(const Parameters& given);

/// Reads the file, and proves its distances. Throws InputError, with the place, for a file that promises others.
struct ProvenMonotileFile
{
    MonotilePointsFile file;
    std::vector<SquaredLength> distances; ///< [k - 1]: of the points with numbers below k
};
ProvenMonotileFile proven_monotile_file(const Parameters& given, const SampleRequest& request);

/// Proves the distances of the file. Throws InputError, with the place, for a file that promises others.
std::unique_ptr<Sampler> monotile_file_sampler(const Parameters& given, const SampleRequest& request);

}
