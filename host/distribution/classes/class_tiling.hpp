// Points of several classes by a tile set: a torus of tiles, in which each class and each pair of classes keeps the
// distance that is proven of the set.
#pragma once

#include "host/distribution/classes/class_points.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

namespace poissonlab {

/// The corner tiles that settings.colors asks for.
PoissonTileParameters class_tile_parameters(const ClassSettings& settings, std::uint64_t seed);

/// All points of a torus of settings.torus x settings.torus tiles of the set in settings.tiles, or of one that is
/// built, or was before, on the unit torus.
/// Tiling 0 is that of the seed, as `tiles points` has it; those of other numbers are others.
/// Throws InputError for files that cannot be read or whose points have no classes, and for too many points.
ClassSet tiled_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                       std::uint32_t number);

/// Makes the set of tiled_classes() by tiles that are there already.
ClassSet classes_by_tiles(const std::shared_ptr<const PoissonTileSet>& tiles, const ClassSettings& settings,
                          std::uint64_t seed, const DistributionPlace& place, std::uint32_t number);

}
