// The tile sets that objects and instances are placed by.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <filesystem>

namespace poissonlab {

/// The points of a tile of the default set in the plane.
inline constexpr std::uint32_t points_per_default_tile = 32;

/// The set of a file; empty: corner tiles of 3 colours and 32 points, as the dissertation has them, in space of 2
/// colours and 128 points. Throws InputError for a set of another dimension.
PoissonTileSet object_tile_set(const std::filesystem::path& file, int dimension, const DistributionPlace& place);

}
