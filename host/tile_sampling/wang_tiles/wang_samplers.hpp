// The samplers "shade-tiles" and "averaged-tiles": toroidal tilings of eight Wang tiles with points.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 6.6 and 6.7. All realizations are tilings with the
// same tiles, which the config's seed decides. Neither method promises a minimum distance of its tilings but the first.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

SamplerSpec shade_tile_sampler();
SamplerSpec averaged_tile_sampler();

}
