// A convex polygon around a point that bisectors cut smaller and smaller: a Voronoi cell among points that come one by
// one.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace poissonlab {

class ConvexCell
{
public:
    /// Relative to the cell's point, which is never cut off.
    using Vertex = std::array<double, 2>;

    /// A square that reaches so far in all four directions.
    explicit ConvexCell(double reach);

    /// Cuts off what is nearer to another point, given relative to this one.
    void cut(double x, double y);

    /// Tells whether cutting by a point at this squared distance can change the cell.
    bool is_reached_from(double squared_distance) const { return squared_distance < 4 * squared_radius_; }

    /// The centroid of its area; the point itself where there is none, as of two points at the same place.
    Vertex centroid() const;

    /// Counterclockwise.
    std::span<const Vertex> vertices() const { return vertices_; }

private:
    void find_radius();

    std::vector<Vertex> vertices_, kept_;
    double squared_radius_ = 0; ///< of the farthest vertex
};

}
