// All plots of a report's series: of each one, and of several together.
#pragma once

#include "reports/layout/report_layout.hpp"
#include "reports/plots/gnuplot.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace poissonlab {

/// Plots of all series have at most so many: more cannot be told apart, nor their key be read.
inline constexpr std::size_t most_series_overlaid = 24;

/// Whether there are plots of all of these series.
bool overlays_are_drawn(const std::vector<ReportSeries>& series);

/// The plots of every series of a run, into its folder; the axes are the same for all of them.
std::vector<GnuplotPicture> series_plots(const std::vector<ReportSeries>& series);

/// The plots that have all of the series: curves, and errors of integrals against N.
std::vector<GnuplotPicture> overlay_plots(const std::vector<ReportSeries>& series, const std::filesystem::path& folder);

}
