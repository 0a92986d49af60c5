// A set of darts thrown block by block, in memory.
#pragma once

#include "host/sampling/darts/dart_blocks.hpp"
#include "host/sampling/darts/dart_request.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

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
