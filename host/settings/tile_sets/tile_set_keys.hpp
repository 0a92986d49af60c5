// The keys of a Poisson tile set, as the samplers of the same tiles describe their parameters.
#pragma once

#include "host/settings/keys/keys.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

/// The relative radius of classes that is reached in a second.
inline constexpr double usual_class_radius = 0.62;

/// The parameters of the points in an aperiodic monotile: how many a tile has, and what they depend on.
std::vector<ParameterSpec> monotile_parameters();

/// A tile set as it is asked for.
struct AskedTileSet
{
    PoissonTileFamily family;
    std::string monotile = {}; ///< "hat" or "spectre", instead of the family; empty: none
    Parameters values;
    std::vector<std::size_t> class_points; ///< of each class in a tile; empty: points have no classes
    std::vector<double> class_distances =
        {};                                ///< of each class, in tiles; empty: of the matrix, or of a relative radius
    std::vector<double> class_matrix = {}; ///< of all pairs, row after row; empty: Wei's

    PoissonTileParameters parameters(std::uint64_t seed) const;
};

/// Defaults, by key, that replace those of the samplers.
using TileSetDefaults = std::map<std::string, ParameterValue>;

/// Names the keys of the set's family, and checks what single values cannot show. With `has_all` also those that only
/// other families have are known, and refused by name.
void tile_set_keys(Keys& keys, AskedTileSet& set, const TileSetDefaults& defaults, bool has_all = false);

}
