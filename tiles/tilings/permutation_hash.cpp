#include "tiles/tilings/permutation_hash.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random_words.hpp"

#include <bit>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

namespace poissonlab {

std::uint64_t cyclic_period(std::span<const std::uint32_t> values, std::uint64_t modulus)
{
    const std::size_t n = values.size();
    for (std::size_t d = 1; d < n; ++d) {
        if (n % d != 0) continue;
        bool repeats = true;
        for (std::size_t i = 0; i < n && repeats; ++i) repeats = values[i] % modulus == values[(i + d) % n] % modulus;
        if (repeats) return d;
    }
    return n;
}

HashPeriod permutation_period(std::span<const std::uint32_t> permutation, Color colors)
{
    // Each column is the same cycle of colours, shifted by P[x]; shifts by the cycle's period do not count.
    const std::uint64_t y = cyclic_period(permutation, colors);
    return {cyclic_period(permutation, y), y};
}

std::uint32_t PermutationHash::checked_size(Color colors, std::uint32_t size)
{
    if (size < colors || size > PermutationHash::max_size)
        throw InputError("permutation table of " + std::to_string(size) + " entries for " + std::to_string(colors) +
                         " colors: must have from " + std::to_string(colors) + " to " +
                         std::to_string(PermutationHash::max_size));
    return size;
}

PermutationHash::PermutationHash(Color colors, std::uint32_t size, const StreamKey& key)
    : PermutationHash(colors, random_permutation(checked_size(colors, size), key, 0))
{}

PermutationHash::PermutationHash(Color colors, std::vector<std::uint32_t> permutation)
    : colors_(colors), permutation_(std::move(permutation))
{
    const auto size = static_cast<std::uint32_t>(permutation_.size());
    if (std::has_single_bit(size)) mask_ = size - 1;
    for (int copy = 0; copy < 2; ++copy) {
        for (const std::uint32_t entry : permutation_) {
            entry_.push_back(static_cast<std::uint16_t>(entry));
            color_.push_back(static_cast<std::uint8_t>(entry % colors));
        }
    }
}

void PermutationHash::fill_row(std::int64_t x, std::int64_t step, std::int64_t y, std::span<std::uint8_t> row) const
{
    const std::uint16_t* const entry = entry_.data();
    const std::uint8_t* const color = color_.data() + reduced(y);
    if (mask_ != 0) {
        auto at = static_cast<std::uint32_t>(x);
        for (std::uint8_t& result : row) {
            result = color[entry[at & mask_]];
            at += static_cast<std::uint32_t>(step);
        }
        return;
    }
    const auto size = static_cast<std::uint32_t>(permutation_.size());
    const std::uint32_t reduced_step = reduced(step);
    std::uint32_t at = reduced(x);
    for (std::uint8_t& result : row) {
        result = color[entry[at]];
        at += reduced_step;
        if (at >= size) at -= size;
    }
}

std::vector<std::uint32_t> PermutationHash::device_words() const
{
    std::vector<std::uint32_t> words{permutation_hash_tag, colors_, static_cast<std::uint32_t>(permutation_.size())};
    words.insert(words.end(), permutation_.begin(), permutation_.end());
    return words;
}

std::vector<std::uint32_t> random_permutation(std::uint32_t size, const StreamKey& key, std::uint32_t table)
{
    std::vector<std::uint32_t> permutation(size);
    std::iota(permutation.begin(), permutation.end(), 0u);
    RandomWords words(key, table);
    for (std::uint32_t remaining = size; remaining > 1; --remaining)
        std::swap(permutation[remaining - 1], permutation[words.below(remaining)]);
    return permutation;
}

}
