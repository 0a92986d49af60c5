#include "host/sampling/darts/darts_in_blocks.hpp"

#include "base/files/xxh64_bytes.hpp"
#include "base/geometry/relative_radius.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace poissonlab {
namespace {

/// Steps along an axis to the neighbours to which a dart matters, as bits: back, none, forth.
enum Step : unsigned
{
    back = 1,
    none = 2,
    forth = 4
};

/// The steps that direction number `direction` consists of, the first axis first.
unsigned step_of(std::size_t direction, int axis)
{
    for (int k = 0; k < axis; ++k) direction /= 3;
    return 1u << direction % 3;
}

template <int D>
bool goes(std::size_t direction, const std::array<unsigned, D>& steps)
{
    for (int k = 0; k < D; ++k)
        if (!(step_of(direction, k) & steps[k])) return false;
    return true;
}

DartThrowingRequest request_for_block(const DartThrowingRequest& whole, const DartBlocks& blocks, std::uint32_t block)
{
    DartThrowingRequest request = whole;
    request.points.reset();
    request.block = blocks.with_halo(block);
    return request;
}

}

DartBlocks::DartBlocks(const CellHierarchy& hierarchy, int dimension, std::uint32_t most_side, std::uint32_t halo)
    : hierarchy_(hierarchy), dimension_(dimension), halo_(halo), side_(hierarchy.size)
{
    const auto reach = static_cast<std::uint32_t>(hierarchy.reach);
    if (most_side >= hierarchy.size || most_side < 2 * halo + 2 * reach) return;
    const std::uint32_t own = most_side - 2 * halo;
    per_axis_ = (hierarchy.size + own - 1) / own;
    side_ = (hierarchy.size + per_axis_ - 1) / per_axis_ + 2 * halo;
    if (side_ >= hierarchy.size) {
        per_axis_ = 1;
        side_ = hierarchy.size;
    }
}

std::uint32_t DartBlocks::count() const
{
    return dimension_ == 2 ? per_axis_ * per_axis_ : per_axis_ * per_axis_ * per_axis_;
}

std::array<std::uint32_t, 3> DartBlocks::place_of(std::uint32_t block) const
{
    return {block % per_axis_, block / per_axis_ % per_axis_, block / per_axis_ / per_axis_};
}

std::uint32_t DartBlocks::begin_of(std::uint32_t place) const
{
    return static_cast<std::uint32_t>(std::uint64_t{place} * hierarchy_.size / per_axis_);
}

DartBlock DartBlocks::with_halo(std::uint32_t block) const
{
    DartBlock result{{}, side_};
    if (per_axis_ == 1) return result;
    const auto place = place_of(block);
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k)
        result.first[k] = (begin_of(place[k]) + hierarchy_.size - halo_) % hierarchy_.size;
    return result;
}

template <int D>
std::vector<std::uint64_t> DartBlocks::keep_own(std::uint32_t block, std::vector<OrderedDart<D>>& darts) const
{
    if (per_axis_ == 1) return std::vector<std::uint64_t>(marks_per_block());
    const auto reach = static_cast<std::uint32_t>(hierarchy_.reach);
    const auto place = place_of(block);
    std::vector<Xxh64> hashes(marks_per_block());
    auto kept = darts.begin();
    for (const OrderedDart<D>& dart : darts) {
        // The zones of its cell: of the block, and of the layers within its border and around it.
        bool is_own = true, is_around = true;
        std::array<unsigned, D> within, around;
        for (int k = 0; k < D; ++k) {
            const std::uint32_t begin = begin_of(place[k]), own = begin_of(place[k] + 1) - begin;
            const std::uint32_t cell = (hierarchy_.cell_of(dart[k + 2]) + (hierarchy_.size - begin)) % hierarchy_.size;
            const bool is_inside = cell < own;
            is_own = is_own && is_inside;
            within[k] = none | (cell < reach ? back : 0u) | (cell + reach >= own ? forth : 0u);
            around[k] = is_inside ? none : cell < own + reach ? forth : cell >= hierarchy_.size - reach ? back : 0u;
            is_around = is_around && around[k] != 0;
        }
        const std::string_view bytes(reinterpret_cast<const char*>(dart.data()), sizeof dart);
        if (is_own && std::ranges::any_of(within, [](unsigned steps) { return steps != none; }))
            for (std::size_t d = 0; d < directions(); ++d)
                if (d != directions() / 2 && goes<D>(d, within)) hashes[d].add(bytes);
        if (!is_own && is_around)
            for (std::size_t d = 0; d < directions(); ++d)
                if (goes<D>(d, around)) hashes[directions() + d].add(bytes);
        if (is_own) *kept++ = dart;
    }
    darts.erase(kept, darts.end());
    std::vector<std::uint64_t> marks;
    for (const Xxh64& hash : hashes) marks.push_back(hash.value());
    return marks;
}

std::uint32_t DartBlocks::neighbour(std::uint32_t block, std::size_t direction) const
{
    const auto place = place_of(block);
    std::uint32_t result = 0;
    for (int k = dimension_ - 1; k >= 0; --k) {
        const unsigned step = step_of(direction, k);
        const std::uint32_t moved = place[static_cast<std::size_t>(k)] + (step == forth  ? 1
                                                                          : step == back ? per_axis_ - 1
                                                                                         : 0);
        result = result * per_axis_ + moved % per_axis_;
    }
    return result;
}

bool DartBlocks::marks_agree(const std::vector<std::uint64_t>& marks) const
{
    if (per_axis_ == 1) return true;
    for (std::uint32_t block = 0; block < count(); ++block) {
        for (std::size_t d = 0; d < directions(); ++d) {
            if (d == directions() / 2) continue;
            const std::size_t opposite = directions() - 1 - d;
            const std::uint64_t around = marks[block * marks_per_block() + directions() + d];
            if (around != marks[neighbour(block, d) * marks_per_block() + opposite]) return false;
        }
    }
    return true;
}

template std::vector<std::uint64_t> DartBlocks::keep_own<2>(std::uint32_t, std::vector<OrderedDart<2>>&) const;
template std::vector<std::uint64_t> DartBlocks::keep_own<3>(std::uint32_t, std::vector<OrderedDart<3>>&) const;

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
