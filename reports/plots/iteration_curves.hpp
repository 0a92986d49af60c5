// The curves of iterative methods: relative radius and energy over iterations.
#pragma once

#include "reports/plots/plot.hpp"
#include "results/run.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// The curve of one series.
struct IterationCurve
{
    std::size_t index = 0; ///< number of the series
    std::string label;
    int dimension = 2;
    const Iterations* stored = nullptr; ///< outlives this
    bool is_own_energy = false;         ///< what the method makes smaller, else what Lloyd relaxation does
};

/// The smallest energy that is possible (2D: hexagonal lattice, Fejes Toth 1953) or known (3D: body-centred
/// cubic lattice, Barnes and Sloane 1983): its second moment per dimension, times the dimension.
double least_energy(int dimension);

/// All curves, of which there must be one: the mean over realizations in a band from the least to the largest, over
/// iterations, on a logarithmic axis where there are more than 100. Dots are the mean within tiles, of tiles.
Plot relative_radius_plot(const std::vector<IterationCurve>& curves);
/// Energies of one kind.
Plot energy_plot(const std::vector<IterationCurve>& curves);

}
