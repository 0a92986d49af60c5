// The curves of a report: radially averaged power and anisotropy over frequency, alone and overlaid.
#pragma once

#include "analysis/spectra/radial_statistics.hpp"
#include "reports/plots/gnuplot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// What is drawn of one series.
struct Curve
{
    std::size_t index = 0; ///< number of the series, for its colour
    std::string label;
    std::size_t points = 0; ///< N
    int dimension = 2;
    std::vector<RadialBin> bins;
    double background_db = 0;                  ///< anisotropy of white noise, -10 log10 K
    int realizations = 0;                      ///< K
    std::optional<double> principal_frequency; ///< 1 / minimum distance
    double max_frequency = 0;                  ///< end of the axis
};

/// The vertical axes, the same in all plots of a report so that plots compare.
struct CurveScales
{
    double max_power = 2;
    double min_db = -15;
    double max_db = 10;
};

/// Scales that show all curves; power up to 5 and anisotropy up to 30 dB, so that the single peaks of a
/// regular grid do not flatten everything else.
CurveScales common_scales(const std::vector<Curve>& curves);

/// The plots of a series. Along the top, frequencies in units of its principal frequency.
GnuplotPicture plot_radial_power(const Curve& curve, const CurveScales& scales, const std::filesystem::path& stem);
GnuplotPicture plot_anisotropy(const Curve& curve, const CurveScales& scales, const std::filesystem::path& stem);

/// Whether the sets of some series are larger than those of others by more than a tenth, or of another
/// dimension. Their frequencies then compare in cycles per mean spacing of the points, N^(-1/dimension).
bool sizes_differ(const std::vector<Curve>& curves);

/// The label of a key where sizes differ: with the number of points, unless it says that already.
std::string label_with_points(const std::string& label, std::size_t points);

/// The label without "N = 16,384" and the comma beside it, where it says that.
std::string label_without_points(const std::string& label, std::size_t points);

/// All series in one plot, with a key. Where sizes differ, frequencies are in cycles per mean spacing and the
/// key says how many points each series has.
GnuplotPicture overlay_radial_power(const std::vector<Curve>& curves, const CurveScales& scales,
                                    const std::filesystem::path& stem);
GnuplotPicture overlay_anisotropy(const std::vector<Curve>& curves, const CurveScales& scales,
                                  const std::filesystem::path& stem);

/// The curves that reach their principal frequency; frequencies of each are in units of its own.
std::vector<Curve> principal_curves(const std::vector<Curve>& curves);

/// Radially averaged power of principal_curves(), at least one.
GnuplotPicture overlay_principal_power(const std::vector<Curve>& curves, const CurveScales& scales,
                                       const std::filesystem::path& stem);

}
