// The self-similar tile: N points that are orbits under doubling, such that a copy at half the size has its points
// among those of the whole; their ranks, and points of any density by subdividing it.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 4.7.2. Coordinates are whole multiples of 1/(2^N - 1)
// on the unit torus: rotations of a word of N bits.
#pragma once

#include "host/sampling/warp/warp.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

struct RankSettings;

/// The density of ranked points: the middle of a picture or formula, by the zoom. Throws InputError.
Density rank_density(const RankSettings& settings);

/// The starts of both coordinates.
struct SelfSimilarStarts
{
    std::uint32_t x = 0;
    std::uint32_t y = 0;

    auto operator<=>(const SelfSimilarStarts&) const = default;
};

/// A point of a tile, in units of 1/(2^N - 1).
using SelfSimilarPoint = std::array<std::uint32_t, 2>;

/// The points, each after the one that doubling makes it of.
std::vector<SelfSimilarPoint> self_similar_points(const SelfSimilarStarts& starts, std::uint32_t points);

/// The squared distance of two points on the torus of side 2^N - 1.
std::uint64_t squared_torus_distance(const SelfSimilarPoint& a, const SelfSimilarPoint& b, std::uint32_t points);

/// The least of them over all pairs.
std::uint64_t squared_min_distance(const SelfSimilarStarts& starts, std::uint32_t points);

/// The relative radius of N points with this squared distance: D, equation 2.3.
double self_similar_radius(std::uint64_t squared, std::uint32_t points);

/// The points in the order of their ranks: first the one with `first`, then always the one that is farthest from those
/// before it, of several the one that comes first in the orbit.
std::vector<SelfSimilarPoint> ranked_points(const std::vector<SelfSimilarPoint>& points, std::size_t first);

/// The place of a point in a density's rectangle, in pixels, and the side of its tile.
struct SubdividedPoint
{
    double x = 0;
    double y = 0;
    double side = 0; ///< of its tile
    std::uint32_t rank = 0;
};

/// The places of points, in pixels times 2^32.
PixelPlaces places_of(const std::vector<SubdividedPoint>& points);

/// Largest weights of a density over rectangles of its pixels, by powers of two.
class MaximumPyramid
{
public:
    explicit MaximumPyramid(const Density& density);

    /// The largest weight in the columns and rows from `low` to `high`, both included. It may look at pixels beyond
    /// these, as many as there are between them on each side.
    std::uint64_t largest(const std::array<int, 2>& low, const std::array<int, 2>& high) const;

private:
    struct Level
    {
        int width = 0;
        int height = 0;
        std::vector<std::uint64_t> weights;
    };
    std::vector<Level> levels_;
};

/// Points of a ranked tile whose number in any part is about `points` times that part of the density: a tile is divided
/// into its quarters where somewhere in it the density is more than all of its points have; in others points stay whose
/// rank + 1/2 is below what the density asks for at the point. The maximum over a tile's pixels decides, so that no
/// spike between points is lost; D 4.7.2.4 looks at the points alone. Order: quarters from the south-west, south-east,
/// north-west, north-east, in each by rank.
std::vector<SubdividedPoint> subdivided_points(const std::vector<SelfSimilarPoint>& ranked, const Density& density,
                                               double points);

}
