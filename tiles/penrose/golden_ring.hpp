// Places in the plane as exact integers: the ring Z[z] of the tenth root of unity z = exp(i pi/5), in which all corners
// of Penrose tilings lie.
//
// z solves z^4 = z^3 - z^2 + z - 1, and the golden ratio is phi = z + 1/z, so that multiplications by both are sums.
#pragma once

#include <array>
#include <cstdint>

namespace poissonlab {

/// c[0] + c[1] z + c[2] z^2 + c[3] z^3
struct RingPlace
{
    std::array<std::int64_t, 4> c{};

    bool operator==(const RingPlace&) const = default;
};

constexpr RingPlace operator+(const RingPlace& a, const RingPlace& b)
{
    return {{a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2], a.c[3] + b.c[3]}};
}

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
