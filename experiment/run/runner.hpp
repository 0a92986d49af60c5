// Runs experiments: makes the point sets, analyses them, stores every result.
#pragma once

#include "base/crew/crew.hpp"
#include "experiment/run/progress.hpp"
#include "experiment/run/run_work.hpp"
#include "experiment/series/code_versions.hpp"
#include "experiment/series/experiment.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// The file in the folder of finished work that is locked while output folders change.
inline constexpr const char* publish_lock_name = "publish.lock";

/// The folders below the output folder that an experiment fills.
std::vector<std::string> folder_names(const Experiment& experiment);

/// An experiment and the folder for its results.
struct PlannedRun
{
    Experiment experiment;
    std::filesystem::path out;
};

/// Settings of how runs are carried out. None of them changes results.
struct RunSettings
{
    std::filesystem::path units; ///< folder of finished work, shared by all runs
    std::optional<Shard> shard;  ///< only a share of the work
    CodeVersions versions = CodeVersions::current();
    bool announces_runs = false;                         ///< whether the user is told which run is being made
    std::function<void(const PlannedRun&)> on_published; ///< in the order of the runs
};

/// The outcome of runs: where their results are, and which series have failed.
struct RunsOutcome
{
    bool is_complete = false;       ///< all results are in place, but for what has failed
    bool is_published = false;      ///< of some run at least
    std::vector<FailedItem> failed; ///< in the order of their failures
    std::size_t items = 0;          ///< series and exhibits of all runs

    /// Throws the first failure, with what else is missing. Returns where nothing has failed.
    void raise_failures() const;
};

/// Carries out runs and writes all of docs/output-folder.md but the report and its pictures to their folders.
///
/// Every unit of work is stored when it is done, and nothing that is stored is done again, so that a run that was
/// interrupted goes on where it was. Results appear in an output folder all at once; until then a previous result stays
/// as it is. Sampling and analysis of a process take turns: the times of sampling are results, and analysis would
/// disturb them. A series or exhibit that fails leaves the others as they are; a run of which nothing can be made
/// leaves its folder as it is. `is_complete` is false for a shard that is done while others are not, and in processes
/// of the crew that do not lead. Throws InputError and StorageError, and what samplers throw in the share of a shard.
[[nodiscard]] RunsOutcome run_experiments(std::span<const PlannedRun> runs, const RunSettings& settings, Crew& crew,
                                          Progress& progress);

/// One run of this process alone, with finished work in a folder within the output folder. Throws what
/// RunsOutcome::raise_failures() throws, when the others' results are in place.
void run_experiment(const Experiment& experiment, const std::filesystem::path& out, Progress& progress);

}
