// The plots that have several series: curves laid over each other, errors of integrals and points in regions against
// sizes.
#pragma once

#include "reports/gallery/gallery.hpp"
#include "reports/layout/series_curves.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// Plots of all series have at most so many: more cannot be told apart, nor their legend be read.
inline constexpr std::size_t most_series_overlaid = 24;

/// Curves of all series, each where several series have one. None for too many series.
std::vector<Panel> overlay_panels(const SeriesList& series);

/// The curves of series with those of the gallery behind them, over frequencies in cycles per mean spacing. Methods of
/// the gallery are numbered on from the series.
std::vector<Panel> gallery_panels(const SeriesList& series, const std::vector<const GalleryMethod*>& gallery);

/// Errors of integrals against the number of points, one plot an integrand.
std::vector<Panel> integration_panels(const SeriesList& series);

/// Points in the regions of tiles against the points a tile; nothing or one plot.
std::vector<Panel> region_panels(const SeriesList& series);

/// The relative radius within tiles beside that of tilings against the points a tile; nothing or one plot.
std::vector<Panel> tile_radius_panels(const SeriesList& series);

}
