// Distances of points over the distances that they are to keep: these prove a set with distances that
// vary.
#pragma once

#include "base/geometry/torus.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

struct KeptDistances
{
    /// No pair is nearer than it is to be: by whole numbers, of all pairs.
    bool are_kept = true;

    /// For each point, the least distance of another one over what the two are to keep; infinite where there is none.
    std::vector<double> nearest;

    double least() const; ///< of all of them
};

/// All pairs of points in a quarter of the torus (positions below 2^31): they are to keep the smaller of their
/// distances, or the mean of both. `distances` in positions, from 1 to 2^31 - 1. Pairs that are too far away to be the
/// nearest ones are left out; time is O(N log(largest / least distance)) where distances are those of the points,
/// nearly.
KeptDistances kept_distances(std::span<const TorusPoint<2>> points, std::span<const std::uint32_t> distances,
                             bool is_mean);

}
