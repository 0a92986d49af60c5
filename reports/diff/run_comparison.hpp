// Two results of the same experiment, number by number: what changed beyond its error, and what is new or missing.
//
// Series are matched by the name of their run's folder and their own. Numbers with a spread over realizations go
// through Welch's test, curves point by point, all corrected for how many tests there are; numbers without chance are
// compared exactly. See number_comparison.hpp.
#pragma once

#include "reports/diff/number_comparison.hpp"
#include "results/run.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// A series, distribution or scheme that both have. The runs outlive it.
struct SeriesComparison
{
    std::string run;    ///< the folder of its run in a collection; empty: there is one run
    std::string series; ///< its own folder
    const Run* run_before = nullptr;
    const Run* run_after = nullptr;
    const Series* before = nullptr;
    const Series* after = nullptr;
    const DistributionResult* distribution_before = nullptr; ///< instead of series
    const DistributionResult* distribution_after = nullptr;
    std::vector<NumberComparison> numbers;

    /// "run/series", or the series alone where there is one run.
    std::string name() const;
    bool changed() const;
};

struct RunComparison
{
    std::vector<Run> before, after; ///< what was compared; the rest points into these
    std::vector<SeriesComparison> series;
    std::vector<std::string> missing; ///< series (or whole runs) of before only
    std::vector<std::string> added;   ///< of after only
    std::vector<std::string> remarks; ///< what differs about the runs themselves: version, device, seed, config

    bool changed() const;
    std::size_t count(Verdict verdict) const;
};

/// Compares two output folders or collections. Throws InputError for folders without readable results.
RunComparison compare_results(const std::filesystem::path& before, const std::filesystem::path& after);

/// The numbers of one series in both runs, not yet settled. Reads the tables of curves. Throws InputError.
std::vector<NumberComparison> compare_series(const SeriesComparison& pair);

/// The numbers of one distribution or scheme in both runs: those of textures by their catalogue. Times are not judged.
std::vector<NumberComparison> compare_distributions(const SeriesComparison& pair);

}
