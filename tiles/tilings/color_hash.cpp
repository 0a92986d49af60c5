#include "tiles/tilings/color_hash.hpp"

#include "base/errors/errors.hpp"

#include <stdexcept>

namespace poissonlab {

const std::vector<std::string>& hash_names()
{
    static const std::vector<std::string> names{"permutation", "long-period", "xxh64"};
    return names;
}

ColorHash make_color_hash(HashKind kind, Color colors, std::uint64_t seed, std::uint32_t stream)
{
    if (colors < 2 || colors > max_colors)
        throw InputError("colors = " + std::to_string(colors) + ": must be an integer from 2 to " +
                         std::to_string(max_colors));
    const StreamKey key = stream_key(seed, Purpose::tiling_colors, stream);
    switch (kind) {
    case HashKind::permutation:
        return PermutationHash(colors, key);
    case HashKind::long_period:
        return LongPeriodHash(colors, key);
    case HashKind::xxh64:
        return Xxh64Hash(colors, key);
    }
    throw std::logic_error("no such hash function");
}

}
