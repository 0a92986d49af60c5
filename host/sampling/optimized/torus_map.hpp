// Numbers on a grid of the torus, and their blur by Gaussians: made by additions and multiplications alone, in a fixed
// order, so that they are the same on every machine.
#pragma once

#include "base/gaussian_taps.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// `size` times `size` numbers, row by row; each is that of the middle of its cell.
struct TorusMap
{
    std::size_t size = 0;
    std::vector<double> values;

    double at(std::size_t column, std::size_t row) const { return values[row * size + column]; }

    /// The number at a place, linear between middles of cells; 0 <= x, y < 1.
    double between(double x, double y) const;
};

/// The map convolved with a Gaussian of this standard deviation, in cells, which is cut off at six of them; at most a
/// sixth of the map's size.
TorusMap blurred(const TorusMap& map, double sigma);

/// The map with half as many cells along each axis: means of 2 x 2. The size is even.
TorusMap halved(const TorusMap& map);

/// The derivatives along x and along y, for a torus whose side is 1, by differences of fourth order.
TorusMap slope_along_x(const TorusMap& map);
TorusMap slope_along_y(const TorusMap& map);

}
