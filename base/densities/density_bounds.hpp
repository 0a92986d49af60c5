// Upper bounds of a density over parts of its square, by a pyramid of largest weights.
#pragma once

#include "base/densities/density.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// A place in the square of a density, whose sides have 2^32 units here.
using DensityPlace = std::array<std::uint32_t, 2>;

/// The weights of a density's pixels, then the largest of each 2 x 2 of them, and so on until one is left. Sides are
/// halved and rounded up.
struct DensityBounds
{
    /// The density that has full weight everywhere.
    DensityBounds() : weights{full_weight} {}
    explicit DensityBounds(const Density& density);

    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t levels = 1;
    std::vector<std::uint64_t> weights; ///< level by level, row by row

    /// The weight of the pixel at a place.
    std::uint64_t at(const DensityPlace& place) const;

    /// An upper bound of the weights between two corners, both inclusive: the largest of at most 2 x 2 places of the
    /// pyramid that cover these pixels.
    std::uint64_t over(const DensityPlace& low, const DensityPlace& high) const;

private:
    std::size_t column(std::uint32_t x) const { return static_cast<std::size_t>(std::uint64_t{x} * width >> 32); }
    std::size_t row(std::uint32_t y) const { return static_cast<std::size_t>(std::uint64_t{y} * height >> 32); }
};

}
