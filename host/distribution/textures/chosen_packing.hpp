// The packing that settings ask for.
#pragma once

#include "host/settings/distributions/texture_config.hpp"
#include "tiles/packing/tile_packing.hpp"

#include <cstdint>

namespace poissonlab {

TilePacking chosen_packing(const PackingSettings& settings, std::uint64_t seed);

}
