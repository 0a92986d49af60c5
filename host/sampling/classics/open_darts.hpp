// Dart throwing in the open unit square, for samplers of darts on the torus: border = "open".
//
// Jones' sets are not toroidal (Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.12): nothing keeps
// points at one border away from those at the opposite one, and their spectrum has lines on the axes.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// The sampler with the parameter `border`. With "open", darts fall one by one in the square, by the host, which has
/// the law of any way of dart throwing; the set has the number of points that is asked for.
SamplerSpec with_open_border(SamplerSpec spec, Purpose purpose);

}
