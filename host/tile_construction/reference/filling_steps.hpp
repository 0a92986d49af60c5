// Steps that filling tori has in common with and without classes of points: plain twins of what
// kernels/common/tiles has for both.
#pragma once

#include "base/random/random.hpp"
#include "host/tile_construction/filling/tile_filling.hpp"
#include "kernels/common/tiles/tile_filling.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace poissonlab::reference {

/// The dart of a counter in the zone's box.
inline TilePosition dart_at(const DartZone& zone, int dimension, const std::array<std::uint32_t, 4>& counter,
                            const StreamKey& stream)
{
    const auto words = philox(counter, stream);
    TilePosition position{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
        const auto offset = static_cast<std::int32_t>(std::uint64_t{words[k]} * zone.extent >> 32);
        position[k] = wrapped(zone.low + offset);
    }
    return position;
}

/// The squared distance, with lengths of at most FAR_LENGTH along each axis, so that it has 32 bits.
inline std::uint32_t squared_between(const TilePosition& a, const TilePosition& b, int dimension)
{
    std::uint32_t sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
        const std::int64_t length =
            std::min<std::int64_t>(std::abs(shortest(a[k] - b[k])), contract::tile_filling::FAR_LENGTH);
        sum += static_cast<std::uint32_t>(length * length);
    }
    return sum;
}

}
