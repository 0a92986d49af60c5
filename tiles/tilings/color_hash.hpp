// Any of the hash functions that give lattice points their colours, chosen at run time.
#pragma once

#include "tiles/tilings/long_period_hash.hpp"
#include "tiles/tilings/permutation_hash.hpp"
#include "tiles/tilings/xxh64_hash.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace poissonlab {

enum class HashKind
{
    permutation, ///< fast, repeats after 252 to 256 points
    long_period, ///< repeats after 5,930,659,848 points, with 2, 3, 4, 6 or 8 colours
    xxh64,       ///< does not repeat
};

/// "permutation", "long-period", "xxh64": in the order of the kinds.
const std::vector<std::string>& hash_names();

using ColorHash = std::variant<PermutationHash, LongPeriodHash, Xxh64Hash>;

/// The hash function number `stream` of a seed, for this number of colours; those of different streams are
/// independent. Throws InputError for fewer than 2 colours or more than max_colors.
ColorHash make_color_hash(HashKind kind, Color colors, std::uint64_t seed, std::uint32_t stream = 0);

inline HashPeriod period_of(const ColorHash& hash)
{
    return std::visit([](const auto& h) { return h.period(); }, hash);
}

}
