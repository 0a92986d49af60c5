// The lowest vibrations of a drum on nodes of a grid: the eigenvectors of its stiffness and its mass.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

struct DrumModes
{
    std::vector<std::vector<double>> values; ///< of each mode at each node; the integrals of its square are 1
    std::vector<double> eigenvalues;         ///< in rising order
};

/// A node that is not there.
inline constexpr std::size_t no_node = static_cast<std::size_t>(-1);

/// Bilinear elements. `number` has the number of each node of a grid, `columns` in a row, or no_node where it is held;
/// those of the grid's border are. There are `count` + 8 free nodes or more. Modes have errors of some 1e-9;
/// where many have nearly one eigenvalue, they can be combinations of these. Throws InputError where none are found.
DrumModes drum_modes(std::span<const std::size_t> number, std::size_t columns, std::array<double, 2> step,
                     std::size_t count);

}
