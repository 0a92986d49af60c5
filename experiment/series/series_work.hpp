// Does the work on one series, unit by unit, each stored as soon as it is done.
#pragma once

#include "base/errors/errors.hpp"
#include "experiment/series/experiment.hpp"
#include "experiment/series/series_units.hpp"
#include "experiment/store/unit_store.hpp"
#include "results/series.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace poissonlab {

// Listeners that are told of work while it goes on.

/// Hears of the progress of one job. Functions may be empty.
struct WorkListener
{
    /// A realization was made, of so many points, in so many seconds.
    std::function<void(std::size_t points, double seconds)> sampled;
    /// A realization was analysed, or its stored analysis was taken.
    std::function<void()> analysed;
};

class SeriesAnalysis;
struct StoredAnalysis;

/// The units of a series' work. A stored unit is never made again; units may be made in any order, by any process that
/// shares the store.
class SeriesWork
{
public:
    /// All arguments must outlive it. `slot` is shared by the series of a process.
    SeriesWork(const Experiment& experiment, const SeriesTask& task, const CodeVersions& versions, UnitStore& store,
               SamplerSlot& slot);

    const SeriesUnits& units() const { return units_; }
    const SeriesTask& task() const { return task_; }

    /// True if points of every realization are kept, not only of the first.
    bool keeps_points() const { return !experiment_.analysis.first_points_only; }

    bool is_sampled(std::uint32_t realization) const;
    bool is_analysed(std::uint32_t part) const;

    /// True if everything is stored that the output folder needs, with times under the conditions of this process.
    bool is_finished() const;

    /// True if everything is stored that the output folder needs, times apart.
    bool has_results() const;

    /// Makes the realizations of a range.
    void sample(const RealizationRange& range, const WorkListener& listener);

    /// Analyses the realizations of a part, making those that are missing.
    void analyse(std::uint32_t part, const WorkListener& listener);

    /// Does what is left: missing realizations and parts, the analysis of the whole series, and times.
    void finish(const WorkListener& listener);

    /// Takes times under the conditions of this process until there are enough: other machines may have made what is
    /// stored.
    void time_more();

    /// Removes the stored parts of an analysis that is whole.
    void remove_parts();

    /// Everything about a finished series but its name and files' folder.
    Series result() const;

    /// Files of a finished series for the output folder: where they are, by their names there.
    std::map<std::string, std::filesystem::path> files() const;

    /// True if a device took part in making the finished series.
    bool used_device() const;

private:
    bool has_points_to_keep(std::uint32_t realization) const;
    Sample make(const RealizationRange& range, const WorkListener& listener);
    void store(std::uint32_t realization, const Sample& sample);
    SampleRecord record(std::uint32_t realization) const;
    SampleRecord first_record(const WorkListener& listener);
    PointSet points_in(const std::filesystem::path& file) const;
    SeriesAnalysis begin_unit(std::uint32_t part, const WorkListener& listener);
    void add_realizations(SeriesAnalysis& unit, const RealizationRange& range, const WorkListener& listener);
    void add_new_sets(SeriesAnalysis& unit, std::uint32_t part, const SeriesAnalysis& earlier);
    void measure_part(SeriesAnalysis& unit, std::uint32_t part, const WorkListener& listener);
    bool take_part(SeriesAnalysis& unit, std::uint32_t part, const WorkListener& listener);
    std::optional<SeriesAnalysis> whole_analysis(const WorkListener& listener);
    void analyse_all(const WorkListener& listener);
    std::vector<double> seconds_so_far() const;
    StoredAnalysis finished_analysis() const;
    StorageError missing_unit(const std::string& what) const;
    std::string comment(std::uint32_t realization) const;
    std::map<std::string, std::string> image_metadata() const;

    const Experiment& experiment_;
    const SeriesTask& task_;
    UnitStore& store_;
    SamplerSlot& slot_;
    SeriesUnits units_;
    PointSet first_; ///< realization 0, made and not analysed yet; else empty
};

}
