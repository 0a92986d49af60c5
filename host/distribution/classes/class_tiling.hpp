// Points of several classes by a tile set: a torus of tiles, in which each class and each pair of classes keeps the
// distance that is proven of the set.
#pragma once

#include "host/distribution/classes/class_points.hpp"

namespace poissonlab {

/// All points of a torus of settings.torus x settings.torus tiles of the set in settings.tiles, on the unit torus.
/// Throws InputError for files that cannot be read or whose points have no classes, and for too many points.
ClassSet tiled_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place);

}
