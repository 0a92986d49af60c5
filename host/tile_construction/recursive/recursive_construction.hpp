// Recursive Wang tiles from nothing.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006. The paper's
// steps are: sets of points for edges and middles of tiles, which have the same points around corners; edges are laid
// over middles (edge_merging.hpp); the order is mended; tiles are divided, and their points become points of their
// divisions (self_similarity.cpp); the other points of these get an order.
//
// Departures: sets have somewhat more points than tiles, so that all tiles have N points; how an edge is divided is
// chance (seed), and so is all that the paper's text leaves open.
#pragma once

#include "base/geometry/torus.hpp"
#include "base/random/random.hpp"
#include "host/tile_construction/recursive/edge_merging.hpp"
#include "tiles/recursive/recursive_tile_set.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

// Relaxation dart throwing with points that are there from the beginning: the sets that recursive Wang tiles are cut
// from, all of which have the same points around the corners of tiles.

/// A point of a set in its order.
struct RankedDart
{
    TorusPoint<2> place{};
    std::uint64_t squared_distance = 0; ///< that it keeps from the points before it

    bool operator==(const RankedDart&) const = default;
};

/// A point of another set, and the rank that it has in every set.
struct ForcedDart
{
    std::uint32_t rank = 0;
    RankedDart dart;
};

/// A set of relaxation darts (radius 0.15 times 0.99 after every 1,000 failures) in order. Forced darts, by ascending
/// rank, take their rank's turn; those that come earlier keep the distance from them that they need then. No dart
/// falls nearer than a distance to the place 0, but forced ones.
std::vector<RankedDart> throw_darts_around(std::uint32_t points, const std::vector<ForcedDart>& forced,
                                           double free_distance, const StreamKey& stream);

/// The darts of a set that are nearer than a distance to the place 0, with their ranks.
std::vector<ForcedDart> darts_near_corner(const std::vector<RankedDart>& darts, double distance);

/// The tiles before they are divided: with the points of their edges' sets along their sides, without order.
std::array<std::vector<RankedPlace>, even_wang_tiles> merged_recursive_tiles(std::uint32_t points_per_tile,
                                                                             std::uint64_t seed);

/// `on_step` is told of what begins; what it throws ends the construction. On all threads; the tiles are the same for
/// any number of them.
RecursiveTileSet build_recursive_tiles(std::uint32_t points_per_tile, std::uint64_t seed,
                                       const std::function<void(const std::string& what)>& on_step = {});

// Orders of points in which every part is spread: the two that recursive Wang tiles need.

/// The first `count` of merged points: by rank, but a point waits until it is no nearer to those before it than 0.6
/// times what as many points could be apart.
std::vector<RecursivePlace> mended_order(std::vector<RankedPlace> points, std::uint32_t count);

/// For each tile the numbers of its other points, one after the other the one that is farthest from those that are
/// there: the taken ones, and those before it, of the tile and of all tiles that may lie beside it. All tiles together,
/// rank by rank; of equals the first. Every tile has as many places, of which as many are taken.
std::array<std::vector<std::uint32_t>, even_wang_tiles>
farthest_orders(const RecursivePlaces& places, const std::array<std::vector<bool>, even_wang_tiles>& taken);

// Recursive Wang tiles, their division: which tiles the sixteen cells of a tile hold, and which of their points are
// the tile's own.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006.

using TileCells = std::array<std::uint8_t, recursive_cells>;
using TileLinks = std::array<std::vector<RecursiveLink>, even_wang_tiles>;

/// The cells of all tiles. An edge of either colour becomes four, two of each colour; which is chance, and differs for
/// both colours. Inside of tiles all is chance as far as colours are even.
std::array<TileCells, even_wang_tiles> random_divisions(std::uint64_t seed);

/// The point of a cell for every point of every tile, which becomes its place. Rank by rank each tile takes the nearest
/// one that is left and keeps away from those before it, of the tile and of all that may lie beside it: 0.6 times what
/// as many points could be apart; or the one that comes nearest to that. As points move, so do those of the tiles
/// around their tiles: what is then nearer than 0.5 times that chooses again, until nothing does.
///
/// Departure: the paper's points take the nearest one.
TileLinks own_points(RecursivePlaces places, const std::array<TileCells, even_wang_tiles>& cells);

/// The places of all points in the cells of a tile, cell by cell.
std::vector<RecursivePlace> places_in_cells(const RecursivePlaces& places, const TileCells& cells);

}
