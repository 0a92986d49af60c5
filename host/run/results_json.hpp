// results.json: the numbers of an experiment as text. docs/output-folder.md describes every member.
#pragma once

#include "host/scenes/tiling_analysis.hpp"
#include "host/series/experiment.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The text of results.json. `results` has one item for each series of the experiment, `statistics` one for each tile
/// set and tiling: nothing for sets and for tilings with a period; `scenes` one for each construction.
std::string results_json(const Experiment& experiment, const std::vector<SeriesResult>& results, const Machine& machine,
                         const std::vector<std::optional<TilingStatistics>>& statistics = {},
                         const std::vector<SceneSummary>& scenes = {});

}
