// The charts and pictures of points on a mesh that were measured.
#pragma once

#include "host/distribution/surface_spectra/mesh_set.hpp"
#include "results/pictures/curve_chart.hpp"

#include <cstddef>
#include <string>

namespace poissonlab {

/// A chart of a number of rings of frequencies, for all sets. `name` is that of the set that is measured, which has so
/// many points; `level` is a height with a dashed line.
CurveChart spectrum_chart(const MeshSpectra& spectra, const std::string& name, std::size_t points, const ChartAxis& y,
                          double level, double RadialBin::*value);

/// Adds the charts and the file of pairs of points, and the picture of their differences.
void add_pairs(const MeshSpectra& spectra, const std::string& name, DistributionFiles& files,
               DistributionResult& result);

}
