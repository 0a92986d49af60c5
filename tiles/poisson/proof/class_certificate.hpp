// The proof of the minimum distance of each pair of classes in every tiling of a tile set, in exact integers.
//
// As in tile_certificate.hpp: points of both classes whose cells have a tile in common are in the closure of that tile,
// of which there is one for each tile; all others are as far apart as the extents of the pieces leave. Each class has
// its own pieces, so that tiles must agree on the classes of the points that they share as well.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The proof for two classes, which may be the same.
struct ClassPairProof
{
    /// No two points of the classes are nearer in any tiling; squared, in squared units: the smaller of the other two.
    std::uint64_t squared_min_distance = 0;
    std::uint64_t squared_closure_distance = 0; ///< among points with a tile in common; it occurs
    std::uint64_t squared_separation = 0;       ///< a lower bound for all others

    std::uint32_t tile = 0;                  ///< the first one near which the distance that occurs is found
    std::array<UnitPosition, 2> points = {}; ///< of the first and of the second class, relative to that tile's corner

    bool operator==(const ClassPairProof&) const = default;
};

/// Proves the distance of each pair of classes, in the order of class_pair(); empty where points have no classes.
/// Throws InputError where tiles do not fit together. The result is the same for any number of threads.
std::vector<ClassPairProof> certify_classes(const PoissonTileSet& set);

/// Throws InputError, a sentence, where less is proven of a pair of classes than is asked for or stated by a set,
/// `stated` being its squared distances of all pairs.
void check_class_promises(const TileClasses& classes, const std::vector<std::uint64_t>& stated,
                          const std::vector<ClassPairProof>& proofs);

}
