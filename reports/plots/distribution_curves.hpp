// Curves that distributions store, as plots.
//
// The curves of points in a region of the plane, each over the envelope of random points.
#pragma once

#include "analysis/regions/region_curve_row.hpp"
#include "reports/plots/plot.hpp"
#include "results/pictures/curve_chart.hpp"

#include <vector>

namespace poissonlab {

/// The plot of a chart: its vertical axis ends at the ticks around all curves, and several curves have a key.
Plot chart_plot(const CurveChart& chart);

/// The style in which a series' curves are drawn.
struct PlaneRegionCurves
{
    std::size_t index = 0; ///< number of the series
    const std::vector<RegionCurveRow>* rows = nullptr;
    double intensity = 0;     ///< points per square of the region's units
    bool has_formula = false; ///< whether random points have one intensity, whose formulas are drawn
    bool is_in_metres = false;
};

/// g, with its formula 1.
Plot region_pair_correlation_plot(const PlaneRegionCurves& curves);

/// L(r) - r, L the root of K / pi: 0 of random points. The line with dashes is that of Ripley's isotropic correction.
Plot region_l_plot(const PlaneRegionCurves& curves);

/// G or F, and 1 - exp(-intensity pi r^2) with dashes.
Plot region_distance_plot(const PlaneRegionCurves& curves, RegionFunction function);

/// J, with its formula 1.
Plot region_j_plot(const PlaneRegionCurves& curves);

}
