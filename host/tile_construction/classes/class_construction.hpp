// The construction of tiles in the plane whose points have classes: trees, bushes, stones without end.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010 (a distance for each pair of classes); Lagae, Tile-Based Methods
// in Computer Graphics, 2007, section 4.5 (corner-based tiles). The stages are those of tile_construction.hpp, corners,
// edges, interiors, with regions of the largest distance that any two classes keep: so points of tiles that cannot know
// of each other are far enough apart for all classes. Points of all classes are thrown and pushed apart together. Each
// tile has the same number of points of each class, which its interior makes up for; pieces are chosen such that what
// is left for interiors is as near as can be to what their area asks for, class by class.
#pragma once

#include "host/tile_construction/classes/class_filling.hpp"
#include "host/tile_construction/tile_construction.hpp"

namespace poissonlab {

/// Points come class after class in each tile. `options.record` is not told of anything. `joint` is needed where
/// are_relaxed_together(). Throws InputError for
/// parameters that check() refuses, and where a piece or a tile does not keep the wanted distances: which one, and what
/// part of them was reached.
ConstructedTileSet construct_class_tiles(const PoissonTileParameters& parameters, ClassTileFiller& filler,
                                         const ConstructionOptions& options = {}, JointEngine* joint = nullptr);

/// The memory that the construction takes on a device, nearly.
DeviceMemory class_construction_memory(const PoissonTileParameters& parameters);

}
