// A table [[construction]] of a config asks for a picture of how a Poisson tile set, or a point set, comes into
// being.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.3 to 4.37.
#pragma once

#include "host/settings/tile_sets/tile_set_keys.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

struct ShownConstruction
{
    AskedTileSet tiles;                ///< as the keys say it
    PoissonTileParameters parameters;  ///< what that is
    std::optional<std::uint64_t> seed; ///< none: that of the config
    std::string show;                  ///< one of construction_shows()
    std::uint8_t axes = 0;             ///< of the pieces that are shown; all: tiles
    std::uint32_t variant = 0;         ///< stages: which piece or tile
    std::uint32_t count = 0;           ///< lists: how many pieces or tiles
    bool modified = true;              ///< 3D regions
    TileWindow window{0, 0, 6, 4};     ///< tilings

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

}
