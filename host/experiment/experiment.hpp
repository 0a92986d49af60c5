// An experiment as the runner sees it, and what comes out of it. A config becomes one, imported point sets
// another.
#pragma once

#include "analysis/blue_noise_measures.hpp"
#include "analysis/integration_error.hpp"
#include "analysis/largest_empty_ball.hpp"
#include "analysis/lattice_peaks.hpp"
#include "analysis/low_frequency_power.hpp"
#include "analysis/peak_anisotropy.hpp"
#include "analysis/voronoi_diagram.hpp"
#include "experiment/analysis_options.hpp"
#include "experiment/construction_run.hpp"
#include "experiment/method_grid.hpp"
#include "experiment/tiling_table.hpp"
#include "sampling/sampler.hpp"
#include "store/unit_key.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// One series to be made: how it is called and what makes its point sets.
struct SeriesTask
{
    std::string name;  ///< folder
    std::string label; ///< for the report
    std::string sampler;
    Parameters parameters;
    bool deterministic = false;
    std::uint32_t realizations = 0;
    std::size_t points = 0; ///< as asked of each set, 0: not known
    bool is_timed = true; ///< false: sets that are there already; reading a file is not sampling
    std::optional<GridPlace> place; ///< none: not of a method of a config
    /// Everything that decides which sets the sampler makes: part of the keys of its stored work. Asked when work
    /// begins; empty: name and sampler say enough.
    std::function<UnitKey()> identity;
    std::function<std::unique_ptr<Sampler>()> create;
};

/// One tile set or tiling to be drawn and tested.
struct TilingTask
{
    std::string name; ///< folder
    TilingConfig config;
};

/// One picture of the construction of Poisson tiles.
struct ConstructionTask
{
    std::string name; ///< folder
    ConstructionConfig config;
};

/// What the computation ran on. Empty and zero: not used.
struct Machine
{
    std::string device;
    std::string platform;
    std::string driver;
    std::string device_version;
    unsigned compute_units = 0;
    int threads = 0;
    int processes = 0; ///< that shared the work; 0: one
};

/// Told what is being done, in a few words, by work that takes long.
using StepListener = std::function<void(const std::string& what)>;

/// The devices and threads of an experiment.
struct Workplace
{
    /// What of the device decides results beyond their last bits, for keys of stored work; nothing is opened.
    std::function<std::string()> identity;
    /// What times depend on beside processes: device and threads; nothing is opened.
    std::function<std::string()> machine_conditions;
    int processes = 1; ///< that share the work; set by who runs the experiment
    std::function<bool()> is_device_open;
    /// With the device, which is opened for that, or without.
    std::function<Machine(bool with_device)> machine;
    StepListener on_step; ///< set by who runs the experiment

    /// What times depend on.
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
    std::uint32_t realizations = 0; ///< K as asked for
    std::uint32_t timing_runs = 1;  ///< the least number of times that each series is timed
    std::vector<MethodGrid> methods; ///< of the config; none for imported sets
    std::vector<SeriesTask> series;
    std::vector<TilingTask> tilings;
    std::vector<ConstructionTask> constructions;
    FillerFactory make_filler;        ///< of constructions
    std::shared_ptr<Workplace> workplace = std::make_shared<Workplace>(); ///< shared with the samplers
};

/// What the sampling test came to. Vectors have one value a realization.
struct ZonePlateResult
{
    int size = 0;                  ///< pixels of the first picture along each axis
    std::vector<double> rms_error; ///< over the whole picture
    std::vector<double>
        resolved_rms_error; ///< where the plate has up to half a cycle per pixel; NaN: nowhere
};

/// Measures of the field beyond distances and spectra. Nothing: not defined for the sets at hand.
struct SeriesMeasures
{
    std::optional<double> effective_nyquist; ///< of the mean spectrum, in units of half of N^(1/dimension)
    std::optional<double> effective_nyquist_error; ///< standard errors, here and below: of two realizations and more
    std::optional<Oscillation> oscillation;
    std::optional<double> oscillation_error;
    std::optional<PeakAnisotropy> peak_anisotropy;
    std::optional<LowFrequencyPower> low_frequency_power;
    std::optional<LatticePeaks> lattice_peaks; ///< of sets that are said to be tiled
    std::optional<double> lattice_peaks_error; ///< of mean_ratio
    std::vector<IntegrationError> integration;     ///< over all realizations
    std::optional<double> packing_fraction;           ///< these are of the first realization
    std::optional<LargestEmptyBall> largest_empty;
    std::optional<VoronoiStatistics> voronoi; ///< 2D
};

/// What was measured on one series. Vectors have one value a realization.
struct SeriesResult
{
    std::vector<std::size_t> points;
    std::vector<double> min_distance; ///< unit lengths; infinite for a set of one point
    std::vector<double> relative_radius;
    std::vector<double> covered_fraction;
    int spectrum_size = 0; ///< 0: no spectrum
    std::optional<ZonePlateResult> zone_plate;
    std::vector<std::vector<IterationRecord>> iterations; ///< empty for methods without any
    SeriesMeasures measures;
    bool has_pair_correlation = false; ///< sets of one point have none
    std::vector<std::string> point_files;                 ///< relative to the output folder
    std::vector<double> sample_seconds; ///< of the realizations, then of further runs; under one run's conditions
    std::optional<TileSetRecord> tile_set; ///< of methods that tile
    double build_seconds = 0;
    double preparation_seconds = 0;
    double analysis_seconds = 0;
};

}
