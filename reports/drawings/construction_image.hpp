// Pictures of the construction of Poisson tiles: panels in rows, all to one scale, with letters below.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "results/pictures/construction_result.hpp"

#include <cstddef>
#include <string>

namespace poissonlab {

Drawing draw_construction(const Scene& scene);

/// "(a)" for panel 0, and so on; empty for panels beyond (z).
std::string panel_letter(std::size_t panel);

/// The place of a panel in a picture: that of its window's upper left corner, and units of the drawing a unit
/// of tiles.
struct PanelPlace
{
    DrawingPoint origin{};
    double scale = 1;
    DrawingPoint label{}; ///< the middle of its letter
};

/// The places of all panels; `size` is set to the size of the drawing.
std::vector<PanelPlace> panel_places(const Scene& scene, DrawingPoint& size);

}
