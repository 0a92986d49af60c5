// The lowest vibrations of a drum on nodes of a grid: the eigenvectors of its stiffness and its mass.
#pragma once

#include "analysis/regions/taper_grid.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace poissonlab {

struct DrumModes
{
    std::vector<std::vector<double>> values; ///< of each mode at each node; the integrals of its square are 1
    std::vector<double> eigenvalues;         ///< in rising order
};

/// Bilinear elements on the nodes of a grid, whose steps are given; there are `count` + 8 nodes or more. Modes have
/// errors of some 1e-9; where many have nearly one eigenvalue, they can be combinations of these. Throws InputError
/// where none are found.
DrumModes drum_modes(const TaperGrid& grid, std::array<double, 2> step, std::size_t count);

/// Modes that live all along a long region, of some `length`: the drum's would live where it is a little wider, or
/// bends. They are u g, where u is what a load of 1 everywhere makes of the drum, and the functions g are those of the
/// least integrals of u^2 |grad g|^2, beginning with 1 in each part of the region: the drum's modes with the potential
/// 1 / u taken off, which is what traps them (Filoche, Mayboroda, Universal mechanism for Anderson and weak
/// localization, PNAS 109(37), 2012). Eigenvalues are the integrals of the squared gradient all the same. Cells are
/// nearly squares.
DrumModes released_modes(const TaperGrid& grid, std::array<double, 2> step, std::size_t count, double length);

}
