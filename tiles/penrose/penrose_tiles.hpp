// Penrose tilings that are subdivided again and again, with a Fibonacci code for each of their points.
//
// Ostromoukhov, Donohue and Jodoin, Fast hierarchical importance sampling with blue noise properties, SIGGRAPH 2004;
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.8. The triangles are halves of Robinson's kites and
// darts. Tiles are triangles, which are divided, and points, which stay and change their kind from level to level.
// Corners are exact.
#pragma once

#include "tiles/prototiles/root_ring.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace poissonlab {

// The ring Z[z] of the tenth root of unity z = exp(i pi/5), in which all corners of Penrose tilings lie.
//
// z solves z^4 = z^3 - z^2 + z - 1, and the golden ratio is phi = z + 1/z, so that multiplications by both are sums.

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

/// The kinds of tiles. Thin triangles have an angle of 72 degrees at their corner p1, fat ones of 36 degrees. Both come
/// as mirror images, which are divided differently.
enum class PenroseKind : std::uint8_t
{
    point,     ///< A
    old_point, ///< B: one level later
    thin,      ///< C
    thin_twin, ///< D
    fat,       ///< E
    fat_twin   ///< F
};

/// A tile. Lengths are in units of its level's scale, which shrinks by the golden ratio from level to level.
struct PenroseTile
{
    RingPlace p1;            ///< corner, or the point
    std::uint64_t value = 0; ///< of the code, without two ones side by side, in Fibonacci numbers
    PenroseKind kind = PenroseKind::fat_twin;
    std::uint8_t direction = 0; ///< of the first side, or of the point's frame, in twentieths of a turn: 0 to 19
    std::uint8_t digits = 0;    ///< the last three pairs of the code: 0, 1 or 2 each, the newest in the lowest two bits
    std::uint8_t level = 0;

    bool operator==(const PenroseTile&) const = default;
};

inline bool is_point(const PenroseTile& tile) { return tile.kind <= PenroseKind::old_point; }

/// The corners of a triangle, in units of its own level.
std::array<RingPlace, 3> corners_of(const PenroseTile& triangle);

/// The tiles that a tile is divided into, a level deeper: points before triangles.
struct PenroseChildren
{
    std::array<PenroseTile, 4> tiles;
    std::size_t count = 0;

    const PenroseTile* begin() const { return tiles.data(); }
    const PenroseTile* end() const { return tiles.data() + count; }
};
PenroseChildren divided(const PenroseTile& tile);

/// F_n, with F_1 = F_2 = 1; n at most 93.
std::uint64_t fibonacci(int n);

/// The pairs of digits that decide how a point moves: 0 to 20.
inline constexpr int structural_indices = 21;
int structural_index(std::uint8_t digits);

}
