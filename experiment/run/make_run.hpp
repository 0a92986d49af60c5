// The results of an experiment as the Run that results/ stores.
#pragma once

#include "experiment/series/experiment.hpp"
#include "results/run.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The results of the tasks of an experiment, one item for each; std::nullopt where it has failed.
struct ExperimentResults
{
    std::vector<std::optional<Series>> series;      ///< as SeriesWork::result() has them
    std::vector<std::optional<Exhibited>> exhibits; ///< files without the folder
    std::vector<std::string> failures;              ///< a sentence each
    Machine machine;
};

/// The run of an experiment with its results: names, parameters and files of each task.
Run make_run(const Experiment& experiment, const ExperimentResults& results);

}
