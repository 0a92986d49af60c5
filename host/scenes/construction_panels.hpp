// The panels of a picture of the construction: which regions and points each shows.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.3 to 4.37.
#pragma once

#include "host/scenes/shown_construction.hpp"
#include "host/tile_construction/tile_construction.hpp"
#include "results/pictures/construction_scene.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace poissonlab {

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
