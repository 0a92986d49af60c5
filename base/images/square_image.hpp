// A square picture of grey values.
#pragma once

#include <cstddef>
#include <vector>

namespace poissonlab {

/// Grey values over the unit square. Row-major, row 0 has the lowest y; pixel (i, j) has its centre at
/// ((i + 1/2) / size, (j + 1/2) / size).
struct SquareImage
{
    int size = 0; ///< pixels along each axis
    std::vector<double> pixels;

    double at(int column, int row) const
    {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                      static_cast<std::size_t>(column)];
    }
};

}
