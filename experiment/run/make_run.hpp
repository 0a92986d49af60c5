// The results of an experiment as the Run that results/ stores.
#pragma once

#include "experiment/series/experiment.hpp"
#include "results/run.hpp"

#include <vector>

namespace poissonlab {

/// The results of the tasks of an experiment, one item for each.
struct ExperimentResults
{
    std::vector<Series> series;      ///< as SeriesWork::result() has them
    std::vector<Exhibited> exhibits; ///< files without the folder
    Machine machine;
};

/// The run of an experiment with its results: names, parameters and files of each task.
Run make_run(const Experiment& experiment, const ExperimentResults& results);

}
