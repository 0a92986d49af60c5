// The iterations of a series: as a table of all realizations, and averaged over them.
#pragma once

#include "results/records/sample_records.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// One list of records a realization, which may differ in length.
using IterationRecords = std::vector<std::vector<IterationRecord>>;

/// The text of iterations.csv: realization,iteration,relative_radius,energy, and relative_radius_within_tiles where all
/// records have it; 17 significant digits.
std::string iterations_csv(const IterationRecords& records);

/// Reads what iterations_csv() wrote. Throws InputError with file and line.
IterationRecords read_iterations_table(const std::filesystem::path& path);

/// A quantity after each iteration, over the realizations that got there.
struct IterationSpread
{
    std::vector<double> min;
    std::vector<double> mean;
    std::vector<double> max;

    bool operator==(const IterationSpread&) const = default;
};

/// The iterations of a method that has some; item 0 is the state before the first one.
struct Iterations
{
    std::string file;                      ///< relative to the run's folder
    std::vector<std::size_t> realizations; ///< how many got to each iteration: never growing; empty: without means
    IterationSpread relative_radius;
    IterationSpread energy;
    std::optional<IterationSpread> relative_radius_within_tiles; ///< of tiles that are relaxed

    bool operator==(const Iterations&) const = default;

    /// The largest number of iterations of a realization.
    std::size_t count() const { return realizations.size() - 1; }
};

/// Means over all realizations, without the file. Nothing where there are no iterations; without means where a value is
/// not finite (a single point has no relative radius).
std::optional<Iterations> iterations_of(const IterationRecords& records);

}
