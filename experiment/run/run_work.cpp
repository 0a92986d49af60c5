#include "experiment/run/run_work.hpp"

#include "experiment/run/result_folder.hpp"
#include "experiment/run/runner.hpp"

#include <algorithm>
#include <new>
#include <stdexcept>

namespace poissonlab {
namespace {

/// Points that are made by one job: some hundredths of a second at least, so that dealing out jobs costs little.
constexpr std::size_t points_per_job = 65'536;

std::uint32_t realizations_per_job(std::size_t points)
{
    const std::size_t count = points_per_job / std::max<std::size_t>(points, 1);
    return static_cast<std::uint32_t>(std::clamp<std::size_t>(count, 1, realizations_per_part));
}

std::uint64_t missing_realizations(const SeriesWork& series)
{
    std::uint64_t count = 0;
    for (std::uint32_t k = 0; k < series.task().realizations; ++k) count += !series.is_sampled(k);
    return count;
}

/// Somebody may remove what was there a moment ago.
template <class T>
T there(std::optional<T> stored, const std::string& label)
{
    if (!stored) throw StorageError(label + " is gone from the stored units; the same command makes it again");
    return *std::move(stored);
}

}

RunWork::RunWork(const Experiment& experiment, std::uint32_t number, const CodeVersions& versions, UnitStore& store,
                 SamplerSlot& slot)
    : experiment_(experiment), number_(number), exhibits_(experiment, versions, store)
{
    for (const SeriesTask& task : experiment.series) series_.emplace_back(experiment, task, versions, store, slot);
}

std::string RunWork::identity() const
{
    std::string text;
    for (const SeriesWork& series : series_) text += series.units().analysis_key().text();
    return text + exhibits_.identity();
}

Job RunWork::job(Job::Kind kind, std::uint32_t item, const RealizationRange& range) const
{
    return {kind, number_, item, range.first, range.count};
}

/// Jobs that make the missing realizations of a range.
RunWork::Ids RunWork::add_samples(Schedule& schedule, std::uint32_t item, const RealizationRange& range,
                                  const Ids& after) const
{
    const SeriesWork& series = series_[item];
    const std::uint32_t step = realizations_per_job(series.task().request.points);
    const std::uint32_t end = range.first + range.count;
    Ids ids;
    for (std::uint32_t k = range.first; k < end; k += step) {
        const RealizationRange chunk{k, std::min(step, end - k)};
        bool is_there = true;
        for (std::uint32_t i = 0; i < chunk.count; ++i) is_there = is_there && series.is_sampled(k + i);
        if (!is_there) ids.push_back(schedule.add(job(Job::Kind::sample, item, chunk), after));
    }
    return ids;
}

/// All jobs of a series, which begin after others; the last one.
Schedule::Id RunWork::add_series(Schedule& schedule, std::uint32_t item, bool split, const Ids& after) const
{
    const SeriesWork& series = series_[item];
    const SeriesUnits& units = series.units();
    // Without points in the store, who made a realization must analyse it as well.
    split = split && series.keeps_points();
    Ids last = after;
    Ids first_chunk = after; // its size counts for all
    if (!split && units.parts() > 1 && !series.is_sampled(0))
        first_chunk = {schedule.add(job(Job::Kind::sample, item, {0, 1}), after)};
    for (std::uint32_t part = 0; part < units.parts(); ++part) {
        if (series.is_analysed(part)) continue;
        Ids samples = after;
        if (split) {
            const Ids made = add_samples(schedule, item, units.part(part), after);
            samples.insert(samples.end(), made.begin(), made.end());
            if (part == 0 && !made.empty()) first_chunk = {made.front()};
        }
        samples.insert(samples.end(), first_chunk.begin(), first_chunk.end());
        // The only part of a series is analysed when the series is finished.
        if (units.parts() == 1) {
            last.insert(last.end(), samples.begin(), samples.end());
        } else {
            const std::uint32_t made = split ? 0 : units.part(part).count;
            last.push_back(schedule.add(job(Job::Kind::part, item, {part, made}), samples));
        }
    }
    const auto made = static_cast<std::uint32_t>(split || units.parts() > 1 ? 0 : missing_realizations(series));
    return schedule.add(job(Job::Kind::series, item, {0, made}), last);
}

void RunWork::add_jobs(Schedule& schedule, std::uint32_t split_from, std::uint32_t& next,
                       JobsBySets& jobs_by_sets) const
{
    for (std::uint32_t item = 0; item < series_.size(); ++item) {
        const bool split = next >= split_from;
        next += series_[item].units().parts();
        if (series_[item].is_finished()) continue;
        const std::string& sets = series_[item].units().identity().text();
        Ids after;
        if (const auto other = jobs_by_sets.find(sets); other != jobs_by_sets.end()) after.push_back(other->second);
        jobs_by_sets[sets] = add_series(schedule, item, split, after);
    }
    for (std::uint32_t item = 0; item < experiment_.exhibits.size(); ++item, ++next)
        if (!exhibits_.find(item)) schedule.add(job(Job::Kind::exhibit, item));
}

std::uint32_t RunWork::independent_jobs() const
{
    auto jobs = static_cast<std::uint32_t>(experiment_.exhibits.size());
    for (const SeriesWork& series : series_) jobs += series.units().parts();
    return jobs;
}

void RunWork::add_share(Schedule& schedule, const Shard& shard, bool split, std::uint32_t& next) const
{
    const auto is_mine = [&] { return next++ % shard.count == shard.number - 1; };
    for (std::uint32_t item = 0; item < series_.size(); ++item) {
        const SeriesWork& series = series_[item];
        const SeriesUnits& units = series.units();
        if (split) {
            for (std::uint32_t k = 0; k < series.task().realizations; ++k)
                if (is_mine() && !series.is_sampled(k)) schedule.add(job(Job::Kind::sample, item, {k, 1}));
        } else if (units.parts() == 1) {
            if (is_mine() && !series.is_finished()) schedule.add(job(Job::Kind::series, item));
        } else {
            for (std::uint32_t part = 0; part < units.parts(); ++part)
                if (is_mine() && !series.is_analysed(part))
                    schedule.add(job(Job::Kind::part, item, {part, units.part(part).count}));
        }
    }
    for (std::uint32_t item = 0; item < experiment_.exhibits.size(); ++item)
        if (is_mine() && !exhibits_.find(item)) schedule.add(job(Job::Kind::exhibit, item));
}

bool RunWork::all_shares_are_done(bool split) const
{
    for (const SeriesWork& series : series_) {
        const bool whole = !split && series.units().parts() == 1;
        if (whole && !series.has_results()) return false;
        for (std::uint32_t k = 0; split && k < series.task().realizations; ++k)
            if (!series.is_sampled(k)) return false;
        for (std::uint32_t part = 0; !split && !whole && part < series.units().parts(); ++part)
            if (!series.is_analysed(part)) return false;
    }
    for (std::uint32_t item = 0; item < experiment_.exhibits.size(); ++item)
        if (!exhibits_.find(item)) return false;
    return true;
}

std::string RunWork::label(const Job& job) const
{
    return job.kind == Job::Kind::exhibit ? experiment_.exhibits.at(job.item).label : series_.at(job.item).task().label;
}

void RunWork::execute(const Job& job, const WorkListener& listener)
{
    try {
        execute_in_memory(job, listener);
    } catch (const std::bad_alloc&) {
        throw std::runtime_error(label(job) + ": there is not enough memory for this");
    }
}

void RunWork::execute_in_memory(const Job& job, const WorkListener& listener)
{
    switch (job.kind) {
    case Job::Kind::series:
        return series_.at(job.item).finish(listener);
    case Job::Kind::part:
        return series_.at(job.item).analyse(job.first, listener);
    case Job::Kind::sample:
        return series_.at(job.item).sample({job.first, job.count}, listener);
    case Job::Kind::exhibit:
        return exhibits_.make(job.item);
    case Job::Kind::points:
        throw std::logic_error("pieces of windows are no work of runs");
    }
}

std::uint64_t RunWork::realizations() const
{
    std::uint64_t count = 0;
    for (const SeriesTask& task : experiment_.series) count += task.realizations;
    return count;
}

std::uint64_t RunWork::realizations_to_make() const
{
    std::uint64_t count = 0;
    for (const SeriesWork& series : series_) count += missing_realizations(series);
    return count;
}

std::uint64_t RunWork::realizations_to_analyse() const
{
    std::uint64_t count = 0;
    for (const SeriesWork& series : series_)
        for (std::uint32_t part = 0; part < series.units().parts(); ++part)
            if (!series.is_analysed(part)) count += series.units().part(part).count;
    return count;
}

std::uint64_t RunWork::realizations_made_by(const Job& job) const { return job.count; }

std::uint64_t RunWork::realizations_analysed_by(const Job& job) const
{
    if (job.kind == Job::Kind::part) return series_.at(job.item).units().part(job.first).count;
    const bool has_one_part = job.kind == Job::Kind::series && series_.at(job.item).units().parts() == 1;
    return has_one_part ? series_.at(job.item).task().realizations : 0;
}

void RunWork::publish(const std::filesystem::path& out, int processes, std::span<const FailedItem> failed)
{
    const auto is_missing = [&](bool is_exhibit, std::uint32_t item) {
        return std::ranges::any_of(failed, [&](const FailedItem& each) {
            return each.run == number_ && each.is_exhibit == is_exhibit && each.item == item;
        });
    };
    std::vector<std::string> names;
    for (std::uint32_t item = 0; item < series_.size(); ++item)
        if (!is_missing(false, item)) names.push_back(series_[item].task().name);
    for (std::uint32_t item = 0; item < experiment_.exhibits.size(); ++item)
        if (!is_missing(true, item)) names.push_back(experiment_.exhibits[item].name);
    ResultFolder folder(out, names);
    bool used_device = false;
    ExperimentResults results;
    results.series.resize(series_.size());
    results.exhibits.resize(experiment_.exhibits.size());
    for (std::uint32_t item = 0; item < series_.size(); ++item) {
        if (is_missing(false, item)) continue;
        SeriesWork& series = series_[item];
        series.time_more(); // machines that took part may have other devices or threads
        folder.add(series.task().name, series.files());
        results.series[item] = series.result();
        used_device = used_device || series.used_device();
    }
    for (std::uint32_t item = 0; item < experiment_.exhibits.size(); ++item) {
        if (is_missing(true, item)) continue;
        const Exhibit& exhibit = experiment_.exhibits[item];
        ExhibitUnit stored = there(exhibits_.find(item), exhibit.label);
        folder.add(exhibit.name, stored.files);
        results.exhibits[item] = std::move(stored.result);
        used_device = used_device || stored.on_device;
    }
    for (const FailedItem& each : failed)
        if (each.run == number_) results.failures.push_back(each.label + ": failed: " + each.failure.message);
    const auto& machine_of = experiment_.workplace->machine;
    if (machine_of) results.machine = machine_of(used_device);
    if (processes > 1) results.machine.processes = processes;
    folder.publish(run_json(make_run(experiment_, results)));
    for (std::uint32_t item = 0; item < series_.size(); ++item)
        if (!is_missing(false, item)) series_[item].remove_parts();
}

}
