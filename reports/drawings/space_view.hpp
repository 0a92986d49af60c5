// The parallel projection in which the construction of Poisson sphere tiles is drawn, and what hides what in
// it.
//
// Seen from the south-east and above, as corner cubes are, but not along a diagonal: so no corner of a cube
// hides another, and lattices of points do not fall into lines.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "results/pictures/construction_scene.hpp"
#include "tiles/poisson/region_shapes.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace poissonlab {

/// The point at which a place is drawn: units as in space, x to the right, y downwards.
DrawingPoint projected(const ShapeVector& place);

/// The nearness of a place to the viewer; larger is nearer.
double nearness(const ShapeVector& place);

/// Does a face with this normal show its outer side?
bool is_in_sight(const ShapeVector& normal);

/// The light that falls on such a face, 0 to 1: it comes from above, on the viewer's left.
double light_on(const ShapeVector& normal);

/// The numbers of convex bodies that do not overlap, each after all that it may hide.
std::vector<std::size_t> back_to_front(const std::vector<RegionShape>& bodies);

/// The corners of a panel's window in space.
std::array<ShapeVector, 8> window_corners(const ScenePanel& panel);

/// The upper left and lower right corner of a projected window.
std::array<DrawingPoint, 2> projected_window(const ScenePanel& panel);

}
