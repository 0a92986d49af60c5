// A proof for every tiling of a tile set of the minimum distance, in exact integers, and of the largest empty
// circle.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.6 argue that regions keep points of
// tiles apart that cannot know of each other. This is checked here for the points that a set has, however they
// were made.
//
// The proof. Each point of a tiling belongs to the cell of the lattice in whose region it is: a corner, an
// edge, a face, or the interior of a tile. SharedPieces checks that the tiles around a cell agree on which
// variant of its piece they hold, so that the closures of the tiles are all that can be seen of a tiling
// within one tile and its border.
//
// Pairs of points whose cells belong to a common tile (are it, or on its border) are both in its closure. There is
// one closure for each tile of the set, and all distances in it are looked at.
//
// Other pairs. Along an axis, a cell belongs to the tiles at place i if it extends from i to i + 1, and to those at
// i - 1 and i if it is at i. Two cells have a common tile exactly if they have a common place along every axis. So
// cells A and B without one have an axis with A below B (or the other way round) and no common place: B is at least
// one place above A if it extends along the axis, at least two if it does not. Then their points are along this axis
// alone at least as many tiles apart as the extents of their pieces leave; the extents are those of the points of
// all variants. Interiors, which may be any two, are the narrowest: their distance from the border, twice.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/poisson/proof/class_certificate.hpp"
#include "tiles/poisson/region_counts.hpp"
#include "tiles/poisson/tile_moments.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// Two points of a closure, and the first tile that has it; relative to the tile's lower left corner.
struct NearestPair
{
    std::uint32_t tile = 0;
    std::array<UnitPosition, 2> points{};

    bool operator==(const NearestPair&) const = default;
};

struct TileCertificate
{
    std::uint32_t tiles = 0;
    std::uint32_t points_per_tile = 0;

    /// No two points of any tiling are nearer; squared, in squared units.
    std::uint64_t squared_min_distance = 0;
    double relative_radius = 0; ///< of that distance

    /// The two that it is the smaller of: among points that have a tile in common, a distance that occurs;
    /// and a lower bound for all others.
    std::uint64_t squared_closure_distance = 0;
    std::uint64_t squared_separation = 0;
    NearestPair nearest = {}; ///< the points that have the distance that occurs

    std::vector<ClassPairProof> classes; ///< of each pair of classes, by class_pair()

    TileMoments moments;                    ///< that all tiles have, which prove how fast spectra fall off
    std::vector<TileMoments> class_moments; ///< of the points of each class, for the spectra of these

    std::array<RegionCounts, 4> regions{}; ///< by the dimension of the cell: corners first, the interior last

    /// No circle (ball) that is empty in any tiling has a larger radius, in tiles: at most 0.5 percent above
    /// the largest one around a centre in a tile that holds no point of its closure. Tilings have further
    /// points.
    double largest_empty_radius = 0;
    double largest_empty_radius_in_min_distances = 0; ///< over the proven minimum distance: 1 or less is maximal

    bool operator==(const TileCertificate&) const = default;
};

/// Takes time in proportion to the number of tiles, on all threads; the result is the same for any number of
/// them. Throws InputError for parameters that check() refuses, and where tiles do not fit together: tiles
/// that should share points near a corner, an edge or a face do not, or a tile has two equal points.
TileCertificate certify(const PoissonTileSet& set);

/// "the points at (1, 2) and (3, 4) of tile 5", with coordinates in units.
std::string described(const NearestPair& pair, int dimension);

/// Throws InputError, a sentence, where the file of a set promises more than its certificate proves: by the squared
/// minimum distance that it states, by its relative radius, or by the moments that tiles should have in common. It
/// names the points that are too near.
void check_promises(const PoissonTileParameters& parameters, std::uint64_t stored_squared_distance,
                    const TileCertificate& certificate);

}
