// The samplers "hat-tiles" and "spectre-tiles": windows of tilings by aperiodic monotiles, with points in each tile
// whose places depend on the tiles around it.
#pragma once

#include "host/sampling/sampler.hpp"
#include "host/tile_sampling/built_once.hpp"
#include "tiles/monotiles/monotile_table.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

/// Reads the table of a tiling ("hat", "spectre") from `folder`, or builds it and stores it there: see built_once().
/// With an empty folder it is always built. `on_step` is told of waiting and of the steps of building; what it throws
/// ends the building.
BuiltOnce<MonotileTable> cached_monotile_table(const std::string& tiling, std::uint32_t points, std::uint32_t levels,
                                               const std::filesystem::path& folder,
                                               const std::function<void(const std::string& what)>& on_step = {});

SamplerSpec hat_sampler();
SamplerSpec spectre_sampler();

}
