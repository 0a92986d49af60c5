// Panels of the construction of Poisson disk tiles: regions, points, and the disks around them.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.3 to 4.27.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "results/pictures/construction_result.hpp"

namespace poissonlab {

/// Width and height of a panel's window, units of tiles.
DrawingPoint plane_panel_size(const ScenePanel& panel);

/// Appends what the panel shows, with its window's upper left corner at `origin`. `scale`: units of the
/// drawing a unit of tiles.
void add_plane_panel(std::vector<Shape>& shapes, const Scene& scene, const ScenePanel& panel,
                     const DrawingPoint& origin, double scale);

}
