// Places in the plane as exact integers: the ring Z[z] of a root of unity z = exp(2 pi i/n), n = 8, 10 or 12, in which
// the corners of most tilings lie whose tiles have finitely many directions.
//
// All three rings have numbers of four integers. n = 12 has squares, triangles and hexagons, and with them the square
// and the triangular lattice; n = 10 has the golden ratio, n = 8 the root of two.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// c[0] + c[1] z + c[2] z^2 + c[3] z^3
struct RingPlace
{
    std::array<std::int64_t, 4> c{};

    bool operator==(const RingPlace&) const = default;
    auto operator<=>(const RingPlace&) const = default;
};

constexpr RingPlace operator+(const RingPlace& a, const RingPlace& b)
{
    return {{a.c[0] + b.c[0], a.c[1] + b.c[1], a.c[2] + b.c[2], a.c[3] + b.c[3]}};
}

constexpr RingPlace operator-(const RingPlace& a) { return {{-a.c[0], -a.c[1], -a.c[2], -a.c[3]}}; }
constexpr RingPlace operator-(const RingPlace& a, const RingPlace& b) { return a + -b; }

struct RingPlaceHash
{
    std::size_t operator()(const RingPlace& place) const;
};

class RootRing;

/// A linear map of the ring that commutes with turns by twice the smallest angle: x + y z goes to x of_one + y of_root,
/// where x and y have even powers of z only. Multiplication by m maps 1 to m and z to z m.
struct RingMap
{
    RingPlace of_one{{1, 0, 0, 0}}, of_root{{0, 1, 0, 0}};
};

/// Returns the image of a place. Throws InputError if an integer needs more than 64 bits.
RingPlace mapped(const RootRing& ring, const RingMap& map, const RingPlace& place);

class RootRing
{
public:
    /// `order` is n: 8, 10 or 12.
    explicit RootRing(int order = 12);

    int order() const { return order_; }

    /// z to the power of `steps`, which may be negative: the unit vector at this many n-ths of a turn.
    RingPlace unit(int steps) const;

    /// Throws InputError where an integer of the product needs more than 64 bits.
    RingPlace times(const RingPlace& a, const RingPlace& b) const;

    /// The mirror image in the real axis.
    RingPlace conjugate(const RingPlace& a) const;

    bool is_real(const RingPlace& a) const { return conjugate(a) == a; }

    /// Returns x and y, which are computed by square roots alone, so that all machines agree. `lengths` are those of
    /// the even and the odd powers of z.
    std::array<double, 2> value(const RingPlace& a, const std::array<double, 2>& lengths = {1, 1}) const;

    /// The absolute values in the plane and in the ring's other plane, where z is another root of unity. An integer of
    /// the number is never larger than twice the larger of the two.
    std::array<double, 2> sizes(const RingPlace& a) const;

private:
    int order_;
    std::array<std::array<double, 2>, 4> powers_{}; ///< of z, in the plane
    std::array<std::array<double, 2>, 4> others_{}; ///< in the other plane
};

}
