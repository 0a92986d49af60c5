// Bringing back the distances of all pairs of classes after points were moved, as a filler of tori that
// strip_mending.hpp knows.
//
// Points have their class as their third coordinate. Points that are there are pushed apart, and given the moments of
// their class, on the host's threads; those that are thrown anew come from a filler of classes. A torus that keeps all
// distances has the largest squared distance that there is, and others 0, as a single distance does not say it.
#pragma once

#include "host/tile_construction/classes/class_filling.hpp"

#include <memory>

namespace poissonlab {

/// The result is the same for any number of threads.
std::unique_ptr<TileFiller> make_class_mender(const PoissonTileParameters& parameters, ClassTileFiller& filler);

}
