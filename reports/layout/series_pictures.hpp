// Reads a series' stored files and draws its own pictures: points, cells, spectrum, zone plate. What is in the store is
// not drawn again.
#pragma once

#include "reports/images/picture_store.hpp"
#include "reports/layout/report_layout.hpp"

namespace poissonlab {

/// Reads radial.csv into series.curve and, where they are there, pair-correlation.csv and zone-plate.csv into
/// series.pair_correlation and series.zone_plate. Throws InputError.
void read_curves(ReportSeries& series);

/// Reads the first realization, sets series.view and, in 2D, series.cells, and writes points.png, points.svg,
/// points-thumbnail.png, and cells.svg and cells.png.
/// Throws InputError when the set is not what results.json says.
void draw_points_pictures(ReportSeries& series, PictureStore& store);

/// Reads spectrum.exr and writes spectrum.png and, for the pages, spectrum-small.png and spectrum-thumbnail.png, all
/// with the report's tone mapping; of a 3D spectrum spectrum-cube.png, spectrum-slices.png and spectrum-close-ups.png
/// as well. Nothing for a series without.
void draw_spectrum_pictures(const ReportSeries& series, PictureStore& store);

/// The frequencies along z of the slices in spectrum-slices.png; none for spectra of a few frequencies.
std::vector<int> spectrum_slices(const ReportSeries& series);

/// Writes radial-thumbnail.svg; nothing for a series without spectrum.
void write_radial_thumbnail(const ReportSeries& series, const CurveScales& scales);

/// Reads zone-plate.exr and writes zone-plate.png and zone-plate-thumbnail.png; nothing for a series without.
void draw_zone_plate_picture(const ReportSeries& series, PictureStore& store);

}
