// The question that dart throwing answers.
#pragma once

#include "base/random/random.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "host/sampling/darts/dart_block.hpp"
#include "host/sampling/darts/dart_bricks.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace poissonlab {

struct DartThrowingRequest
{
    int dimension = 2;
    double min_distance = 0;           ///< 2 r, in (0, 1], unit lengths
    std::optional<std::size_t> points; ///< stop at so many points; empty: at saturation
    StreamKey stream{};

    /// In 2D: the points lie in this region, in its fixed-point coordinates, which must not meet around the torus:
    /// min_distance is at most 1/2. Empty: everywhere.
    std::shared_ptr<const FixedRegion> region{};

    /// In 3D: the points lie in this part of space, of which all holds that is said of `region`.
    std::shared_ptr<const FixedSpace> space{};

    /// Darts fall into these cells only; empty: into all.
    std::optional<DartBlock> block{};

    /// Darts fall into these cells only, which are all that are not outside of the region, and no block is; empty: into
    /// all.
    std::shared_ptr<const DartBricks> bricks{};

    /// No darts of later batches.
    std::uint32_t most_batches = UINT32_MAX;
};

}
