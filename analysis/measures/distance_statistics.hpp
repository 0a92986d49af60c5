// Nearest-neighbour distances of a point set on the unit torus, in a periodic box, or of one that is a window.
#pragma once

#include "base/geometry/periodic_box.hpp"
#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

namespace poissonlab {

/// The smallest toroidal distance between two points, in unit lengths; 0 for coinciding points.
///
/// Exact up to rounding: for coordinates that are multiples of 2^-32, as all integer samplers make them, the
/// squared distance is compared as an exact integer and rounded once, in the final square root and scaling.
/// For other coordinates, and in a box that is no square (cube), differences and squares are rounded in double
/// (relative error below 1e-15 for distances above 1e-150). Coordinates must lie in [0, 1). A set of fewer than two
/// points has no distance: infinity. Time is O(N) for well-spread points, O(N log(1 / distance)) for any others.
double min_toroidal_distance(const PointSet& points, const PeriodicBox& box = {});

/// The mean over all points of the toroidal distance to the nearest other one, in unit lengths; infinite for fewer than
/// two points. Time is O(N) for well-spread points, O(N log(mean / least distance)) for others that do not coincide.
double mean_nearest_distance(const PointSet& points, const PeriodicBox& box = {});

/// The smallest distance of a window of the plane (of space): distances do not go across its borders. Differences and
/// squares are rounded in double.
double min_distance_in_window(const PointSet& points, const PeriodicBox& box = {});

/// The mean nearest distance of a window of the plane (of space).
double mean_nearest_distance_in_window(const PointSet& points, const PeriodicBox& box = {});

/// The least and the mean nearest distance of a set.
struct NearestDistances
{
    double least = 0, mean = 0;
};

/// Finds both for a set on disk, which is a torus or a window, strip by strip. The least distance is that of the
/// functions above, bit by bit; the mean is a sum in another order, and differs by its rounding, less than N 2^-53 of
/// it.
NearestDistances nearest_distances(const PointStrips& points, bool is_window);

}
