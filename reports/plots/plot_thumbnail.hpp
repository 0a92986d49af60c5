// A plot drawn small, for tables: its curves and reference lines without a word.
#pragma once

#include "reports/plots/plot.hpp"

#include <string>

namespace poissonlab {

/// An SVG of 160 x 120; curves are black, reference lines dashed. Values beyond the vertical axis are drawn at its end.
std::string plot_thumbnail_svg(const Plot& plot);

}
