// The classic figure of a series for whoever shows it elsewhere: points, spectrum, radial power, anisotropy.
#pragma once

#include "results/run.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// One of the pictures of a figure, as a page would show it.
struct FigurePicture
{
    std::string title;
    std::string caption;
    std::string type;  ///< "image/svg+xml" or "image/png"
    std::string bytes; ///< the file's
};

/// Draws the figure of a stored series from the files of its run: points, and, where it has a spectrum, the other
/// three. Axes are those of this series alone. Throws InputError where files are not what results.json says,
/// StorageError where gnuplot is missing.
std::vector<FigurePicture> draw_series_figure(const Run& run, std::size_t index);

}
