// Point sets that are windows of the plane or of space, not tori.
#pragma once

#include "base/geometry/point_set.hpp"

namespace poissonlab {

/// The set in a torus that is twice as long: half as large, in [0, 1/2). No two points are nearer across the torus's
/// border than they are inside, so that toroidal distances there are half of those in the window.
inline PointSet halved(PointSet points)
{
    for (double& c : points.coordinates) c /= 2;
    return points;
}

}
