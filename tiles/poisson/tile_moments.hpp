// Moments of the points of tiles, in whole numbers, and what follows for the power of tilings at low frequencies.
//
// Gabrielli, Joyce, Torquato, Tilings of space and superhomogeneous point processes, Phys. Rev. E 77, 031125, 2008:
// where all tiles have the same moments up to an order m, the spectrum of every tiling falls off as the power 2 (m + 1)
// of the frequency, between the peaks of the tiles' lattice. docs/chain-tiles.md has the theorem and its proof. Nothing
// is taken from parameters but the kind of tiles: moments are those of the points that are there.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The exponents of x, y and z.
using Monomial = std::array<std::uint8_t, 3>;

/// The order of a monomial: the sum of its exponents.
constexpr std::uint32_t order_of(const Monomial& m) { return std::uint32_t{m[0]} + m[1] + m[2]; }

/// All monomials of the orders from 1 on, those of lower order first.
std::vector<Monomial> monomials_up_to(std::uint32_t order, int dimension);

/// The value of a monomial. Numbers must be small enough: coordinates of 17 bits up to order 3.
std::int64_t value_of(const Monomial& monomial, const std::array<std::int64_t, 3>& at);

/// A point's coordinates as they are stored, relative to the middle of its tile: -32,768 to 32,767.
std::array<std::int64_t, 3> from_middle(std::span<const std::uint16_t> stored);

/// The sums over a tile's points of these monomials, in stored coordinates from the middle of the tile. A sum of 4,096
/// numbers below 2^45 fits into 64 bits.
std::vector<std::int64_t> moments_of(const PoissonTileSet& set, std::uint32_t tile,
                                     const std::vector<Monomial>& monomials);

/// The moments of one order.
struct MomentOrder
{
    bool are_equal = false;        ///< in all tiles, exactly
    std::uint32_t odd_tile = 0;    ///< the first that differs from tile 0
    std::int64_t difference = 0;   ///< the largest between two tiles, in stored numbers to the power of the order
    double largest_difference = 0; ///< the largest between two tiles, in tiles to the power of the order

    /// A bound of the power that these moments alone leave between the lattice's peaks: at a frequency of k cycles a
    /// tile, at most this times k to the power of twice the order.
    double power = 0;

    bool operator==(const MomentOrder&) const = default;
};

struct TileMoments
{
    std::array<MomentOrder, max_moment_order> orders{}; ///< of order 1 and so on

    /// The largest order up to which all moments are equal.
    std::uint32_t equal_order() const;

    /// The spectrum of every tiling falls off at least with this power of the frequency, towards 0.
    std::uint32_t proven_exponent() const { return 2 * (equal_order() + 1); }

    bool operator==(const TileMoments&) const = default;
};

/// The moments of all tiles of a set, computed on all threads; they do not depend on the number of threads.
TileMoments tile_moments(const PoissonTileSet& set);

/// The moments of the points of each class; empty where points have none. Where those of all classes are equal, those
/// of all points are.
std::vector<TileMoments> class_moments(const PoissonTileSet& set);

/// Throws InputError, a sentence, unless moments agree up to the order that the parameters promise: exactly up to
/// exact_moment_order(), and beyond it to within what rounding of coordinates leaves, rounded_moment(). `whose`: put
/// before the tile.
void check_moments(const PoissonTileParameters& parameters, const TileMoments& moments, const std::string& whose = {});

/// The difference of moments of an order that rounding can explain: every point of a tile at its border, and off by one
/// stored number along an axis.
std::int64_t rounded_moment(std::uint32_t order, std::uint32_t points_per_tile);

}
