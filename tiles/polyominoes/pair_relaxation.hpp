// Relaxes a table of points that all tilings share, by the pairs of these points in tilings.
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

/// An orthogonal matrix with the entries xx, xy, yx, yy.
using Orientation = std::array<double, 4>;

inline PairVector turned(const Orientation& by, const PairVector& v)
{
    return {by[0] * v.x + by[1] * v.y, by[2] * v.x + by[3] * v.y};
}

/// Applies the inverse of an orientation.
inline PairVector turned_back(const Orientation& by, const PairVector& v)
{
    return {by[0] * v.x + by[2] * v.y, by[1] * v.x + by[3] * v.y};
}

/// Two entries of the table that have points near each other: the second one as seen from the first one's tile.
struct EntryPair
{
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::uint32_t orientation = 0; ///< the orientation of the second one's tile
    PairVector difference;         ///< the difference of the places before points move
    double weight = 0;             ///< the frequency of the pair
};

struct SharedPoints
{
    std::vector<EntryPair> pairs; ///< each pair comes once
    std::vector<Orientation> orientations;
    std::vector<double> frequencies; ///< the frequency of each entry, in the unit of weights
    double spacing = 0;              ///< the distance in the densest packing with as many points
};

// These lengths are in spacings.

inline constexpr double longest_correction = 0.5;
inline constexpr double soft_reach = 2.2; ///< the reach of forces while points are spread

/// Returns movements [entry] that spread points evenly and then push pairs apart that are too near. First, an entry of
/// the table moves by the mean force on its points, with the potential (1 - r)^4 (4 r + 1) of Wendland between all
/// pairs, r in units of soft_reach, which keeps low frequencies out as a Gaussian does (Ahmed, Ren and Wonka, Gaussian
/// blue noise, 2022). Then each pair that is too near pushes both apart, and an entry moves by the mean of its pushes,
/// heavier ones for nearer points.
std::vector<PairVector> relaxed_points(SharedPoints points);

}
