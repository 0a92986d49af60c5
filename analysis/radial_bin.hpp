// Which annulus (2D) or spherical shell (3D) of radial_statistics() a frequency belongs to.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// round(|f|) from |f|^2, in integers: k^2 - k + 1/4 <= |f|^2 < k^2 + k + 1/4 never meets its ends.
inline std::int64_t radial_bin_of(std::int64_t squared)
{
    const auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(squared))); // exact below 2^52
    return squared <= root * root + root ? root : root + 1;
}

/// The bins along a row of frequencies u = 0, 1, 2, ... asked for in this order: no root for each.
class RadialBinWalk
{
public:
    /// `squared_rest`: the sum of the squares of the other components.
    explicit RadialBinWalk(std::int64_t squared_rest) : rest_(squared_rest), bin_(radial_bin_of(squared_rest)) {}

    std::size_t of(std::int64_t u)
    {
        while (rest_ + u * u > bin_ * bin_ + bin_) ++bin_;
        return static_cast<std::size_t>(bin_);
    }

private:
    std::int64_t rest_, bin_;
};

}
