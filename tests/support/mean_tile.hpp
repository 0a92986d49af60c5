// The transform of the mean of all tiles of a set, by its definition: tilings have it at the frequencies of their
// lattice.
#pragma once

#include "base/geometry/relative_radius.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace poissonlab {

/// |F|^2 / N at a frequency, in whole cycles a tile.
inline double power_of_mean_tile(const PoissonTileSet& set, const std::array<int, 3>& frequency)
{
    const PoissonTileParameters& p = set.parameters;
    std::complex<double> transform = 0;
    for (std::uint32_t tile = 0; tile < p.tiles; ++tile)
        for (std::uint32_t i = 0; i < p.points_per_tile; ++i) {
            const UnitPosition at = set.position(tile, i);
            double turns = 0;
            for (std::size_t k = 0; k < 3; ++k) turns += double{1} * frequency[k] * at[k] / tile_units;
            transform += std::polar(1.0, -2 * std::numbers::pi * turns);
        }
    return std::norm(transform / static_cast<double>(p.tiles)) / p.points_per_tile;
}

/// The mean power of the mean tile over frequencies from `low` up to `high`, but without 0.
inline double power_of_mean_tile(const PoissonTileSet& set, double low, double high)
{
    const int reach = static_cast<int>(high), slices = set.parameters.dimension == 3 ? reach : 0;
    double sum = 0;
    int count = 0;
    for (int z = -slices; z <= slices; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const int squared = x * x + y * y + z * z;
                if (squared == 0 || squared < low * low || squared > high * high) continue;
                sum += power_of_mean_tile(set, {x, y, z});
                ++count;
            }
    return sum / count;
}

/// The mean power of the mean tile up to a little beyond the principal frequency.
inline double power_of_mean_tile(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    return power_of_mean_tile(set, 0, 1.05 * principal_frequency(p.points_per_tile, p.dimension));
}

}
