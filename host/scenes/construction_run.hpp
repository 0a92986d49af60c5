// Constructs the Poisson tile set that a picture shows, as far as the picture needs it.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/scenes/construction_panels.hpp"

namespace poissonlab {

/// The construction goes no further than the pieces that are shown. Throws InputError for tile sets that cannot be
/// made.
Scene construct_scene(const ShownConstruction& shown, const DistributionPlace& place);

}
