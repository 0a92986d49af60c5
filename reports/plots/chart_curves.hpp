// Curves that distributions store, as plots.
#pragma once

#include "reports/plots/plot.hpp"
#include "results/pictures/curve_chart.hpp"

namespace poissonlab {

/// The plot of a chart: its vertical axis ends at the ticks around all curves, and several curves have a key.
Plot chart_plot(const CurveChart& chart);

}
