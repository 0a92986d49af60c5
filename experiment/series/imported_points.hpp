// Point sets made elsewhere as an experiment of one series, analysed exactly like sets made here.
#pragma once

#include "base/points/point_file.hpp"
#include "experiment/series/experiment.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Reads every file, one or more realizations each, in the order given. All sets must have the same number of
/// points. `label` is for the report; empty: the first file's stem. `domain`: see read_points().
/// Throws InputError that names the file: unreadable, of another size than the first, not 2D.
Experiment import_points(const std::vector<std::filesystem::path>& files, const std::string& label,
                         std::optional<CoordinateRange> domain = {});

/// The same for sets that are in memory, at least one. Throws InputError where one is of another size than the first.
Experiment import_sets(const std::vector<PointSet>& sets, const std::string& label);

}
