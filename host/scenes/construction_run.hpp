// Constructs the Poisson tile sets that an experiment shows pictures of.
#pragma once

#include "host/scenes/construction_panels.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// Makes the filler of tori for the engine of the experiment.
using FillerFactory = std::function<std::unique_ptr<TileFiller>(const FillSettings&)>;

/// One scene for each config. Configs with the same parameters share one construction, which goes no further
/// than the pieces that they show. `progress` is told of steps. Throws InputError for tile sets that cannot
/// be made.
std::vector<Scene> construct_scenes(std::span<const ConstructionConfig> configs, const FillerFactory& make_filler,
                                    const std::function<void(const std::string&)>& progress);

}
