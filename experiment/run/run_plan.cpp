#include "experiment/run/run_plan.hpp"

#include "base/files/whole_file.hpp"
#include "base/programs/shell_words.hpp"
#include "experiment/config/collection.hpp"
#include "experiment/run/make_experiment.hpp"
#include "experiment/run/result_folder.hpp"
#include "results/file_names.hpp"
#include "results/own_files.hpp"

#include <fmt/format.h>

#include <charconv>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

/// The command that would run this config alone, with the settings that the collection hands on to it.
std::string command_of(const CollectedConfig& collected, const std::string& device, const RunOptions& options)
{
    std::string command = "poissonlab run " + shell_word(collected.config.file);
    if (!device.empty() && device != collected.config.device) command += " --device " + shell_word(device);
    for (const std::string& change : options.overrides) command += " --set " + shell_word(change);
    if (options.threads > 0) command += fmt::format(" --threads {}", options.threads);
    return command;
}

std::vector<PlannedRun> plan_collection(const Collection& collection, const RunOptions& options, const fs::path& out,
                                        unsigned threads)
{
    std::vector<PlannedRun> runs;
    for (const CollectedConfig& collected : collection.configs) {
        const std::string& device = options.device.empty() ? collected.device : options.device;
        PlannedRun run{make_experiment(collected.config, device, threads), out / collected.name};
        run.experiment.command = command_of(collected, device, options);
        ResultFolder::check(run.out, folder_names(run.experiment));
        runs.push_back(std::move(run));
    }
    return runs;
}

/// Throws InputError where `out` is not for collections.
void check_collection_folder(const fs::path& out)
{
    check_output_folder(out);
    std::error_code error;
    if (fs::exists(out / file_names::results, error))
        throw InputError("--out " + out.string() +
                         ": has the results of a single run; a collection needs a folder of its own");
    check_own_files(out);
}

}

RunPlan plan_run(const RunOptions& options, int threads)
{
    RunPlan plan;
    plan.out = options.out.empty() ? "out" / fs::path(options.config).stem() : options.out;
    const auto restricted = static_cast<unsigned>(threads);
    if (is_no_lasting_file(options.config)) // every process of a run reads it
        throw InputError::at({options.config}, "is a pipe or a device; a config file (.toml) is needed");
    ParsedConfig parsed = parse_file(options.config);
    if (is_collection(parsed)) {
        const Collection collection = read_collection(parsed, options.overrides);
        check_collection_folder(plan.out);
        plan.is_collection = true;
        plan.title = collection.title;
        plan.runs = plan_collection(collection, options, plan.out, restricted);
        return plan;
    }
    const Config config = checked_config(std::move(parsed), options.overrides);
    const std::string& device = options.device.empty() ? config.device : options.device;
    plan.runs.push_back({make_experiment(config, device, restricted), plan.out});
    plan.runs.front().experiment.command = options.command;
    ResultFolder::check(plan.out, folder_names(plan.runs.front().experiment));
    return plan;
}

std::optional<Shard> parse_shard(const std::string& command, const std::string& text)
{
    if (text.empty()) return std::nullopt;
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto number = std::from_chars(text.data(), end, shard.number);
    const bool has_count = number.ec == std::errc{} && number.ptr != end && *number.ptr == '/';
    const auto count = has_count ? std::from_chars(number.ptr + 1, end, shard.count) : number;
    if (!has_count || count.ec != std::errc{} || count.ptr != end || shard.number < 1 || shard.number > shard.count)
        throw InputError(command + ": --shard " + text + ": must be i/n, with i from 1 to n");
    return shard;
}

}
