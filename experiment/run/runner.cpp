#include "experiment/run/runner.hpp"

#include "analysis/tilings/tiled_sets.hpp"
#include "base/files/file_lock.hpp"
#include "base/geometry/torus_delaunay.hpp"
#include "base/programs/interrupt.hpp"
#include "experiment/measuring/zone_plate_analysis.hpp"
#include "experiment/run/result_folder.hpp"
#include "experiment/store/unit_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <set>
#include <sstream>

namespace poissonlab {
namespace {

/// One line for the log: "random: 10 realizations of 16384 points, relative radius 0.012 to 0.034".
std::string summary(const SeriesTask& task, const Series& result)
{
    const auto [fewest, most] =
        result.points_each.empty() ? std::ranges::minmax({result.points}) : std::ranges::minmax(result.points_each);
    std::string line = fmt::format("{}: {} realization{} of {}", task.label, result.realizations,
                                   result.realizations == 1 ? "" : "s", fewest);
    if (most != fewest) line += fmt::format(" to {}", most);
    line += most == 1 ? " point" : " points";
    if (!result.repeated.empty())
        line += fmt::format(", of {} asked for: the others are equal to these", task.realizations);
    if (const auto& radius = result.relative_radius) {
        const std::string smallest = fmt::format("{:.3f}", radius->min), largest = fmt::format("{:.3f}", radius->max);
        line += ", relative radius " + smallest + (smallest == largest ? "" : " to " + largest);
    }
    return line;
}

/// The file whose lock a process holds while it changes output folders.
std::filesystem::path publish_lock(const std::filesystem::path& units)
{
    std::error_code error;
    std::filesystem::create_directories(units, error); // the lock says what is wrong
    return units / publish_lock_name;
}

/// The runs at hand: what is to do, what is done, and what the user is told of it.
class Runs
{
public:
    Runs(std::span<const PlannedRun> runs, const RunSettings& settings, Crew& crew, Progress& progress)
        : runs_(runs), settings_(settings), crew_(crew), progress_(progress), store_(settings.units)
    {
        std::uint32_t number = 0;
        for (const PlannedRun& run : runs) {
            works_.emplace_back(run.experiment, number++, settings_.versions, store_, slot_);
            run.experiment.workplace->processes = crew.size();
            run.experiment.workplace->on_step = [&](const std::string& what) {
                stop_if_interrupted();
                progress_.step(what);
            };
        }
    }
    ~Runs()
    {
        for (const PlannedRun& run : runs_) run.experiment.workplace->on_step = {};
    }
    Runs(const Runs&) = delete;
    Runs& operator=(const Runs&) = delete;

    /// Everything that decides which units there are.
    std::string identity() const
    {
        std::string text;
        for (const RunWork& work : works_) text += work.identity();
        return text;
    }

    /// Does the shard's part of the jobs. Returns whether the others' parts are done as well; false in all processes if
    /// one has failed. What could not be made is thrown in the process that leads, when all else is done.
    bool work_on_share(const Shard& shard)
    {
        const bool split = independent_jobs() / 2 < shard.count;
        Schedule schedule;
        const bool is_planned = crew_.together([&] {
            std::uint32_t next = 0;
            if (crew_.leads())
                for (const RunWork& work : works_) work.add_share(schedule, shard, split, next);
        });
        if (!is_planned || !work(schedule)) return false;
        bool is_done = false;
        const bool is_known = crew_.together([&] {
            outcome().raise_failures();
            const auto all_done = [&](const RunWork& work) { return work.all_shares_are_done(split); };
            is_done = crew_.leads() && std::ranges::all_of(works_, all_done);
        });
        return is_known && crew_.from_leader(is_done ? "done" : "not done") == "done";
    }

    /// False in all processes but the one that leads where one has failed.
    bool work_on_everything()
    {
        Schedule schedule;
        const bool is_planned = crew_.together([&] {
            if (!crew_.leads()) return;
            RunWork::JobsBySets jobs_by_sets;
            std::uint32_t next = 0;
            for (const RunWork& work : works_) {
                const std::size_t before = schedule.size();
                work.add_jobs(schedule, first_split_job(), next, jobs_by_sets);
                jobs_left_.push_back(schedule.size() - before);
            }
            publish_in_order();
        });
        return is_planned && work(schedule);
    }

    RunsOutcome outcome() const
    {
        RunsOutcome outcome{.is_published = is_published_, .failed = failed_};
        for (const RunWork& work : works_) outcome.items += work.items();
        return outcome;
    }

private:
    std::uint32_t independent_jobs() const
    {
        std::uint32_t jobs = 0;
        for (const RunWork& work : works_) jobs += work.independent_jobs();
        return jobs;
    }

    /// Several processes take series as a whole while there are plenty, and share the last two for each of them, or all
    /// where there are few.
    std::uint32_t first_split_job() const
    {
        const std::uint32_t jobs = independent_jobs();
        const auto processes = static_cast<std::uint32_t>(crew_.size());
        if (processes == 1) return jobs;
        return jobs >= 4 * processes ? jobs - 2 * processes : 0;
    }

    bool work(Schedule& schedule)
    {
        start_progress();
        const bool went_well = crew_.work(
            schedule,
            [&](const Job& job) {
                announce(job.run);
                // Exhibits need the device memory that the last series' sampler holds.
                if (job.kind == Job::Kind::exhibit) slot_.clear();
                works_.at(job.run).execute(job, listener());
            },
            [&](const Job& job, bool here) { note_done(job, here); },
            [&](const Job& job, const Failure& failure, std::size_t given_up) { note_failed(job, failure, given_up); });
        slot_.clear();
        return went_well;
    }

    /// Says, once, that a run has begun.
    void announce(std::uint32_t run)
    {
        if (!settings_.announces_runs || !announced_.insert(run).second) return;
        progress_.start_run(run + 1, runs_.size(), runs_[run].experiment.title);
    }

    void start_progress()
    {
        if (!crew_.leads()) return;
        WorkTotals totals;
        for (const RunWork& work : works_) {
            totals.realizations += work.realizations();
            totals.to_make += work.realizations_to_make();
            totals.to_analyse += work.realizations_to_analyse();
        }
        progress_.start(totals);
    }

    /// Listens to this process's work as it goes on; work of other processes is reported when a job is done.
    WorkListener listener()
    {
        return {[&](std::size_t points, double seconds) { progress_.sampled(points, seconds); },
                [&] { progress_.analysed(); }};
    }

    void note_done(const Job& job, bool here)
    {
        const RunWork& work = works_.at(job.run);
        if (!here) progress_.elsewhere(work.realizations_made_by(job), work.realizations_analysed_by(job));
        if (job.kind == Job::Kind::series) {
            const SeriesWork& series = work.series(job.item);
            const Series result = series.result();
            const int dimension = runs_[job.run].experiment.dimension;
            progress_.finish_series(summary(series.task(), result));
            if (const std::string border = border_words(result); !border.empty())
                progress_.note(fmt::format("{}: {} {}", series.task().label, border, border_advice(dimension)));
            if (const std::string left_out = short_spectrum_words(result, dimension); !left_out.empty())
                progress_.note(fmt::format("{}: {}", series.task().label, left_out));
            const bool is_read = series.task().sampler->name == "file";
            if (const auto verdict = blue_noise_verdict(result, dimension); is_read && verdict)
                progress_.message(fmt::format("{}: {}", series.task().label, verdict->words()));
            if (const std::string mixture = mixture_words(result); is_read && !mixture.empty())
                progress_.note(fmt::format("{}: {}", series.task().label, mixture));
        }
        if (jobs_left_.empty()) return; // a share
        --jobs_left_.at(job.run);
        publish_in_order();
    }

    /// Several jobs of an item may fail, in several processes; the first says why.
    void note_failed(const Job& job, const Failure& failure, std::size_t given_up)
    {
        const bool is_exhibit = job.kind == Job::Kind::exhibit;
        const auto is_same = [&](const FailedItem& each) {
            return each.run == job.run && each.is_exhibit == is_exhibit && each.item == job.item;
        };
        if (std::ranges::none_of(failed_, is_same)) {
            failed_.push_back({job.run, is_exhibit, job.item, works_.at(job.run).label(job), failure});
            if (outcome().items > 1) progress_.message(failed_.back().label + ": failed: " + failure.message);
        }
        if (jobs_left_.empty()) return; // a share
        jobs_left_.at(job.run) -= 1 + given_up;
        publish_in_order();
    }

    /// Publishes the runs whose jobs are all done, but none before those that come first, and none of which nothing
    /// could be made.
    void publish_in_order()
    {
        for (; published_ < jobs_left_.size() && jobs_left_[published_] == 0; ++published_) {
            stop_if_interrupted();
            announce(static_cast<std::uint32_t>(published_));
            const PlannedRun& run = runs_[published_];
            RunWork& work = works_[published_];
            const auto missing = std::ranges::count(failed_, static_cast<std::uint32_t>(published_), &FailedItem::run);
            if (static_cast<std::size_t>(missing) == work.items() && missing > 0) continue;
            const FileLock lock(publish_lock(settings_.units));
            work.publish(run.out, crew_.size(), failed_);
            is_published_ = true;
            if (settings_.on_published) settings_.on_published(run);
        }
    }

    std::span<const PlannedRun> runs_;
    const RunSettings& settings_;
    Crew& crew_;
    Progress& progress_;
    UnitStore store_;
    SamplerSlot slot_;
    std::deque<RunWork> works_;
    std::vector<std::size_t> jobs_left_; ///< of each run; empty while a shard does its share
    std::size_t published_ = 0;          ///< runs
    bool is_published_ = false;          ///< a run
    std::vector<FailedItem> failed_;     ///< in the process that leads
    std::set<std::uint32_t> announced_;  ///< runs
};

/// Results must not take the place of other things. Those of a run that is publishing just now are not looked at.
void check_folders(std::span<const PlannedRun> runs, const RunSettings& settings)
{
    std::optional<FileLock> lock;
    std::error_code error;
    if (std::filesystem::exists(settings.units, error)) lock.emplace(publish_lock(settings.units));
    for (const PlannedRun& run : runs) ResultFolder::check(run.out, folder_names(run.experiment));
}

/// True if all processes make the same units: one with another device or program would not find the units of the
/// others. If they do not, throws InputError in the process that leads.
bool are_alike(Crew& crew, const std::string& own)
{
    if (crew.size() == 1) return true;
    const std::string wanted = crew.from_leader(own);
    return crew.together([&] {
        if (own == wanted) return;
        std::istringstream here(own);
        std::istringstream there(wanted);
        std::string line;
        std::string other;
        do {
            std::getline(there, other);
        } while (std::getline(here, line) && line == other && there);
        throw InputError(fmt::format("this process would not do the same work as the first one: \"{}\" is not \"{}\"; "
                                     "devices, programs, files and the build of poissonlab must be the same",
                                     shortened(line, 200), shortened(other, 200)));
    });
}

}

std::vector<std::string> folder_names(const Experiment& experiment)
{
    std::vector<std::string> names;
    for (const SeriesTask& task : experiment.series) names.push_back(task.name);
    for (const Exhibit& exhibit : experiment.exhibits) names.push_back(exhibit.name);
    return names;
}

void RunsOutcome::raise_failures() const
{
    if (failed.empty()) return;
    Failure first = failed.front().failure;
    if (items > 1) {
        std::string labels;
        for (const FailedItem& each : failed) labels += (labels.empty() ? "" : ", ") + each.label;
        first.message += fmt::format("; {} of {} could not be made: {}", failed.size(), items, labels);
    }
    first.raise();
}

RunsOutcome run_experiments(std::span<const PlannedRun> runs, const RunSettings& settings, Crew& crew,
                            Progress& progress)
{
    for (const auto& [experiment, out] : runs) {
        if (experiment.dimension == 3 && !experiment.series.empty()) need_triangulations_3d();
        if (experiment.analysis.tiles > 0) need_tile_measures();
        if (experiment.analysis.zone_plate) need_zone_plate();
    }
    std::optional<Runs> work;
    const bool is_there = crew.together([&] {
        if (crew.leads()) check_folders(runs, settings);
        work.emplace(runs, settings, crew, progress);
    });
    if (!is_there || !are_alike(crew, work->identity())) return {};
    if (settings.shard && !work->work_on_share(*settings.shard)) return {};
    const bool is_done = work->work_on_everything();
    RunsOutcome outcome = work->outcome();
    outcome.is_complete = is_done && crew.leads();
    return outcome;
}

void run_experiment(const Experiment& experiment, const std::filesystem::path& out, Progress& progress)
{
    RunSettings settings;
    settings.units = out / unit_folder_name;
    const auto crew = make_crew_of_one();
    const std::vector<PlannedRun> runs = {{experiment, out}};
    run_experiments(runs, settings, *crew, progress).raise_failures();
}

}
