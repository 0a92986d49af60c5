// The text from which gnuplot draws a plot.
#pragma once

#include "reports/plots/gnuplot.hpp"
#include "reports/plots/plot.hpp"

#include <filesystem>

namespace poissonlab {

/// The picture of a plot. An overlay has a key below it, a line a curve, with its letters within the picture.
GnuplotPicture gnuplot_picture(const Plot& plot, const std::filesystem::path& stem);

/// A label for a key: long ones lose their middle, and end with the curve's number, which tells them apart.
std::string key_label(const std::string& label, std::size_t number);

}
