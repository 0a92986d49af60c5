// Runs an experiment: makes the point sets, analyses them, stores every result.
#pragma once

#include "experiment/experiment.hpp"
#include "experiment/progress.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The folders below the output folder that an experiment fills.
std::vector<std::string> folder_names(const Experiment& experiment);

/// Makes every series and writes all of docs/output-folder.md but the report and its pictures to `out`.
///
/// All or nothing: on any failure, and on Ctrl-C, a previous result in `out` stays as it is. Sampling and
/// analysis take turns and never run at the same time: the times of sampling are results, and analysis would
/// disturb them. Throws what samplers throw, InputError and StorageError.
void run_experiment(const Experiment& experiment, const std::filesystem::path& out, Progress& progress);

}
