// The search for the best self-similar tiles of N points.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 4.7.2.2: balanced starts, as many points in each
// quarter, by relative radius. It took 8 minutes for 16 points and three and a half days for 20; here symmetric ones
// (rotations of both words together, mirror images, both coordinates exchanged) are looked at once.
#pragma once

#include "host/device/device.hpp"
#include "host/distribution/self_similar_tile.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

struct FoundStarts
{
    SelfSimilarStarts starts;  ///< the least of all that are symmetric to it
    std::uint64_t squared = 0; ///< least distance

    bool operator==(const FoundStarts&) const = default;
};

/// The least of all starts whose tiles are symmetric to that of these.
SelfSimilarStarts least_symmetric(const SelfSimilarStarts& starts, std::uint32_t points);

/// Told how much of a search is done, from 0 to 1; may throw.
using SearchListener = std::function<void(double done)>;

namespace reference {
/// Pairs all starts, without regard to symmetry.
std::vector<FoundStarts> search_self_similar(std::uint32_t points, double least_radius);
}

/// All tiles of `points` points, a multiple of 4 from 8 to 24, with at least this relative radius, the best first,
/// those of one radius in the order of their starts. By kernels/self_similar.cl. Throws InputError where more than a
/// million are found.
std::vector<FoundStarts> search_self_similar(Device& device, std::uint32_t points, double least_radius,
                                             const SearchListener& on_progress = {}, std::size_t work_group_size = 0);

/// The memory of a search.
DeviceMemory self_similar_memory(std::uint32_t points);

/// Both engines hand the pairs that they found to this: it keeps the least of symmetric ones, decides by integers,
/// sorts.
std::vector<FoundStarts> sorted_starts(std::vector<SelfSimilarStarts> found, std::uint32_t points, double least_radius);

/// The share of starts whose sequence is balanced, of all of so many bits: the share of words of which half are ones,
/// 1/2 3/4 5/6 ... for an even number.
double balanced_share(std::uint32_t bits);

/// All words of this many bits of which half are ones.
std::vector<std::uint32_t> balanced_words(std::uint32_t bits);

}
