// All the work of one experiment: its jobs, and its results once they are done.
#pragma once

#include "base/crew/failure.hpp"
#include "base/crew/schedule.hpp"
#include "experiment/series/exhibit_units.hpp"
#include "experiment/series/experiment.hpp"
#include "experiment/series/series_work.hpp"
#include "results/run.hpp"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// One of several processes that know nothing of each other, each with a fixed share of the jobs.
struct Shard
{
    std::uint32_t number = 1; ///< from 1
    std::uint32_t count = 1;
};

/// A series or an exhibit of a run that could not be made.
struct FailedItem
{
    std::uint32_t run = 0;
    bool is_exhibit = false;
    std::uint32_t item = 0;
    std::string label;
    Failure failure;
};

class RunWork
{
public:
    /// The arguments must outlive it. `number` is that of the run among the runs at hand.
    RunWork(const Experiment& experiment, std::uint32_t number, const CodeVersions& versions, UnitStore& store,
            SamplerSlot& slot);

    /// Everything that decides which units there are, in lines.
    std::string identity() const;

    /// Jobs that make series of the same point sets, of all runs: they wait for each other instead of making them
    /// twice.
    using JobsBySets = std::map<std::string, Schedule::Id>;

    /// Adds a job for everything that is not done. `next` counts the independent_jobs() of all runs. From number
    /// `split_from` on, sampling and analysis of a series are jobs of their own, of some realizations each: small jobs
    /// that keep all processes busy to the end, at the price of reading points again for their analysis.
    void add_jobs(Schedule& schedule, std::uint32_t split_from, std::uint32_t& next, JobsBySets& jobs_by_sets) const;

    /// Adds those jobs that do not need the results of others and fall to a shard; `next` counts the jobs of all runs.
    void add_share(Schedule& schedule, const Shard& shard, bool split, std::uint32_t& next) const;

    /// Jobs that can be dealt out without splitting parts.
    std::uint32_t independent_jobs() const;

    /// True if all jobs of all shards are done, on whatever machines.
    bool all_shares_are_done(bool split) const;

    /// Throws what samplers throw, InputError, StorageError, and std::runtime_error where memory is lacking.
    void execute(const Job& job, const WorkListener& listener);

    /// Realizations that are not made, and not analysed, yet.
    std::uint64_t realizations_to_make() const;
    std::uint64_t realizations_to_analyse() const;
    std::uint64_t realizations() const;

    /// About how many realizations a job has made, and analysed.
    std::uint64_t realizations_made_by(const Job& job) const;
    std::uint64_t realizations_analysed_by(const Job& job) const;

    /// Moves the results to the output folder, and removes from the store what they make superfluous. Everything but
    /// what has failed must be done. Throws InputError and StorageError.
    void publish(const std::filesystem::path& out, int processes, std::span<const FailedItem> failed);

    /// The label of the series or exhibit that a job belongs to.
    std::string label(const Job& job) const;

    /// Series and exhibits.
    std::size_t items() const { return series_.size() + experiment_.exhibits.size(); }

    const SeriesWork& series(std::uint32_t item) const { return series_[item]; }

private:
    using Ids = std::vector<Schedule::Id>;
    Ids add_samples(Schedule& schedule, std::uint32_t item, const RealizationRange& range, const Ids& after) const;
    Schedule::Id add_series(Schedule& schedule, std::uint32_t item, bool split, const Ids& after) const;
    void execute_in_memory(const Job& job, const WorkListener& listener);
    Job job(Job::Kind kind, std::uint32_t item, const RealizationRange& range = {}) const;

    const Experiment& experiment_;
    std::uint32_t number_;
    std::deque<SeriesWork> series_;
    ExhibitUnits exhibits_;
};

// The results of an experiment as the Run that results/ stores.

/// The results of the tasks of an experiment, one item for each; std::nullopt where it has failed.
struct ExperimentResults
{
    std::vector<std::optional<Series>> series;      ///< as SeriesWork::result() has them
    std::vector<std::optional<Exhibited>> exhibits; ///< files without the folder
    std::vector<std::string> failures;              ///< a sentence each
    Machine machine;
};

/// The run of an experiment with its results: names, parameters and files of each task.
Run make_run(const Experiment& experiment, const ExperimentResults& results);

}
