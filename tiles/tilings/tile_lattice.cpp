#include "tiles/tilings/tile_lattice.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

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

const std::vector<std::string>& hash_names()
{
    static const std::vector<std::string> names{"permutation", "long-period", "xxh64", "two-tables"};
    return names;
}

ColorHash make_color_hash(const HashChoice& choice, Color colors, std::uint64_t seed, std::uint32_t stream)
{
    if (colors < 2 || colors > max_colors)
        throw InputError("colors = " + std::to_string(colors) + ": must be an integer from 2 to " +
                         std::to_string(max_colors));
    const StreamKey key = stream_key(seed, Purpose::tiling_colors, stream);
    const auto& sizes = choice.entries;
    if (choice.kind != HashKind::long_period && sizes.size() > (choice.kind == HashKind::xxh64 ? 0 : 1))
        throw InputError(fmt::format("tables with {} entries: {} has {}", fmt::join(sizes, ", "),
                                     hash_names()[static_cast<std::size_t>(choice.kind)],
                                     choice.kind == HashKind::xxh64 ? "none" : "tables of one size"));
    const std::uint32_t size = sizes.empty() ? PermutationHash::default_size(colors) : sizes.front();
    switch (choice.kind) {
    case HashKind::permutation:
        return PermutationHash(colors, size, key);
    case HashKind::two_tables:
        return TwoTableHash(colors, size, key);
    case HashKind::long_period:
        return LongPeriodHash(colors, sizes.empty() ? tiling_hash_design(colors) : LongPeriodDesign{size, sizes}, key);
    case HashKind::xxh64:
        return Xxh64Hash(colors, key);
    }
    throw std::logic_error("no such hash function");
}

Period checked_period(const Period& period)
{
    for (const std::int64_t p : {period.x, period.y, period.z}) {
        if (p < 0 || p >= std::int64_t{1} << 62)
            throw InputError("period = " + std::to_string(p) +
                             ": must be an integer from 1 to 2^62 - 1, or 0 for none");
    }
    return period;
}

}
