// An experiment as the runner sees it, and what comes out of it. A config becomes one, imported point sets
// another.
#pragma once

#include "base/points/point_strips.hpp"
#include "experiment/config/plan.hpp"
#include "experiment/exhibits/exhibit.hpp"
#include "experiment/store/unit_store.hpp"
#include "host/sampling/sampler.hpp"
#include "results/run.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// One series to be made: its plan, and what makes its point sets. Sets that are there already have the sampler "file".
struct SeriesTask : SeriesPlan
{
    std::size_t device_bytes = 0; ///< the most that sampling takes of the device
    /// Everything that decides which sets the sampler makes: part of the keys of its stored work. Asked when work
    /// begins; empty: name and sampler say enough.
    std::function<UnitKey()> identity{};
    std::function<std::unique_ptr<Sampler>()> create{};
    /// Sets on disk that are there already, one a realization, instead of a sampler: their points are not stored.
    std::vector<std::shared_ptr<const PointStrips>> strips{};

    /// False for sets that are there already: reading a file is not sampling.
    bool is_timed() const { return !sampler->has_own_points; }
};

/// Told what is being done, in a few words, by work that takes long.
using StepListener = std::function<void(const std::string& what)>;

/// The devices and threads of an experiment.
struct Workplace
{
    /// The device's kind (DeviceInfo::identity), for keys of stored work; does not open the device.
    std::function<std::string()> identity;
    /// The device and the number of threads, on which times depend; does not open the device.
    std::function<std::string()> machine_conditions;
    int processes = 1; ///< that share the work; set by who runs the experiment
    std::function<bool()> is_device_open;
    /// The machine, with the device, which is opened, or without.
    std::function<Machine(bool with_device)> machine;
    StepListener on_step; ///< set by who runs the experiment

    /// The conditions under which times can be compared.
    std::string conditions() const
    {
        return (machine_conditions ? machine_conditions() : "") + "; processes: " + std::to_string(processes);
    }
};

struct Experiment
{
    std::string title;
    std::string command;                ///< as it would be typed
    std::string config;                 ///< the config's text; empty for imported sets
    std::vector<std::string> overrides; ///< --set arguments
    std::optional<std::uint64_t> seed;  ///< empty, like the engine, for imported sets
    std::string engine;                 ///< "opencl" or "reference"
    int dimension = 2;
    AnalysisOptions analysis;
    std::uint32_t realizations = 0;  ///< K as asked for
    std::uint32_t timing_runs = 1;   ///< the least number of times that each series is timed
    std::vector<MethodGrid> methods; ///< of the config; none for imported sets
    std::vector<SeriesTask> series;
    std::vector<std::string> left_out; ///< series that cannot be made on this machine, each with why: a sentence
    std::vector<std::string> notes;    ///< what its user must know of the sets that were read, a sentence each
    std::vector<Exhibit> exhibits;
    DistributionPlace place;                                              ///< of exhibits
    std::shared_ptr<Workplace> workplace = std::make_shared<Workplace>(); ///< shared with the samplers

    /// The options by which the sets of a series are measured.
    AnalysisOptions analysis_of(const SeriesTask& task) const
    {
        AnalysisOptions options = analysis;
        if (task.region) options.region = task.region;
        return options;
    }
};

}
