// The density of points that recursive Wang tiles are to have, in points per tile of any level, as exact integers.
#pragma once

#include "base/densities/density_bounds.hpp"

#include <cstdint>
#include <optional>

namespace poissonlab {

/// A density over a square of tiles of some level, which get a number of points together, as far as chance allows.
/// Each place asks for so many points per tile, in units of 2^-32 points.
class RecursiveDensity
{
public:
    /// `side` tiles of `level` along each axis get `points` of them. Throws InputError, a line without place, where a
    /// tile of that level would get 2^31 points or more at the density's largest weight.
    RecursiveDensity(std::uint64_t points, std::uint64_t side, int level, const std::optional<Density>& density);

    bool is_uniform() const { return is_uniform_; }

    /// The points per tile of a level where the weight is so large; 2^63 where they are more.
    std::uint64_t demand(std::uint64_t weight, int level) const
    {
        const auto at_level = static_cast<std::uint64_t>(static_cast<Wide>(weight) * most_ >> 40);
        if (level >= level_) return 4 * (level - level_) < 64 ? at_level >> 4 * (level - level_) : 0;
        const int up = 4 * (level_ - level);
        return up >= 63 || at_level > limit >> up ? (at_level == 0 ? 0 : limit) : at_level << up;
    }

    /// The points per tile of its own level at full weight, in units of 2^-32.
    std::uint64_t most() const { return most_; }

    /// Weights by place in the square.
    const DensityBounds& bounds() const { return bounds_; }

private:
    __extension__ using Wide = unsigned __int128;
    static constexpr std::uint64_t limit = std::uint64_t{1} << 63;

    int level_;
    bool is_uniform_;
    DensityBounds bounds_;
    std::uint64_t most_ = 0; ///< at full weight
};

}
