// A set of darts thrown block by block, in memory.
#pragma once

#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/darts/dart_request.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

// Dart throwing of one set block by block: by any number of processes, or by one whose memory holds a block.
//
// Which darts fall into a cell is a function of the seed and the cell, and whether one becomes a point depends on the
// earlier ones in the cells around it only. So a block of cells with a halo is thrown as if nothing was around it. That
// is wrong near the end of the halo, but one dart decides about the next only so often: wrong points become fewer by a
// factor of 2 to 10 with each layer of cells.
//
// That none is in the block itself is proven, not assumed. A set of darts is the one that throwing them gives exactly
// if each dart in it has no earlier one of the set too near, and each that is not has one: by induction over the order
// of darts there is only one such set. Put together from blocks, the set has that property in each block if the layers
// around the block that a dart inside can see, as many as CellHierarchy::reach, hold the same darts of the set in the
// block's halo and in the blocks beside it. Blocks leave hashes of these layers behind (BlockMarks), and
// marks_agree() compares them. Where they do not agree, halos must be wider.

/// Layers of cells around a block that suffice nearly always: those at which the wrong points of 10^8 are expected to
/// be none in thousands of sets.
constexpr std::uint32_t usual_halo(int dimension) { return dimension == 2 ? 16 : 20; }

/// A division of the torus into blocks, equally many along each axis.
class DartBlocks
{
public:
    /// So few blocks that with their halos they have at most `most_side` cells along each axis. One, the whole torus,
    /// where it has no more, or blocks would have no room beside their halos.
    DartBlocks(const CellHierarchy& hierarchy, int dimension, std::uint32_t most_side, std::uint32_t halo);

    /// The number of blocks.
    std::uint32_t count() const;

    /// Cells that each block has with its halo along each axis.
    std::uint32_t side() const { return side_; }

    /// A block with its halo.
    DartBlock with_halo(std::uint32_t block) const;

    /// Removes the darts of the halo, of those of with_halo(block), and returns hashes of the layers within the block's
    /// border and around it, one for each neighbour and both. Darts must be in their order.
    template <int D>
    std::vector<std::uint64_t> keep_own(std::uint32_t block, std::vector<OrderedDart<D>>& darts) const;

    /// The number of hashes that keep_own() returns.
    std::size_t marks_per_block() const { return 2 * directions(); }

    /// Are the darts that blocks have kept those of the whole torus? `marks` are those of all blocks, one after
    /// another.
    bool marks_agree(const std::vector<std::uint64_t>& marks) const;

private:
    std::size_t directions() const { return dimension_ == 2 ? 9 : 27; }
    std::array<std::uint32_t, 3> place_of(std::uint32_t block) const;
    std::uint32_t begin_of(std::uint32_t place) const;
    std::uint32_t neighbour(std::uint32_t block, std::size_t direction) const;

    CellHierarchy hierarchy_;
    int dimension_;
    std::uint32_t halo_;
    std::uint32_t per_axis_ = 1; ///< blocks
    std::uint32_t side_;
};

/// ordered_darts() of either engine.
template <int D>
using ThrowBlock = std::function<std::vector<OrderedDart<D>>(const DartThrowingRequest& request)>;

/// The number of batches that have the points of the request, by what the first block has of them: nearly always
/// enough. UINT32_MAX, all batches, where the request is for saturation or those of saturation would hardly be more.
template <int D>
std::uint32_t enough_batches(const ThrowBlock<D>& throw_block, const DartThrowingRequest& whole,
                             const DartBlocks& blocks);

/// The darts of the whole torus in their order: at least as many as the request wants, unless they are saturated.
/// Blocks have up to `most_side` cells along each axis, halos included, which are made wider where that is needed.
template <int D>
std::vector<OrderedDart<D>> throw_in_blocks(const ThrowBlock<D>& throw_block, const DartThrowingRequest& whole,
                                            std::uint32_t most_side, std::uint32_t halo = usual_halo(D));

}
