// The plan of a `poissonlab run`: its runs, or those of a collection.
#pragma once

#include "experiment/run/runner.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

struct RunOptions
{
    std::string config;
    std::filesystem::path out; ///< empty: out/<config's stem>
    std::string device;
    std::vector<std::string> overrides;
    int threads = 0;   ///< 0: all
    std::string shard; ///< "i/n"; empty: everything
    bool quiet = false;
    bool json = false;
    std::string command; ///< as it would be typed, without what does not change results
};

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

/// The value of the option --shard of a command, "i/n"; none for an empty text. Throws InputError.
std::optional<Shard> parse_shard(const std::string& command, const std::string& text);

}
