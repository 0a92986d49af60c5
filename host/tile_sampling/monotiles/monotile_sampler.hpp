// The samplers "hat-tiles" and "spectre-tiles": windows of tilings with one tile that never repeats, with points in
// each tile whose places depend on what lies around the tile.
#pragma once

#include "host/sampling/sampler.hpp"
#include "host/tile_sampling/built_once.hpp"
#include "tiles/monotiles/monotile_table.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

/// The table of a tiling ("hat", "spectre") from `folder`, or built and put there: see built_once(). An empty folder:
/// always built. `on_step` is told of waiting and of the steps of building; what it throws ends that.
BuiltOnce<MonotileTable> cached_monotile_table(const std::string& tiling, std::uint32_t points, std::uint32_t levels,
                                               const std::filesystem::path& folder,
                                               const std::function<void(const std::string& what)>& on_step = {});

SamplerSpec hat_sampler();
SamplerSpec spectre_sampler();

}
