// The largest empty circle (ball) whose centre lies in a tile, its square (cube) or a polygon, by branch and bound.
//
// The distance to the nearest point changes by no more than the centre moves, so that a square (cube) of
// centres has an upper bound: that of the distance from any one point to the square's farthest corner.
// Squares are halved until none can hold a centre that is better than the best one found by more than the
// tolerance. Each square is given the points that can be nearest to some place in it, which soon are few.
#pragma once

#include "tiles/poisson/proof/shared_pieces.hpp"

#include <span>
#include <vector>

namespace poissonlab {

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

}
