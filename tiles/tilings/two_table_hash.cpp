#include "tiles/tilings/two_table_hash.hpp"

#include "tiles/tilings/permutation_hash.hpp"
#include "tiles/tilings/random_permutation.hpp"

namespace poissonlab {

TwoTableHash::TwoTableHash(Color colors, std::uint32_t size, const StreamKey& key)
    : colors_(colors), size_(PermutationHash::checked_size(colors, size))
{
    for (std::uint32_t axis = 0; axis < 3; ++axis) tables_[axis] = random_permutation(size, key, axis);
}

HashPeriod TwoTableHash::period() const
{
    // The other table takes all values t, so that entries e and f are told apart unless (e + t) % N % C is (f + t) % N
    // % C for all t: they are equal modulo C where C divides N, and equal otherwise.
    const auto size = static_cast<std::uint32_t>(size_);
    const std::uint64_t modulus = size % colors_ == 0 ? colors_ : size;
    return {cyclic_period(tables_[0], modulus), cyclic_period(tables_[1], modulus)};
}

void TwoTableHash::fill_row(std::int64_t x, std::int64_t step, std::int64_t y, std::span<std::uint8_t> row) const
{
    const std::uint32_t along_y = entry(1, y);
    const std::int64_t along = reduced(step);
    std::int64_t at = reduced(x);
    for (std::uint8_t& result : row) {
        result = static_cast<std::uint8_t>(color(tables_[0][static_cast<std::size_t>(at)] + along_y));
        at = (at + along) % size_;
    }
}

std::vector<std::uint32_t> TwoTableHash::device_words() const
{
    std::vector<std::uint32_t> words{two_table_hash_tag, colors_, static_cast<std::uint32_t>(size_)};
    for (const auto& table : tables_) words.insert(words.end(), table.begin(), table.end());
    return words;
}

}
