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
    std::vector<double> eigenvalues;         ///< of these values
};

/// Bilinear elements on the nodes of a grid, whose steps are given; there are `count` + 8 nodes or more. Modes have
/// errors of some 1e-9; where many have nearly one eigenvalue, they can be combinations of these. Throws InputError
/// where none are found.
DrumModes drum_modes(const TaperGrid& grid, std::array<double, 2> step, std::size_t count);

/// Modes that extend along the whole of a long region of some `length`. The drum's own modes would be confined to where
/// it is a little wider, or bends. These are products u g: u is the drum's solution under a load of 1 everywhere, and
/// the functions g have the least integrals of u^2 |grad g|^2, the first being 1 in each part of the region. They are
/// the drum's modes without the potential 1 / u, which traps them (Filoche, Mayboroda, Universal mechanism for Anderson
/// and weak localization, PNAS 109(37), 2012). Eigenvalues are the integrals of the squared gradients of u g. Cells
/// must be nearly square.
DrumModes released_modes(const TaperGrid& grid, std::array<double, 2> step, std::size_t count, double length);

}
