#include "experiment/series/series_work.hpp"

#include "base/points/point_file.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/side_by_side.hpp"
#include "experiment/measuring/analysis_unit.hpp"
#include "results/file_names.hpp"
#include "results/records/archive.hpp"
#include "version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace poissonlab {
namespace {

/// "relative_radius = 0.75, repulsion = true": empty without parameters.
std::string parameters_text(const Parameters& parameters)
{
    std::vector<std::string> texts;
    for (const auto& [key, entry] : parameters.given()) texts.push_back(key + " = " + to_string(entry.value));
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// True for sets of other programs, which may not have known that they are taken as periodic.
bool is_foreign(const SeriesTask& task) { return task.sampler->name == "file" || task.sampler->name == "command"; }

/// Methods that tile know their lattice. A single tile leaves no peaks: every frequency is one of its lattice.
AnalysisOptions with_traits(const SeriesTask& task, const SetTraits& traits, AnalysisOptions options)
{
    options.is_foreign = is_foreign(task) && !options.is_periodic;
    if (options.tiles == 0 && traits.tiles_along_axis > 1) options.tiles = static_cast<int>(traits.tiles_along_axis);
    options.tile_sets = traits.tile_sets;
    options.window = options.window || traits.is_window;
    options.progressive = traits.is_progressive;
    return options;
}

}

SeriesWork::SeriesWork(const Experiment& experiment, const SeriesTask& task, const CodeVersions& versions,
                       UnitStore& store, SamplerSlot& slot)
    : experiment_(experiment), task_(task), store_(store), slot_(slot),
      units_(task, experiment.analysis_of(task), versions)
{}

// Comments of point files, and the origin in an image's header, name only what the points depend on: equal point sets
// of several experiments are stored once.

std::string SeriesWork::comment(std::uint32_t realization) const
{
    const std::string parameters = parameters_text(task_.parameters);
    const std::string seed = experiment_.seed ? fmt::format("seed {}, ", *experiment_.seed) : "";
    return fmt::format("{}{}{}; {}realization {}", task_.sampler->name, parameters.empty() ? "" : ": ", parameters,
                       seed, realization);
}

std::map<std::string, std::string> SeriesWork::image_metadata() const
{
    std::map<std::string, std::string> metadata = {{"sampler", task_.sampler->name},
                                                   {"version", POISSONLAB_VERSION_STRING}};
    const std::map<std::string, std::string> optional = {
        {"parameters", parameters_text(task_.parameters)},
        {"seed", experiment_.seed ? fmt::format("{}", *experiment_.seed) : ""},
        {"engine", experiment_.engine}};
    for (const auto& [key, text] : optional)
        if (!text.empty()) metadata[key] = text;
    return metadata;
}

/// Somebody has removed or damaged what this run had stored or found.
StorageError SeriesWork::missing_unit(const std::string& what) const
{
    return StorageError(
        fmt::format("{}: {} is gone or damaged; the same command makes it again", store_.folder().string(), what));
}

// Realizations.

/// True if the points of the realization are kept.
bool SeriesWork::has_points_to_keep(std::uint32_t realization) const
{
    return task_.strips.empty() && (realization == 0 || keeps_points());
}

bool SeriesWork::is_sampled(std::uint32_t realization) const
{
    const UnitKey key = units_.sample_key(realization);
    return has_points_to_keep(realization) ? stored_points(store_, key).has_value()
                                           : stored_sample(store_, key).has_value();
}

/// Makes the first realization of a range whose others will be asked for next.
Sample SeriesWork::make(const RealizationRange& range, const WorkListener& listener)
{
    stop_if_interrupted();
    Sample sample;
    if (task_.strips.empty())
        sample = slot_.make(task_, range, *experiment_.workplace);
    else
        sample.record.points = task_.strips.at(range.first)->size();
    sample.record.conditions = experiment_.workplace->conditions();
    if (sample.record.points == 0)
        throw InputError(fmt::format("{}: realization {} has no points", task_.label, range.first));
    if (listener.sampled) listener.sampled(sample.record.points, sample.record.seconds);
    return sample;
}

void SeriesWork::store(std::uint32_t realization, const Sample& sample)
{
    store_sample(store_, units_.sample_key(realization), sample, has_points_to_keep(realization), comment(realization));
}

void SeriesWork::sample(const RealizationRange& range, const WorkListener& listener)
{
    const std::uint32_t end = range.first + range.count;
    for (std::uint32_t k = range.first; k < end; ++k)
        if (!is_sampled(k)) store(k, make({k, end - k}, listener));
}

/// The record of a realization that is stored.
SampleRecord SeriesWork::record(std::uint32_t realization) const
{
    auto record = stored_sample(store_, units_.sample_key(realization));
    if (!record) throw missing_unit(fmt::format("realization {} of {}", realization, task_.label));
    return *std::move(record);
}

/// The record of the first realization, which is made if it is not stored; its points are at hand then.
SampleRecord SeriesWork::first_record(const WorkListener& listener)
{
    if (!is_sampled(0)) {
        Sample first = make(units_.part(0), listener);
        store(0, first);
        first_ = std::move(first.points);
    }
    return record(0);
}

// Analysis.

bool SeriesWork::is_analysed(std::uint32_t part) const
{
    return store_.find(units_.part_key(part)) || store_.find(units_.analysis_key());
}

/// A stored set: in the unit square, or in a region, in its units.
PointSet SeriesWork::points_in(const std::filesystem::path& file) const
{
    if (!experiment_.analysis_of(task_).region) return read_own_points(file).at(0);
    return read_own_points(file, any_coordinates).at(0);
}

/// The unit of a part, without any realization yet.
SeriesAnalysis SeriesWork::begin_unit(std::uint32_t part, const WorkListener& listener)
{
    const RealizationRange range = units_.part(part);
    // The first realization has the size that the others must have, and knows whether they are tiled.
    const SampleRecord first = first_record(listener);
    if (part > 0) first_ = {}; // somebody else analyses it
    const SeriesAnalysis::Begin begin{range.first, range.first == 0 ? 0 : first.points};
    return {task_.label, first.traits.sizes_vary, with_traits(task_, first.traits, experiment_.analysis_of(task_)),
            begin};
}

/// Adds realizations, those that are not stored while they are being made: sampling and analysis take turns and never
/// run at the same time. Times of sampling are results, and analysis would disturb them.
void SeriesWork::add_realizations(SeriesAnalysis& unit, const RealizationRange& range, const WorkListener& listener)
{
    for (std::uint32_t k = range.first; k < range.first + range.count; ++k) {
        stop_if_interrupted();
        if (!task_.strips.empty()) {
            if (experiment_.workplace->on_step) experiment_.workplace->on_step("analysing sets on the disk");
            unit.add(*task_.strips.at(k));
            if (!is_sampled(k)) store(k, make({k, 1}, listener));
        } else if (k == 0 && first_.size() > 0) {
            unit.add(std::exchange(first_, {}));
        } else if (const auto file = stored_points(store_, units_.sample_key(k))) {
            unit.add(points_in(*file));
        } else {
            const Sample sample = make({k, range.first + range.count - k}, listener);
            do_side_by_side([&] { unit.add(sample.points); }, [&] { store(k, sample); });
        }
        if (listener.analysed) listener.analysed();
    }
}

/// Analyses a part, with a unit that begin_unit() made for it.
void SeriesWork::measure_part(SeriesAnalysis& unit, std::uint32_t part, const WorkListener& listener)
{
    add_realizations(unit, units_.part(part), listener);
    if (part == 0) unit.measure_first();
    store_part(unit, store_, units_.part_key(part));
}

void SeriesWork::analyse(std::uint32_t part, const WorkListener& listener)
{
    if (is_analysed(part)) return;
    SeriesAnalysis unit = begin_unit(part, listener);
    measure_part(unit, part, listener);
}

/// Takes a stored part, or analyses it. False: there is no need, as another process has finished the whole analysis,
/// and may have removed its parts.
bool SeriesWork::take_part(SeriesAnalysis& unit, std::uint32_t part, const WorkListener& listener)
{
    stop_if_interrupted();
    if (load_part(unit, store_, units_.part_key(part))) return true;
    if (store_.find(units_.analysis_key())) return false;
    measure_part(unit, part, listener);
    return true;
}

/// All parts put together; nothing where another process was faster. The only part of a series is not worth storing.
std::optional<SeriesAnalysis> SeriesWork::whole_analysis(const WorkListener& listener)
{
    SeriesAnalysis whole = begin_unit(0, listener);
    if (units_.parts() == 1) {
        add_realizations(whole, units_.part(0), listener);
        return whole;
    }
    if (!take_part(whole, 0, listener)) return std::nullopt;
    for (std::uint32_t part = 1; part < units_.parts(); ++part) {
        SeriesAnalysis unit = begin_unit(part, listener);
        if (!take_part(unit, part, listener)) return std::nullopt;
        if (unit.repeats(whole)) add_new_sets(unit, part, whole);
        whole.append(unit);
    }
    return whole;
}

/// Analyses a part anew without the sets that earlier parts have: methods that make few sets repeat them from part to
/// part. Sets whose points were not stored are made again, and nothing is stored.
void SeriesWork::add_new_sets(SeriesAnalysis& unit, std::uint32_t part, const SeriesAnalysis& earlier)
{
    unit = begin_unit(part, {});
    unit.leave_out(earlier);
    const RealizationRange range = units_.part(part);
    for (std::uint32_t k = range.first; k < range.first + range.count; ++k) {
        if (!task_.strips.empty()) {
            unit.add(*task_.strips.at(k));
            continue;
        }
        const auto file = stored_points(store_, units_.sample_key(k));
        unit.add(file ? points_in(*file) : make({k, range.first + range.count - k}, {}).points);
    }
}

void SeriesWork::analyse_all(const WorkListener& listener)
{
    std::optional<SeriesAnalysis> whole = whole_analysis(listener);
    if (!whole) return;
    IterationRecords iterations;
    for (std::uint32_t k = 0; k < task_.realizations; ++k)
        if (!whole->is_repeated(k)) iterations.push_back(record(k).traits.iterations);
    store_analysis(*whole, store_, units_.analysis_key(), image_metadata(),
                   iterations_of(iterations) ? iterations_csv(iterations) : "");
}

void SeriesWork::remove_parts()
{
    if (units_.parts() == 1) return;
    for (std::uint32_t part = 0; part < units_.parts(); ++part) store_.remove(units_.part_key(part));
}

// Times.

/// Seconds of every realization that was made under the conditions of now, and those of further runs.
std::vector<double> SeriesWork::seconds_so_far() const
{
    const std::string now = experiment_.workplace->conditions();
    std::vector<double> seconds;
    for (std::uint32_t k = 0; k < task_.realizations; ++k)
        if (const SampleRecord sample = record(k); sample.conditions == now) seconds.push_back(sample.seconds);
    if (const auto unit = store_.find(units_.times_key(now))) {
        std::vector<double> more;
        from_bytes(unit->record, more);
        seconds.insert(seconds.end(), more.begin(), more.end());
    }
    return seconds;
}

/// The first realization is made again and again: few times are no median.
void SeriesWork::time_more()
{
    if (!task_.is_timed()) return;
    std::size_t count = seconds_so_far().size();
    if (count >= experiment_.timing_runs) return;
    const UnitKey key = units_.times_key(experiment_.workplace->conditions());
    std::vector<double> seconds;
    if (const auto unit = store_.find(key)) from_bytes(unit->record, seconds);
    for (; count < experiment_.timing_runs; ++count) seconds.push_back(make({0, 1}, {}).record.seconds);
    store_.store(key, to_bytes(seconds));
}

// The whole series.

bool SeriesWork::has_results() const
{
    if (!store_.find(units_.analysis_key())) return false;
    for (std::uint32_t k = 0; k < task_.realizations; ++k)
        if (!is_sampled(k)) return false;
    return true;
}

bool SeriesWork::is_finished() const
{
    return has_results() && (!task_.is_timed() || seconds_so_far().size() >= experiment_.timing_runs);
}

void SeriesWork::finish(const WorkListener& listener)
{
    if (!store_.find(units_.analysis_key())) analyse_all(listener);
    sample({0, task_.realizations}, listener); // what is missing though its analysis is there
    time_more();
}

StoredAnalysis SeriesWork::finished_analysis() const
{
    auto analysis = stored_analysis(store_, units_.analysis_key());
    if (!analysis) throw missing_unit("the analysis of " + task_.label);
    return *std::move(analysis);
}

Series SeriesWork::result() const
{
    Series result = finished_analysis().result;
    IterationRecords iterations;
    std::optional<double> proven;
    for (std::uint32_t k = 0; k < task_.realizations; ++k) {
        const SampleRecord sample = record(k);
        const SetTraits& traits = sample.traits;
        result.build_seconds += sample.build_seconds;
        result.preparation_seconds += sample.preparation_seconds;
        if (result.is_repeated(k)) continue;
        if (k == 0 || (proven && traits.proven_relative_radius < proven)) proven = traits.proven_relative_radius;
        iterations.push_back(traits.iterations);
        if (k == 0) result.tile_set = traits.tile_set;
        if (has_points_to_keep(k)) result.point_files.push_back(file_names::realization(k));
    }
    if (proven) result.measures.numbers["proven_relative_radius"] = {*proven, {}};
    result.iterations = iterations_of(iterations);
    if (result.iterations) result.iterations->file = file_names::iterations;
    if (task_.is_timed()) result.sample_seconds = seconds_so_far();
    return result;
}

std::map<std::string, std::filesystem::path> SeriesWork::files() const
{
    StoredAnalysis analysis = finished_analysis();
    std::map<std::string, std::filesystem::path>& files = analysis.files;
    for (std::uint32_t k = 0; k < task_.realizations; ++k) {
        if (!has_points_to_keep(k) || analysis.result.is_repeated(k)) continue;
        const auto points = stored_points(store_, units_.sample_key(k));
        if (!points) throw missing_unit(fmt::format("realization {} of {}", k, task_.label));
        files[file_names::realization(k)] = *points;
    }
    if (const auto set = stored_tile_set(store_, units_.sample_key(0))) files[file_names::tile_set] = *set;
    return files;
}

bool SeriesWork::used_device() const
{
    for (std::uint32_t k = 0; k < task_.realizations; ++k)
        if (record(k).on_device) return true;
    return false;
}

}
