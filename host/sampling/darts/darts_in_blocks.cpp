#include "host/sampling/darts/darts_in_blocks.hpp"

#include "base/geometry/relative_radius.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {
namespace {

DartThrowingRequest request_for_block(const DartThrowingRequest& whole, const DartBlocks& blocks, std::uint32_t block)
{
    DartThrowingRequest request = whole;
    request.points.reset();
    request.block = blocks.with_halo(block);
    return request;
}

}

template <int D>
std::uint32_t enough_batches(const ThrowBlock<D>& throw_block, const DartThrowingRequest& whole,
                             const DartBlocks& blocks)
{
    if (!whole.points || blocks.count() == 1) return UINT32_MAX;
    const auto wanted = static_cast<double>(*whole.points);
    const double saturated = std::pow(saturation_relative_radius(D) / relative_radius(whole.min_distance, 1, D), D);
    if (saturated < 1.2 * wanted) return UINT32_MAX;
    std::vector<OrderedDart<D>> darts = throw_block(request_for_block(whole, blocks, 0));
    blocks.keep_own<D>(0, darts);
    const double here = 1.01 * wanted / blocks.count(); // blocks differ by a layer
    const auto enough = static_cast<std::size_t>(here + 6 * std::sqrt(here));
    return enough < darts.size() ? darts[enough][0] + 1 : UINT32_MAX;
}

template <int D>
std::vector<OrderedDart<D>> throw_in_blocks(const ThrowBlock<D>& throw_block, const DartThrowingRequest& whole,
                                            std::uint32_t most_side, std::uint32_t halo)
{
    const CellHierarchy hierarchy = cell_hierarchy(whole.min_distance, D);
    std::uint32_t batches = enough_batches<D>(throw_block, whole, {hierarchy, D, most_side, halo});
    for (;;) {
        const DartBlocks blocks(hierarchy, D, most_side, halo);
        std::vector<OrderedDart<D>> all;
        std::vector<std::uint64_t> marks;
        for (std::uint32_t block = 0; block < blocks.count(); ++block) {
            DartThrowingRequest request = request_for_block(whole, blocks, block);
            request.most_batches = batches;
            std::vector<OrderedDart<D>> darts = throw_block(request);
            std::ranges::copy(blocks.keep_own<D>(block, darts), std::back_inserter(marks));
            all.insert(all.end(), darts.begin(), darts.end());
        }
        if (!blocks.marks_agree(marks)) {
            halo *= 2;
        } else if (batches < UINT32_MAX && all.size() < whole.points.value_or(0)) {
            batches = UINT32_MAX;
        } else {
            tbb::parallel_sort(all.begin(), all.end());
            return all;
        }
    }
}

template std::uint32_t enough_batches<2>(const ThrowBlock<2>&, const DartThrowingRequest&, const DartBlocks&);
template std::uint32_t enough_batches<3>(const ThrowBlock<3>&, const DartThrowingRequest&, const DartBlocks&);
template std::vector<OrderedDart<2>> throw_in_blocks<2>(const ThrowBlock<2>&, const DartThrowingRequest&, std::uint32_t,
                                                        std::uint32_t);
template std::vector<OrderedDart<3>> throw_in_blocks<3>(const ThrowBlock<3>&, const DartThrowingRequest&, std::uint32_t,
                                                        std::uint32_t);

}
