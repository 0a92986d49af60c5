// The evenness of tilings with ranked tiles at lower densities.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <vector>

namespace poissonlab {

/// Tilings of which a part of the points is kept.
struct PrefixQuality
{
    double density = 0;         ///< the part that is asked for
    double power = 0;           ///< mean below half the principal frequency of as many points
    double random_power = 0;    ///< what a random order would leave there: 1 - f + f times the power of all points
    double relative_radius = 0; ///< the smallest one, of as many points
};

/// Measures a quarter, a half and three quarters of the ranks, each by four toroidal tilings of which some 4,000 points
/// (in 3D, 16,000) are kept.
std::vector<PrefixQuality> prefix_qualities(const PoissonTileSet& set);

}
