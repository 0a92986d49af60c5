// Points of several classes along lines of the plane: lamps and benches along paths.
//
// One-dimensional dart throwing by arc length, with a distance for each pair of classes (Wei, Multi-class blue noise
// sampling, SIGGRAPH 2010) that is straight through the plane, also between lines. Each class has its free positions on
// the lines (host/distribution/regions/line_darts.hpp); a point takes from those of every class, and darts of the class
// that is least filled fall into what is left of its own, uniformly by length. So no dart fails, and a class without
// free positions is full.
#pragma once

#include "host/distribution/classes/class_points.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Returns the number of points of each class: `per_length` times the length of the lines that obstacles leave,
/// rounded. Throws InputError where a class has none, or there would be too many.
std::vector<std::size_t> points_on_lines(const ClassSettings& settings);

/// Reads the lines, and finds the distances that classes keep on them. Throws InputError where there are no lines, or
/// they have no room for the distances.
void place_on_lines(const ClassSettings& settings, ClassWork& work);

/// Throws the darts of a work that place_on_lines() has prepared. Distances that are computed from coordinates are
/// never below those that classes keep. Throws InputError where obstacles leave no room for a point.
ClassSet throw_line_classes(const ClassSettings& settings, ClassWork work);

/// The least distance of points of each pair of classes, through the plane, as computed from their coordinates;
/// infinite where a pair has no points. Time is O(N^1.5) for well-spread points, and more only where most of them lie
/// on lines along the direction (-0.51, 0.86), or where classes are far from each other.
ClassDistances least_in_plane(const ClassedPoints& points);

}
