// A plot drawn small, for tables: its curves and reference lines without a word.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "reports/plots/plot.hpp"

namespace poissonlab {

/// A drawing of 160 x 120; curves are black, reference lines dashed. Values beyond the vertical axis are drawn at its
/// end.
Drawing plot_thumbnail(const Plot& plot);

}
