#include "host/tile_sampling/recursive/recursive_density.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

namespace poissonlab {

/// The mean weight gets points / side^2; the largest one that times pixels * full weight / sum of weights.
RecursiveDensity::RecursiveDensity(std::uint64_t points, std::uint64_t side, int level,
                                   const std::optional<Density>& density)
    : level_(level), is_uniform_(!density)
{
    Wide pixels = 1, sum = full_weight;
    if (density) {
        bounds_ = DensityBounds(*density);
        pixels = density->weights.size();
        sum = 0;
        for (const std::uint64_t weight : density->weights) sum += weight;
    }
    const Wide all = pixels * points << 40, tiles = sum * side * side;
    const Wide whole = all / tiles, part = ((all % tiles) << 32) / tiles;
    if (whole >= std::uint64_t{1} << 31)
        throw InputError(fmt::format("the densest place would get {:.3g} points per tile: must be less than 2^31",
                                     static_cast<double>(whole)));
    most_ = static_cast<std::uint64_t>((whole << 32) + part);
}

}
