// The sampler "isohedral-tiles": a window of an isohedral tiling in which every tile has the same points.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II, section 7), for the
// tilings. Points that motions of one tile repeat are periodic: their power spectrum has peaks at the lattice of the
// tiling's translations, however well the points of the tile are chosen. The method is there as a negative example for
// the analysis; the papers do not have it.
#pragma once

#include "host/sampling/sampler.hpp"
#include "tiles/isohedral/isohedral_tile.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// Random points of the first tile, so that no two points of the tiling are nearer than `min_distance`, copies in any
/// tiles included: dart throwing. Fewer than `count` where 10,000 darts one after the other do not fit. Equal seeds and
/// realizations have equal points.
std::vector<PlanePoint> repeated_points(const IsohedralTile& tile, std::size_t count, double min_distance,
                                        std::uint64_t seed, std::uint32_t realization);

SamplerSpec isohedral_tile_sampler();

}
