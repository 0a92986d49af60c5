// Sentences on what was made of the files of the regions of an experiment.
#pragma once

#include "experiment/series/experiment.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// Sentences on unions and on planes that longitude and latitude were mapped to, each once.
std::vector<std::string> region_notes(const Experiment& experiment);

}
