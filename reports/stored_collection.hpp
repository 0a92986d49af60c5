// A folder of results that may hold several runs: collection.json of docs/output-folder.md.
#pragma once

#include "reports/stored_results.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The run folders of a collection, in order, or `folder` itself where it is none. Throws InputError for a
/// collection.json that cannot be understood.
std::vector<std::filesystem::path> run_folders(const std::filesystem::path& folder);

/// All runs in `folder`. Throws InputError as read_stored_run() does.
std::vector<StoredRun> read_stored_runs(const std::filesystem::path& folder);

}
