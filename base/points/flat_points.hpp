// Points of the plane that are stored as x, y and a third coordinate that is always the same.
#pragma once

#include "base/geometry/point_set.hpp"

#include <vector>

namespace poissonlab {

/// True where all points of all sets have one third coordinate. A single point is one of the plane only where it is
/// `zero`, what 0 has become.
bool are_flat(const std::vector<PointSet>& sets, double zero = 0);

/// The first two coordinates of points in space.
PointSet without_third(PointSet set);

/// The words for readers whose points lost it.
inline constexpr auto flat_sentence =
    "all points have the same third coordinate: they are taken as points of the plane, without it";

}
