#include "tiles/prototiles/root_ring.hpp"

#include "base/errors/errors.hpp"

#include <cmath>

namespace poissonlab {
namespace {

using Pair = std::array<double, 2>;
__extension__ using Wide = __int128;

/// The powers z^4 of the three rings.
constexpr RingPlace fourth_power(int order)
{
    return order == 8 ? RingPlace{{-1, 0, 0, 0}} : order == 10 ? RingPlace{{-1, 1, -1, 1}} : RingPlace{{-1, 0, 1, 0}};
}

/// The number of these coefficients of the powers of z.
RingPlace reduced(std::array<Wide, 7> powers, int order)
{
    const RingPlace fourth = fourth_power(order);
    for (std::size_t k = 6; k >= 4; --k)
        for (std::size_t j = 0; j < 4; ++j) powers[k - 4 + j] += powers[k] * fourth.c[j];
    RingPlace result;
    for (std::size_t i = 0; i < 4; ++i) {
        result.c[i] = static_cast<std::int64_t>(powers[i]);
        if (result.c[i] != powers[i]) throw InputError("places of corners need more than 64-bit integers");
    }
    return result;
}

/// The root of unity z; `other`: the one that takes its place in the other plane, z^3, z^3 or z^5.
Pair root_of_unity(int order, bool other)
{
    if (order == 8) return {(other ? -1 : 1) * std::sqrt(0.5), std::sqrt(0.5)};
    if (order == 12) return {(other ? -1 : 1) * std::sqrt(3.0) / 2, 0.5};
    const double root = std::sqrt(5.0);
    return other ? Pair{(1 - root) / 4, std::sqrt(10 + 2 * root) / 4}
                 : Pair{(1 + root) / 4, std::sqrt(10 - 2 * root) / 4};
}

Pair product(const Pair& a, const Pair& b) { return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]}; }

std::array<Pair, 4> powers_of(const Pair& root)
{
    std::array<Pair, 4> powers{Pair{1, 0}, root, product(root, root), {}};
    powers[3] = product(powers[2], root);
    return powers;
}

Pair sum_of(const RingPlace& a, const std::array<Pair, 4>& powers, const Pair& lengths = {1, 1})
{
    Pair sum{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t axis = 0; axis < 2; ++axis)
            sum[axis] += lengths[i % 2] * static_cast<double>(a.c[i]) * powers[i][axis];
    return sum;
}

}

std::size_t RingPlaceHash::operator()(const RingPlace& place) const
{
    std::uint64_t hash = 0;
    for (const std::int64_t c : place.c) {
        hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29;
    }
    return hash;
}

RingPlace mapped(const RootRing& ring, const RingMap& map, const RingPlace& place)
{
    std::array<Wide, 7> powers{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            powers[i - i % 2 + j] += static_cast<Wide>(place.c[i]) * (i % 2 == 0 ? map.of_one : map.of_root).c[j];
    return reduced(powers, ring.order());
}

RootRing::RootRing(int order)
    : order_(order), powers_(powers_of(root_of_unity(order, false))), others_(powers_of(root_of_unity(order, true)))
{}

RingPlace RootRing::unit(int steps) const
{
    const int turned = (steps % order_ + order_) % order_;
    const int half = order_ / 2; // z^half = -1
    std::array<Wide, 7> powers{};
    powers[static_cast<std::size_t>(turned % half)] = turned < half ? 1 : -1;
    return reduced(powers, order_);
}

RingPlace RootRing::times(const RingPlace& a, const RingPlace& b) const
{
    std::array<Wide, 7> powers{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) powers[i + j] += static_cast<Wide>(a.c[i]) * b.c[j];
    return reduced(powers, order_);
}

RingPlace RootRing::conjugate(const RingPlace& a) const
{
    RingPlace sum;
    for (int i = 0; i < 4; ++i) {
        const RingPlace power = unit(-i);
        for (std::size_t j = 0; j < 4; ++j) sum.c[j] += a.c[static_cast<std::size_t>(i)] * power.c[j];
    }
    return sum;
}

std::array<double, 2> RootRing::value(const RingPlace& a, const std::array<double, 2>& lengths) const
{
    return sum_of(a, powers_, lengths);
}

std::array<double, 2> RootRing::sizes(const RingPlace& a) const
{
    const Pair here = value(a), there = sum_of(a, others_);
    return {std::hypot(here[0], here[1]), std::hypot(there[0], there[1])};
}

}
