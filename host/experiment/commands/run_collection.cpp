// poissonlab run of a collection: every config in a folder of its own, and one report over all.
#include "experiment/commands/commands.hpp"
#include "experiment/config_run.hpp"
#include "experiment/result_folder.hpp"
#include "experiment/runner.hpp"
#include "io/collection_file.hpp"
#include "io/shell_words.hpp"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

/// One config, ready to run.
struct CollectedRun
{
    std::string name;
    Experiment experiment;
};

/// What would run this config alone, with what the collection hands on to it.
std::string command_of(const CollectedConfig& collected, const std::string& device, const RunOptions& options)
{
    std::string command = "poissonlab run " + shell_word(collected.config.file);
    if (!device.empty() && device != collected.config.device) command += " --device " + shell_word(device);
    for (const std::string& change : options.overrides) command += " --set " + shell_word(change);
    if (options.threads > 0) command += fmt::format(" --threads {}", options.threads);
    return command;
}

/// Plans every experiment and checks every folder, before the first one runs.
std::vector<CollectedRun> plan_runs(const Collection& collection, const RunOptions& options, const fs::path& out)
{
    std::vector<CollectedRun> runs;
    for (const CollectedConfig& collected : collection.configs) {
        const std::string& device = options.device.empty() ? collected.device : options.device;
        CollectedRun run{collected.name,
                         make_experiment(collected.config, device, static_cast<unsigned>(options.threads))};
        run.experiment.command = command_of(collected, device, options);
        ResultFolder::check(out / run.name, folder_names(run.experiment));
        runs.push_back(std::move(run));
    }
    return runs;
}

/// Throws InputError where `out` is not for collections.
void check_folder(const fs::path& out)
{
    std::error_code error;
    if (fs::exists(out, error) && !fs::is_directory(out, error))
        throw InputError("--out " + out.string() + ": is a file; a folder is needed");
    if (fs::exists(out / "results.json", error))
        throw InputError("--out " + out.string() +
                         ": has the results of a single run; a collection needs a folder of its own");
}

}

void run_collection(const Collection& collection, const RunOptions& options, const ReportWriter& write_report)
{
    const fs::path out = options.out.empty() ? "out" / fs::path(options.config).stem() : options.out;
    check_folder(out);
    const std::vector<CollectedRun> runs = plan_runs(collection, options, out);
    Progress progress(Progress::detect(options.quiet));
    CollectionFile done{collection.title, options.command, {}};
    for (const CollectedRun& run : runs) {
        progress.start_run(done.runs.size() + 1, runs.size(), run.experiment.title);
        run_experiment(run.experiment, out / run.name, progress);
        // The folder always says what is done, so that a run that fails keeps it, and a report can be made of it. An
        // earlier report would show what is no longer there.
        done.runs.push_back(run.name);
        std::error_code error;
        fs::remove(out / "index.html", error);
        write_collection_file(out, done);
    }
    progress.finish_runs();
    finish_report({out}, out, write_report, progress);
}

}
