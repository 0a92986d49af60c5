// The question that dart throwing answers.
#pragma once

#include "base/random/random.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "kernels/common/darts/dart_throwing.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace poissonlab {

// A grid of level 0 cells that has only those near a region, in bricks: where a region is much longer than wide, or in
// parts far from each other, a cube of cells around it would be nearly empty.
//
// kernels/common/darts/dart_bricks.clh says how cells are numbered.

struct DartBricks
{
    int dimension = 2;
    std::vector<std::uint32_t> corners; ///< `dimension` words a brick: the coordinates of its lowest cell
    std::vector<std::uint32_t> around;  ///< the numbers of the bricks around each, itself among them, or NO_BRICK

    std::size_t count() const { return corners.size() / static_cast<std::size_t>(dimension); }
    std::size_t cells() const { return count() * contract::dart_throwing::BRICK_CELLS; }
};

/// The cells of a brick along each axis.
constexpr std::uint32_t brick_side(int dimension)
{
    return 1u << contract::dart_throwing::BRICK_BITS(static_cast<std::size_t>(dimension));
}

// A part of the torus in which darts are thrown as if there was nothing around it, and the order of its points.

/// A cube of level 0 cells of the torus, from `first` on, around the torus; as many as the torus has, or less by the
/// reach of a point on either side.
struct DartBlock
{
    std::array<std::uint32_t, 3> first{}; ///< along each axis
    std::uint32_t size = 0;               ///< cells along each axis

    bool operator==(const DartBlock&) const = default;
};

/// A point with what decides its place among all points: batch, time, position. The order of these words is that in
/// which darts fall.
template <int D>
using OrderedDart = std::array<std::uint32_t, D + 2>;

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
