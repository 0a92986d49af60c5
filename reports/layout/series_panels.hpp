// The pictures of a series: points, spectrum, curves, cells, zone plate.
#pragma once

#include "reports/layout/series_curves.hpp"

#include <optional>
#include <vector>

namespace poissonlab {

/// The plots of all series of a run, over absolute frequencies; the plot of each series is cut out of these, so that
/// its axes compare with those of the others.
struct RunPlots
{
    Plot power, structure, anisotropy, pairs, variance;
    std::optional<Plot> radius, energy, own_energy, plate; ///< where a series has these curves
};

RunPlots run_plots(const ReportRun& run);

/// The pictures of series number `index`, in the order of the page. Reads the first realization. Throws InputError when
/// the set is not what results.json says.
std::vector<Panel> series_panels(const ReportRun& run, std::size_t index, const RunPlots& plots);

/// The parts of these, each for what a series has.
void add_spectrum_panel(const ReportSeries& series, std::vector<Panel>& panels);
void add_autocorrelation_panel(const ReportSeries& series, std::vector<Panel>& panels);
void add_folded_density_panel(const ReportSeries& series, std::vector<Panel>& panels);
void add_region_panels(const ReportSeries& series, std::size_t index, std::vector<Panel>& panels);
void add_space_panels(const ReportSeries& series, std::vector<Panel>& panels);
void add_curve_panels(const ReportSeries& series, std::size_t index, const RunPlots& plots, std::vector<Panel>& panels);
void add_iteration_panels(const ReportSeries& series, std::size_t index, const RunPlots& plots,
                          std::vector<Panel>& panels);
void add_zone_plate_panels(const ReportRun& run, std::size_t index, const RunPlots& plots, std::vector<Panel>& panels);

/// The first set in its region.
Panel region_points_panel(const ReportSeries& series);

/// The displacements along each axis up to which the autocorrelation of so many points is shown: 16 mean spacings.
double autocorrelation_reach(std::size_t points);

/// " (first of 10 realizations)" where there are several.
std::string first_of_several(const ReportSeries& series);

/// The frequencies along z of the slices of a 3D spectrum; none for spectra of a few frequencies.
std::vector<int> spectrum_slices(int spectrum_size);

}
