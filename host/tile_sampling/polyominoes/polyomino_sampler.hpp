// The sampler "polyominoes": tori that are tiled with polyominoes, a point in each, moved by a table.
//
// Ostromoukhov, Sampling with polyominoes, 2007. The torus is tiled at random and divided: no window is cut out of a
// larger tiling, and each realization is another tiling. All points but those above a threshold are left out, so that
// sets have the number of points that is asked for. See tiles/polyominoes/polyomino_table.hpp for what is our own.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// Variants: "P", pentominoes that are divided into 4, "G", hexominoes that are divided into 81.
SamplerSpec polyomino_sampler();

}
