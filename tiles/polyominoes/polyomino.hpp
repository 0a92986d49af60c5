// The polyominoes that are sampled with, and the rules by which each is divided into copies of itself.
//
// Ostromoukhov, Sampling with polyominoes, 2007, names them; class notes of SIGGRAPH 2008, part II, 8.1: polyominoes as
// a source of substitution tilings. The rules are found here, as exact covers.
#pragma once

#include "base/random/random.hpp"
#include "base/word_table.hpp"

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace poissonlab {

// Exact covers: choices of rows of a matrix of zeros and ones that have exactly one 1 in each column.
//
// Knuth, Dancing links, 2000: the column with the fewest rows left is covered first. Rows are tried in random order,
// and a search that takes too many steps begins anew with another one, as most of them end soon or never.

struct CoverProblem
{
    std::uint32_t columns = 0;
    std::vector<std::vector<std::uint32_t>> rows; ///< the columns in which each row has a 1

    /// Steps (rows that are tried) after which a search begins anew, and searches after which it ends without a cover.
    std::uint64_t steps = 1'000'000;
    std::uint32_t searches = 1;
};

/// A random exact cover: the numbers of its rows, ascending. Nothing if none was found, which proves only with one
/// search that ended by itself that there is none. The attempt of the stream is the search. `on_search`, which may be
/// empty, is told of each search before it begins; what it throws ends the work.
std::optional<std::vector<std::uint32_t>> exact_cover(const CoverProblem& problem, std::uint64_t seed, Purpose purpose,
                                                      std::uint32_t realization,
                                                      const std::function<void(std::uint32_t)>& on_search = {});

/// All exact covers, each ascending, in the order of a search without chance.
std::vector<std::vector<std::uint32_t>> all_exact_covers(const CoverProblem& problem);

// Places of polyominoes on the square lattice: one of the eight symmetries of the square, then an integer translation.

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

/// The P pentomino is divided into 2 x 2 copies, the G hexomino into 9 x 9.
enum class Polyomino : std::uint32_t
{
    P,
    G
};
inline constexpr WordTable<Polyomino, 2> polyominoes{{{{Polyomino::P, "P"}, {Polyomino::G, "G"}}}};

/// The factor by which lengths grow when a polyomino is divided.
constexpr std::int64_t factor_of(Polyomino shape) { return shape == Polyomino::P ? 2 : 9; }

/// The cells of a polyomino in the pose without turn and shift.
std::span<const LatticePlace> cells_of(Polyomino shape);

/// The sum of the middles of the cells, in half cells: over twice their number it is the centroid.
LatticePlace centroid_sum(Polyomino shape);

/// A polyomino and its division into copies of itself.
struct PolyominoRule
{
    Polyomino shape{};
    std::int64_t factor = 1;    ///< k: lengths of the parent over those of its children
    std::vector<Pose> children; ///< k^2 poses in the parent that has grown by k, without turn and shift

    /// The pose of a child, in units of its own cells.
    Pose child(const Pose& parent, std::size_t number) const
    {
        return composed(Pose{factor * parent.shift, parent.turn}, children[number]);
    }
};

/// The rule of a polyomino, always the same one. The P pentomino has two: this is the one that leads to fewer
/// neighbourhoods, 53 instead of 82. `on_search`: see exact_cover().
PolyominoRule division_rule(Polyomino shape, const std::function<void(std::uint32_t)>& on_search = {});

/// A random tiling of the torus of `side` x `side` cells: poses of tiles, whose cells wrap around. Empty if none was
/// found: there is none where the number of cells is not a multiple of that of the polyomino's.
std::vector<Pose> random_torus_tiling(Polyomino shape, std::int64_t side, std::uint64_t seed,
                                      std::uint32_t realization);

}
