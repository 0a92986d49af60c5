// The tile, and the part of it, at any place of a tiling of the sphere.
#pragma once

#include "tiles/sphere/spherical_tile.hpp"

#include <vector>

namespace poissonlab {

/// Tells which tile, and which part of it, a place of the sphere belongs to.
class SphericalTiling
{
public:
    explicit SphericalTiling(const SphericalTile& tile);

    struct Found
    {
        std::uint32_t element = 0;
        std::size_t part = 0;
    };
    Found at(const UnitVector& place) const;

private:
    const SphericalTile& tile_;
    SphericalRegion whole_;
    std::vector<SphericalRegion> parts_;
    std::vector<UnitVector> inner_;     ///< of each element, a place in its tile
    std::vector<std::uint32_t> around_; ///< elements, from those whose tiles are nearest to that of element 0
};

}
