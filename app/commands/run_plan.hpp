// What `poissonlab run` is going to do.
#pragma once

#include "app/commands/commands.hpp"
#include "host/run/runner.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

struct RunPlan
{
    std::filesystem::path out;
    bool is_collection = false;
    std::string title; ///< of a collection
    std::vector<PlannedRun> runs;
};

/// Plans every experiment and checks every folder, before the first one runs. `threads` restricts a CPU device where
/// the user, or the crew, restricts threads. Throws InputError and DeviceError.
RunPlan plan_run(const RunOptions& options, int threads);

}
