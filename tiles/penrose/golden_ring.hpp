// The ring Z[z] of the tenth root of unity z = exp(i pi/5), in which all corners of Penrose tilings lie.
//
// z solves z^4 = z^3 - z^2 + z - 1, and the golden ratio is phi = z + 1/z, so that multiplications by both are sums.
#pragma once

#include "tiles/prototiles/root_ring.hpp"

#include <array>
#include <cstdint>

namespace poissonlab {

constexpr RingPlace times_phi(const RingPlace& a)
{
    const auto& [p, q, r, s] = a.c;
    return {{p + q - s, r + s, p + q, r + s - p}};
}

/// The unit vector at `tenths` tenths of a turn, 0 to 9.
constexpr RingPlace unit_vector(std::uint32_t tenths)
{
    constexpr std::array<RingPlace, 5> half{
        {{{1, 0, 0, 0}}, {{0, 1, 0, 0}}, {{0, 0, 1, 0}}, {{0, 0, 0, 1}}, {{-1, 1, -1, 1}}}};
    const RingPlace& v = half[tenths % 5];
    return tenths < 5 ? v : RingPlace{{-v.c[0], -v.c[1], -v.c[2], -v.c[3]}};
}

}
