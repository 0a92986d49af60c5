// The steps in which methods make a point set: a panel a step.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 4.2.4: dart throwing, relaxation dart throwing and
// Lloyd's method.
#pragma once

#include "host/scenes/shown_construction.hpp"
#include "results/pictures/construction_scene.hpp"

namespace poissonlab {

/// The steps of a config of a set. Points of a panel: `held`, there already; `inner`, what the step is about: the new
/// point, the one that refuses a dart, or all that move; `outer`, a dart that is refused.
///
/// Dart throwing throws the darts that relaxation dart throwing throws, at a radius that stays, until it has its points
/// or 10,000 darts fail in a row: plain, one after the other. Of the darts that fail between two points, the first two
/// have a panel. Positions are rounded down to units of a tile.
Scene set_scene(const ShownConstruction& config);

}
