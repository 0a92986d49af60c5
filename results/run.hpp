// The results of a run as they lie on disk: results.json of docs/output-folder.md.
//
// The machine that a run was computed on.
#pragma once

#include "results/pictures/construction_result.hpp"
#include "results/pictures/distribution_result.hpp"
#include "results/pictures/tiling_result.hpp"
#include "results/series.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// Empty and zero: not used.
struct Machine
{
    std::string device;
    std::string platform;
    std::string driver;
    std::string device_version;
    unsigned compute_units = 0;
    int threads = 0;
    int processes = 0; ///< that shared the work; 0: one

    bool operator==(const Machine&) const = default;

    /// The members that were used, in alphabetical order.
    std::vector<std::pair<std::string, std::string>> used() const;

    /// The member of that name as text; empty where it was not used.
    std::string text(const std::string& name) const;
};

/// One result folder.
struct Run
{
    std::filesystem::path folder; ///< of what was read
    std::string title;
    std::string version;
    std::string command;
    std::string config; ///< verbatim; empty for imported point sets
    std::vector<std::string> overrides;
    std::string seed;   ///< a number; empty when there is none
    std::string engine; ///< "opencl" or "reference"; empty when nothing was sampled
    int dimension = 2;
    int realizations = 0; ///< as asked for
    Machine machine;
    std::vector<MethodGrid> methods; ///< empty: not known, as in imported results
    std::vector<Series> series;
    std::vector<TilingResult> tilings; ///< and tile sets
    std::vector<ConstructionResult> constructions;
    std::vector<DistributionResult> distributions;
    std::vector<DistributionResult> schemes; ///< of tilings and tile sets
    std::vector<std::string> missing;        ///< what was asked for and is not there, and why: a sentence each

    bool operator==(const Run&) const = default;
};

/// The text of results.json.
std::string run_json(const Run& run);

/// Reads and checks folder/results.json, and that the files it names are there and that it has a series, a tiling, a
/// construction, a distribution or a scheme. Throws InputError that names the file and the member.
Run read_run(const std::filesystem::path& folder);

}
