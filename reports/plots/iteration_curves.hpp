// The curves of iterative methods: relative radius and energy over iterations, alone and overlaid.
#pragma once

#include "reports/plots/gnuplot.hpp"
#include "results/run.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// What is drawn of one series.
struct IterationCurve
{
    std::size_t index = 0; ///< number of the series, for its colour
    std::string label;     ///< for the key
    int dimension = 2;
    const Iterations* stored = nullptr; ///< outlives this
};

/// The axes, the same in all plots of a report so that plots compare.
struct IterationScales
{
    std::size_t iterations = 1; ///< end of the horizontal axis; logarithmic above 100
    double max_radius = 1;
    double min_energy = 0;
    double max_energy = 1;

    bool logarithmic() const { return iterations > 100; }
};

/// Scales that show all curves. `curves` must not be empty.
IterationScales common_iteration_scales(const std::vector<IterationCurve>& curves);

/// The smallest energy that is possible (2D: hexagonal lattice, Fejes Toth 1953) or known (3D: body-centred
/// cubic lattice, Barnes and Sloane 1983): its second moment per dimension, times the dimension.
double least_energy(int dimension);

/// The plots of one series: the mean over its realizations in a band from the least to the largest.
GnuplotPicture plot_relative_radius(const IterationCurve& curve, const IterationScales& scales,
                                    const std::filesystem::path& stem);
GnuplotPicture plot_energy(const IterationCurve& curve, const IterationScales& scales,
                           const std::filesystem::path& stem);

/// The means of all series in one plot, with a key.
GnuplotPicture overlay_relative_radius(const std::vector<IterationCurve>& curves, const IterationScales& scales,
                                       const std::filesystem::path& stem);
GnuplotPicture overlay_energy(const std::vector<IterationCurve>& curves, const IterationScales& scales,
                              const std::filesystem::path& stem);

}
