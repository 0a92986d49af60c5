// An experiment as the runner sees it, and what comes out of it. A config becomes one, imported point sets
// another.
#pragma once

#include "analysis/spectrum.hpp"
#include "sampling/sampler.hpp"

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
    std::function<std::unique_ptr<Sampler>()> create;
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
    PeriodogramMethod spectrum = PeriodogramMethod::fast;
    std::uint32_t realizations = 0; ///< K as asked for
    std::vector<SeriesTask> series;
    std::function<Machine()> machine; ///< asked at the end: devices are opened when they are needed
};

/// What was measured on one series. Vectors have one value a realization.
struct SeriesResult
{
    std::vector<std::size_t> points;
    std::vector<double> min_distance; ///< unit lengths; infinite for a set of one point
    std::vector<double> relative_radius;
    std::vector<double> covered_fraction;
    int spectrum_size = 0;
    std::vector<std::vector<IterationRecord>> iterations; ///< empty for methods without any
    std::vector<std::string> point_files;                 ///< relative to the output folder
    std::vector<double> sample_seconds;
    double build_seconds = 0;
    double analysis_seconds = 0;
};

}
