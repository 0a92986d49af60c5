// The keys of a Poisson tile set, as the samplers of the same tiles describe their parameters.
#pragma once

#include "host/settings/keys/keys.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

/// A tile set as it is asked for.
struct AskedTileSet
{
    PoissonTileFamily family;
    Parameters values;

    PoissonTileParameters parameters(std::uint64_t seed) const;
};

/// Other defaults than those of the samplers, by key.
using TileSetDefaults = std::map<std::string, ParameterValue>;

/// Names the keys of the set's family, and checks what single values cannot show. With `has_all` also those that only
/// other families have are known, and refused by name.
void tile_set_keys(Keys& keys, AskedTileSet& set, const TileSetDefaults& defaults, bool has_all = false);

}
