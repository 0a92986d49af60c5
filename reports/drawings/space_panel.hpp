// Panels of the construction of Poisson sphere tiles: regions as bodies or as wires, and spheres.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.30, 4.31 and 4.33 to 4.37.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "results/pictures/construction_result.hpp"

namespace poissonlab {

/// Width and height of a panel's projected window, units of tiles.
DrawingPoint space_panel_size(const ScenePanel& panel);

/// Appends what the panel shows, with its projected window's upper left corner at `origin`. `scale`: units of
/// the drawing a unit of tiles.
void add_space_panel(std::vector<Shape>& shapes, const Scene& scene, const ScenePanel& panel,
                     const DrawingPoint& origin, double scale);

}
