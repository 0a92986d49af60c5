// The letters (a) to (f) below the panels of a drawing, as lines: drawings have no text.
#pragma once

#include "reports/drawings/drawing.hpp"

#include <cstddef>

namespace poissonlab {

/// As many panels as have letters.
inline constexpr std::size_t most_panel_letters = 6;

/// Units that a label is high.
inline constexpr double panel_label_height = 16;

/// Appends "(a)" for panel 0, and so on, centred around `middle`. Nothing for panels beyond the last letter.
void add_panel_label(std::vector<Shape>& shapes, std::size_t panel, const DrawingPoint& middle);

}
