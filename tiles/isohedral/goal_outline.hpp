// Outlines that tiles are to look like, and how much two outlines differ.
#pragma once

#include "tiles/isohedral/isohedral_template.hpp"

#include <vector>

namespace poissonlab {

/// A closed polygon by lengths along it, which are parts of its perimeter; its perimeter is 1.
class GoalOutline
{
public:
    /// The corners, without the first one again, go round in either direction; the outline goes counterclockwise.
    /// Throws InputError for fewer than three corners and for a polygon without area.
    explicit GoalOutline(std::vector<PlanePoint> corners);

    /// Scaled to a perimeter of 1, counterclockwise, without the first again.
    std::vector<PlanePoint> corners() const { return {corners_.begin(), corners_.end() - 1}; }
    /// The perimeter as it was given.
    double perimeter() const { return perimeter_; }

    /// Appends `count` places at equal lengths along the outline from `from` on, before `to`, which is larger. Lengths
    /// count from the first corner and repeat after 1.
    void append_places(double from, double to, std::size_t count, std::vector<PlanePoint>& places) const;

    /// Places at equal lengths all around.
    std::vector<PlanePoint> places(std::size_t count) const;

private:
    std::vector<PlanePoint> corners_; ///< the first one again at the end
    std::vector<double> lengths_;     ///< from the first corner to each
    double perimeter_ = 0;
};

/// The distance of Arkin, Chew, Huttenlocher, Kedem and Mitchell, An efficiently computable metric for comparing
/// polygonal shapes, 1991: the root of the mean squared difference of directions along both outlines, in radians, for
/// the best rotation and the best place where they begin. It does not depend on sizes and places. Kaplan and Salesin,
/// Escherization, 2000, use it for tiles. Both polygons go counterclockwise. The work is that of all pairs of corners
/// times the corners: `a` and `b` may have some hundreds.
double turning_distance(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b);

}
