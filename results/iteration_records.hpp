// The iterations of a series: as a table of all realizations, and averaged over them.
#pragma once

#include "results/records/sample_records.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// One list of records a realization, which may differ in length.
using IterationRecords = std::vector<std::vector<IterationRecord>>;

/// The text of iterations.csv: realization,iteration,relative_radius,energy; 17 significant digits.
std::string iterations_csv(const IterationRecords& records);

/// A quantity after each iteration, over the realizations that got there.
struct IterationSpread
{
    std::vector<double> min;
    std::vector<double> mean;
    std::vector<double> max;
};

/// The spread of a member of all records.
IterationSpread spread_over_realizations(const IterationRecords& records, double IterationRecord::*member);

/// How many realizations got to each iteration: as many as there are at first, never growing.
std::vector<std::size_t> realizations_that_got_there(const IterationRecords& records);

}
