// The polyominoes that are sampled with, and the rules by which each is divided into copies of itself.
//
// Ostromoukhov, Sampling with polyominoes, 2007, names them; class notes of SIGGRAPH 2008, part II, 8.1: polyominoes as
// a source of substitution tilings. The rules are found here, as exact covers.
#pragma once

#include "base/word_table.hpp"
#include "tiles/polyominoes/exact_cover.hpp"
#include "tiles/polyominoes/pose.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

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
