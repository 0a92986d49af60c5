// The table [[construction]] of a config: pictures of how Poisson tile sets, and point sets, come into being.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.3 to 4.37.
#pragma once

#include "host/config/config_tree.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

struct ConstructionConfig
{
    PoissonTileParameters parameters;
    std::string show;          ///< one of construction_shows()
    std::uint8_t axes = 0;     ///< of the pieces that are shown; all: tiles
    std::uint32_t variant = 0; ///< stages: which piece or tile
    std::uint32_t count = 0;   ///< lists: how many pieces or tiles
    bool modified = true;      ///< 3D regions
    TileWindow window;         ///< tilings
    std::string label;         ///< never empty
    SourceLocation where;

    /// The stages of one piece or tile: panels with letters.
    bool is_stage() const;

    /// Several pieces or tiles.
    bool is_list() const;

    /// "tiling" or "points".
    bool is_tiling() const { return show == "tiling" || show == "points"; }

    /// No tiles: how a method makes a point set. Its points are those `per tile`.
    bool is_set() const;

    /// "set", or kind_name() of the tiles.
    std::string kind() const;
};

/// The pictures that can be shown of tiles of a kind (kind_name()), the default first.
const std::vector<std::string>& construction_shows(const std::string& kind);

/// Throws InputError with the place of what is wrong. `seed`: of the config, for tables without one.
std::vector<ConstructionConfig> read_constructions(const ConfigTable& config, std::uint64_t seed);

}
