// Measures in the closures of all tiles of a set: the points of a tile with all shared pieces around it.
#pragma once

#include "tiles/poisson/proof/shared_pieces.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

// The largest empty circle (ball) whose centre lies in a tile, its square (cube) or a polygon, by branch and bound.
//
// The distance to the nearest point changes by no more than the centre moves, so that a square (cube) of
// centres has an upper bound: that of the distance from any one point to the square's farthest corner.
// Squares are halved until none can hold a centre that is better than the best one found by more than the
// tolerance. Each square is given the points that can be nearest to some place in it, which soon are few.

class EmptyBallSearch
{
public:
    /// The upper bound is at most this much above the largest radius, relative.
    static constexpr double tolerance = 0.005;

    explicit EmptyBallSearch(int dimension) : dimension_(dimension) {}

    /// A radius in units, at least `known`, such that no circle around a centre in the tile has a larger one
    /// than (1 + tolerance) times it. Some circle has it, up to rounding, unless it is
    /// `known`. There must be points.
    double radius(std::span<const UnitPosition> points, double known);

    /// Finds such a radius of circles around centres in a polygon, which lies within half a tile of the tile's square.
    double radius_in(std::span<const UnitPosition> polygon, std::span<const UnitPosition> points, double known);

private:
    struct Square
    {
        std::array<double, 3> centre;
        double half;
    };

    void take(std::span<const UnitPosition> points, double known);

    /// The depth of a place in the polygon; outside of it negative.
    double depth(const std::array<double, 3>& place) const;

    template <unsigned Dimension>
    void search(const Square& square, std::size_t first, std::size_t last);

    int dimension_;
    double best_ = 0;
    std::span<const UnitPosition> polygon_;         ///< empty: all of the square
    std::vector<std::array<double, 3>> candidates_; ///< of the squares that are being searched, one after the other
};

struct ClosureMeasures
{
    std::uint64_t squared_distance = UINT64_MAX; ///< the smallest in any closure, in squared units
    NearestPair nearest;                         ///< the points that have it, of the first tile that has two
    double empty_radius = 0;                     ///< as EmptyBallSearch::radius(), of all tiles
};

/// The points of a closure, and where the tile ends if that is not its square.
struct Closure
{
    std::vector<UnitPosition> points;
    std::vector<UnitPosition> border; ///< a polygon
};

/// Makes the closure of a tile; called from several threads at once.
using ClosureSource = std::function<void(std::uint32_t tile, Closure& closure)>;

/// Runs on all threads; the result is the same for any number of them.
ClosureMeasures measure_closures(const PoissonTileParameters& parameters, const ClosureSource& closure_of);

/// A certificate with these measures and this distance of points without a common tile; without region counts.
TileCertificate certificate_of(const PoissonTileParameters& parameters, const ClosureMeasures& measures,
                               std::uint64_t squared_separation);

/// The lowest tile for which this holds, or the number of tiles. Runs on all threads.
std::uint32_t first_tile_where(std::uint32_t tiles, const std::function<bool(std::uint32_t tile)>& holds);

}
