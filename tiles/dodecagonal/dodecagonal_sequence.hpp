// A sequence of points on the vertices of a dodecagonal tiling that is divided again and again: each prefix is well
// spread over a square, or follows a density.
//
// Ostromoukhov, SIGGRAPH 2008 class notes, part IV: "2D low-discrepancy sequences based on dodecagonal tiling", whose
// slides name "Voronoi polygons-based production rules" and give none. The tiling here is Gaehler's shield tiling
// (configs/tilings/shield.toml). Its vertices are the numbers x of the ring of the 12th roots of unity z whose
// conjugate x*, where z becomes z^5, is in the dodecagon with corners at the 12 roots; one of two opposite edges
// belongs to it. 1 + z is a unit of the ring: it enlarges distances by 2 cos 15 degrees, and x* shrinks by 2 cos 75
// degrees. Therefore all vertices are vertices of the divided tiling again, 2 + sqrt(3) times as many.
//
// The Voronoi polygon of a vertex is divided among the vertex and its new ones. Each new vertex is one edge away from
// the nearest old vertices, mostly on the border of polygons; the first one by direction gets it. Polygons therefore
// have 1 to 5 parts. The new vertices of polygons come in turns, like digits of van der Corput's sequence: in the first
// of n turns each polygon with n new vertices gets one of them, in the order of the polygons' own vertices, and so on.
#pragma once

#include "base/densities/density_bounds.hpp"
#include "tiles/prototiles/root_ring.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// Says whether a number of the ring is a vertex, by whole numbers.
bool is_dodecagonal_vertex(const RingPlace& place);

/// Returns (1 + z) place: the same vertex after a division.
RingPlace enlarged_place(const RingPlace& place);

/// Returns place / (1 + z), which is in the ring as well.
RingPlace reduced_place(const RingPlace& place);

/// The turns in which a vertex with new vertices in these directions, a bit each, gets them.
struct DodecagonalTurns
{
    unsigned directions = 0;
    std::array<std::uint8_t, 4> turns{}; ///< 0 is first; in the order of directions
};

/// The turns of the smallest discrepancy that was found, for sets of directions whose turns are not by direction.
std::span<const DodecagonalTurns> best_dodecagonal_turns();

/// A vertex of a tiling after some divisions.
struct DodecagonalVertex
{
    RingPlace place;
    double phase = 0.5; ///< from 0 to 1: its rank over the density of the vertices of this tiling
};

/// Returns the parts of a vertex's polygon after a division: the vertex itself, and then its new ones by direction,
/// which is also the order of their turns if `turns` does not say them.
std::vector<DodecagonalVertex> divided_vertex(const DodecagonalVertex& vertex,
                                              std::span<const DodecagonalTurns> turns = best_dodecagonal_turns());

/// The middle of a square in the first tiling: a number of the ring whose coefficients are at most 2^24 in size, and
/// whose conjugate is small, and what is added to it, in edges.
struct DodecagonalMiddle
{
    RingPlace place;
    std::array<double, 2> shift{};
};

/// Returns the place near which there are vertices for two of the ring's coefficients, those of z and z^2.
RingPlace place_with_vertices(std::int64_t second, std::int64_t third);

struct DodecagonalPoint
{
    std::array<double, 2> place{}; ///< in the unit square
    double rank = 0; ///< the mean number of points of the unit square with at most this rank, if it is even
};

/// Makes points of one square of the tiling. The square's axes are turned by 7.5 degrees against those of the tiling,
/// which are 15 degrees apart: rows of points along its sides would have a large discrepancy.
class DodecagonalSequence
{
public:
    explicit DodecagonalSequence(const DodecagonalMiddle& middle,
                                 std::span<const DodecagonalTurns> turns = best_dodecagonal_turns());

    /// Returns the first points of the sequence: those with the least rank over weight of their place. Ranks are over
    /// weights. Throws InputError as check_dodecagonal_density().
    std::vector<DodecagonalPoint> points(std::size_t count, const DensityBounds& density = {}) const;

    static constexpr double densest = 0x1p40; ///< points per unit area

private:
    struct Found;
    void offer(const DodecagonalVertex& vertex, const std::array<double, 2>& place, std::size_t level,
               Found& found) const;
    void collect(const DodecagonalVertex& vertex, const std::array<double, 2>& place, std::size_t level,
                 Found& found) const;
    std::array<double, 2> position(const RingPlace& place, std::size_t level) const;

    /// A tiling of the sequence.
    struct Level
    {
        RingPlace middle;
        std::array<double, 2> unit; ///< what 1 is in the unit square, as a complex number
        double edge;                ///< its length
        double density;             ///< of vertices in the unit square
    };

    std::span<const DodecagonalTurns> turns_;
    std::array<double, 2> middle_; ///< the number's place to the square's middle, in the unit square
    std::vector<Level> levels_;
};

/// Throws InputError, the end of a sentence about the density, if its densest place has too many points.
void check_dodecagonal_density(std::size_t count, const DensityBounds& density);

}
