// HEALPix: twelve squares of equal areas that cover the sphere, by a map of constant Jacobian.
//
// Gorski et al., HEALPix: a framework for high-resolution discretization and fast analysis of data distributed on the
// sphere, The Astrophysical Journal 622, 2005. Squares 0 to 3 meet at the north pole, 4 to 7 lie on the equator, 8 to
// 11 meet at the south pole. In a square x grows to the north-east and y to the north-west. Eight of the 14 vertices
// belong to three squares, the others to four.
#pragma once

#include "tiles/polyominoes/polyomino.hpp"

#include <array>
#include <cstdint>

namespace poissonlab {

inline constexpr std::uint32_t healpix_squares = 12;

/// A place of the unit sphere, z up.
struct SpherePlace
{
    double z = 0;     ///< the cosine of the polar angle
    double away = 1;  ///< its sine: the distance from the axis, exact near the poles too
    double turns = 0; ///< the longitude over 2 pi, 0 <= turns < 1
};

/// A place of a square.
struct HealpixPlace
{
    std::uint32_t square = 0;
    double x = 0, y = 0; ///< 0 <= x, y <= 1
};

SpherePlace sphere_place(const HealpixPlace& place);

/// The inverse. A place on a border belongs to one of its squares.
HealpixPlace healpix_place(const SpherePlace& place);

using UnitVector = std::array<double, 3>;

UnitVector direction_of(const SpherePlace& place);

/// The place of a unit vector: its longitude is that of the library's arc tangent.
SpherePlace place_of_direction(const UnitVector& direction);

/// The least length on the unit sphere of a unit of length in the squares, whose sides are 1, over all places and
/// directions: the least singular value of the map, at the poles along borders of squares.
double least_healpix_stretch();

/// A square as seen from another one, across whose sides the lattice continues: `pose` moves places of that one's
/// lattice to those of the square. Its shift is in sides of squares.
struct SeenSquare
{
    std::uint32_t square = 0;
    Pose pose;

    bool operator==(const SeenSquare&) const = default;
};

/// The square that has a place which may be outside of square `from`, in a lattice of `side` units a side. A place
/// that is outside along both axes is reached across x or across y first, which differ at vertices of three squares.
SeenSquare square_around(std::uint32_t from, LatticePlace place, std::int64_t side, bool x_first);

}
