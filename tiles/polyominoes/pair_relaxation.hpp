// Relaxation of a table of points that all tilings share, by the pairs that these points have in tilings.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

struct PairVector
{
    double x = 0;
    double y = 0;

    PairVector operator-() const { return {-x, -y}; }
};

/// An orthogonal matrix: xx xy, yx yy.
using Orientation = std::array<double, 4>;

inline PairVector turned(const Orientation& by, const PairVector& v)
{
    return {by[0] * v.x + by[1] * v.y, by[2] * v.x + by[3] * v.y};
}

/// Turns back.
inline PairVector turned_back(const Orientation& by, const PairVector& v)
{
    return {by[0] * v.x + by[2] * v.y, by[1] * v.x + by[3] * v.y};
}

/// Two entries of the table that have points near each other: the second one as seen from the first one's tile.
struct EntryPair
{
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::uint32_t orientation = 0; ///< of the second one's tile
    PairVector difference;         ///< of the places where the points are before they move
    double weight = 0;             ///< how often it occurs
};

struct SharedPoints
{
    std::vector<EntryPair> pairs; ///< each from one side only
    std::vector<Orientation> orientations;
    std::vector<double> frequencies; ///< by entry, as those of pairs
    double spacing = 0;              ///< of the densest packing with as many points
};

// These lengths are in spacings.

inline constexpr double longest_correction = 0.5;
inline constexpr double soft_reach = 2.2; ///< of pairs that are pushed while points are spread

/// Movements [entry] of least energy, in which points are spread evenly, and then without pairs that are nearer than
/// they have to be. First, an entry of the table moves by the mean force on its points, with the potential
/// (1 - r)^4 (4 r + 1) of Wendland between all pairs, r in 2.5 mean spacings, which keeps low frequencies out as a
/// Gaussian does (Ahmed, Ren and Wonka, Gaussian blue noise, 2022). Then each pair that is too near pushes both apart,
/// and an entry moves by the mean of its pushes, heavier ones for nearer points.
std::vector<PairVector> relaxed_points(SharedPoints points);

}
