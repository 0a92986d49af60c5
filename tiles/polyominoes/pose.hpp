// Places of polyominoes on the square lattice: one of the eight symmetries of the square, then an integer translation.
#pragma once

#include <compare>
#include <cstdint>

namespace poissonlab {

/// A place of the plane, or a step, in units of whatever it is used with.
struct LatticePlace
{
    std::int64_t x = 0;
    std::int64_t y = 0;

    auto operator<=>(const LatticePlace&) const = default;
};

inline LatticePlace operator+(const LatticePlace& a, const LatticePlace& b) { return {a.x + b.x, a.y + b.y}; }
inline LatticePlace operator-(const LatticePlace& a, const LatticePlace& b) { return {a.x - b.x, a.y - b.y}; }
inline LatticePlace operator*(std::int64_t factor, const LatticePlace& a) { return {factor * a.x, factor * a.y}; }

/// The symmetries of the square: 0 to 3 are quarter turns to the left; 4 to 7 are these after x became -x.
using Turn = std::uint8_t;
inline constexpr Turn turns = 8;

template <class Place>
Place turned(Turn turn, Place place)
{
    if (turn & 4U) place = {-place.x, place.y};
    for (unsigned quarter = turn & 3U; quarter > 0; --quarter) place = {-place.y, place.x};
    return place;
}

/// The turn that does `second` after `first`.
constexpr Turn composed(Turn second, Turn first)
{
    const unsigned quarters = (second & 4U) ? second - first : second + first; // a mirror reverses turns
    return static_cast<Turn>((quarters & 3U) | ((second ^ first) & 4U));
}

constexpr Turn inverse(Turn turn) { return (turn & 4U) ? turn : static_cast<Turn>((4U - turn) & 3U); }

/// A symmetry of the lattice: the turn about the origin comes first. Points, not cells, are what it moves: the cell
/// (x, y) is the square from (x, y) to (x + 1, y + 1).
struct Pose
{
    LatticePlace shift;
    Turn turn = 0;

    auto operator<=>(const Pose&) const = default;

    LatticePlace operator()(const LatticePlace& place) const { return turned(turn, place) + shift; }
};

inline Pose composed(const Pose& second, const Pose& first)
{
    return {second(first.shift), composed(second.turn, first.turn)};
}

inline Pose inverse(const Pose& pose)
{
    const Turn back = inverse(pose.turn);
    return {turned(back, LatticePlace{} - pose.shift), back};
}

/// The pose of `other` as seen from `pose`: composed(pose, seen_from(pose, other)) is `other`.
inline Pose seen_from(const Pose& pose, const Pose& other) { return composed(inverse(pose), other); }

/// The cell that a pose moves a cell to.
inline LatticePlace moved_cell(const Pose& pose, const LatticePlace& cell)
{
    const LatticePlace middle = turned(pose.turn, LatticePlace{2 * cell.x + 1, 2 * cell.y + 1}); // in half cells
    return LatticePlace{(middle.x - 1) / 2, (middle.y - 1) / 2} + pose.shift;
}

}
