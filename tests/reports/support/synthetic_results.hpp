// A small result folder, as the experiment would write it, with every number known.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>

namespace poissonlab::test {

/// Writes three series of 256 points and spectra of 64 x 64 into `folder`: "random" and "jittered" (two
/// realizations, estimates) and "regular" (deterministic, a periodogram). Titles and labels hold <, > and &.
/// Returns what results.json holds.
nlohmann::json write_synthetic_results(const std::filesystem::path& folder);

/// Replaces results.json.
void write_results_json(const std::filesystem::path& folder, const nlohmann::json& results);

}
