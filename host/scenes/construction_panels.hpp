// The panels of a picture of the construction: which regions and points each shows.
//
// A table [[construction]] of a config asks for a picture of how a Poisson tile set, or a point set, comes into
// being.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.3 to 4.37.
#pragma once

#include "host/settings/tile_sets/tile_set_keys.hpp"
#include "host/tile_construction/tile_construction.hpp"
#include "results/pictures/construction_scene.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
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

/// Axes and variant of a piece, or of a tile.
using PieceKey = std::pair<std::uint8_t, std::uint32_t>;

/// A torus that a piece was taken from, or that the interior of a tile was made on.
struct MadePiece
{
    std::array<std::int8_t, 3> base{}; ///< of its cell on the torus
    std::vector<PlacedPiece> held;
    FillProblem problem;
    FilledTorus filled;
};

/// The parts of a constructed tile set that pictures need.
struct MadeTiles
{
    std::map<PieceKey, MadePiece> pieces;
    PoissonTileSet set; ///< for tilings only
};

/// The pieces and tiles that a picture shows. Tilings need the whole set instead.
std::vector<PieceKey> wanted_pieces(const ShownConstruction& config);

Scene make_scene(const ShownConstruction& config, const MadeTiles& made);

// The steps in which methods make a point set: a panel a step.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 4.2.4: dart throwing, relaxation dart throwing and
// Lloyd's method.

/// The steps of a config of a set. Points of a panel: `held`, there already; `inner`, what the step is about: the new
/// point, the one that refuses a dart, or all that move; `outer`, a dart that is refused.
///
/// Dart throwing throws the darts that relaxation dart throwing throws, at a radius that stays, until it has its points
/// or 10,000 darts fail in a row: plain, one after the other. Of the darts that fail between two points, the first two
/// have a panel. Positions are rounded down to units of a tile.
Scene set_scene(const ShownConstruction& config);

}
