// Pairs of bricks placed by the binary digits of pi, along a spiral of squares: a tiling that is probably nonperiodic,
// though bricks tile the plane periodically as well.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II), figure 24.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The first binary digits of pi, 11.001001..., without the point.
std::vector<bool> binary_digits_of_pi(std::size_t count);

/// The squares of a spiral around (0, 0): the first one there, the second at (1, 0), and on counterclockwise.
std::vector<std::array<int, 2>> spiral_squares(std::size_t count);

}
