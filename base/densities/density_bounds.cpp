#include "base/densities/density_bounds.hpp"

#include <algorithm>

namespace poissonlab {

DensityBounds::DensityBounds(const Density& density)
    : width(static_cast<std::uint32_t>(density.width)), height(static_cast<std::uint32_t>(density.height)),
      weights(density.weights)
{
    std::size_t begin = 0, columns = width, rows = height;
    while (columns > 1 || rows > 1) {
        const std::size_t next = weights.size(), half = (columns + 1) / 2;
        weights.resize(next + half * ((rows + 1) / 2));
        for (std::size_t j = 0; j < rows; ++j)
            for (std::size_t i = 0; i < columns; ++i) {
                std::uint64_t& largest = weights[next + j / 2 * half + i / 2];
                largest = std::max(largest, weights[begin + j * columns + i]);
            }
        begin = next;
        columns = half;
        rows = (rows + 1) / 2;
        ++levels;
    }
}

std::uint64_t DensityBounds::at(const DensityPlace& place) const
{
    return weights[row(place[1]) * width + column(place[0])];
}

std::uint64_t DensityBounds::over(const DensityPlace& low, const DensityPlace& high) const
{
    std::size_t left = column(low[0]), right = column(high[0]), bottom = row(low[1]), top = row(high[1]);
    std::size_t begin = 0, columns = width, rows = height;
    while (right - left > 1 || top - bottom > 1) {
        begin += columns * rows;
        columns = (columns + 1) / 2;
        rows = (rows + 1) / 2;
        left /= 2, right /= 2, bottom /= 2, top /= 2;
    }
    const auto weight = [&](std::size_t i, std::size_t j) { return weights[begin + j * columns + i]; };
    return std::max({weight(left, bottom), weight(right, bottom), weight(left, top), weight(right, top)});
}

}
