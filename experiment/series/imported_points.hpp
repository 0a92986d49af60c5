// Point sets made elsewhere as an experiment of one series, analysed exactly like sets made here.
#pragma once

#include "base/points/point_file.hpp"
#include "experiment/series/experiment.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The place where sets are kept that are too large for memory.
struct LargeImports
{
    /// The disk that has room for them: beside this file or folder, which need not be there yet.
    std::filesystem::path beside;

    /// All sets are kept there, however small.
    bool all = false;
};

/// Sets with more points in one file than this are read in pieces, and kept on the disk: 0.27 GB of numbers in 2D.
inline constexpr std::uint64_t most_points_in_memory = std::uint64_t{1} << 24;

/// Reads every file, one or more realizations each, in the order given. All sets must have the same number of
/// points. `label` is for the report; empty: the first file's stem. `how`: see read_points(). Files that are parts of a
/// snapshot of which one is named before are left out. Where one of the files is large and can be read in pieces (see
/// point_stream.hpp), all are, one realization each. A domain with sides that differ, given or declared by the files,
/// becomes the box of the experiment's analysis.
/// Throws InputError that names the file: unreadable, of another size than the first, not 2D; and where the disk has no
/// room for what must be kept there.
Experiment import_points(const std::vector<std::filesystem::path>& files, const std::string& label,
                         const PointReading& how = {}, const LargeImports& large = {});

/// Throws InputError where the options ask for what sets that are read in pieces do not have: zone plates, exact
/// spectra.
void check_imported(const Experiment& experiment);

/// An experiment of one series, of sets that are in memory, at least one. Throws InputError where one is of another
/// size than the first.
Experiment import_sets(const std::vector<PointSet>& sets, const std::string& label);

}
