// Recursive Wang tiles from nothing.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006. The paper's
// steps are: sets of points for edges and middles of tiles, which have the same points around corners; edges are laid
// over middles (edge_merging.hpp); the order is mended; tiles are divided, and their points become points of their
// divisions (self_similarity.hpp); the other points of these get an order (ranked_points.hpp).
//
// Departures: sets have somewhat more points than tiles, so that all tiles have N points; how an edge is divided is
// chance (seed), and so is all that the paper's text leaves open.
#pragma once

#include "host/tile_construction/recursive/edge_merging.hpp"
#include "tiles/recursive/recursive_tile_set.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// The tiles before they are divided: with the points of their edges' sets along their sides, without order.
std::array<std::vector<RankedPlace>, even_wang_tiles> merged_recursive_tiles(std::uint32_t points_per_tile,
                                                                             std::uint64_t seed);

/// `on_step` is told of what begins; what it throws ends the construction. On all threads; the tiles are the same for
/// any number of them.
RecursiveTileSet build_recursive_tiles(std::uint32_t points_per_tile, std::uint64_t seed,
                                       const std::function<void(const std::string& what)>& on_step = {});

}
