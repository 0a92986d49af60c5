// Relaxation dart throwing with points that are there from the beginning: the sets that recursive Wang tiles are cut
// from, all of which have the same points around the corners of tiles.
#pragma once

#include "base/geometry/torus.hpp"
#include "base/random/random.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

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

}
