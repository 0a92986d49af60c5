// The set covariance of a region: the area of what it has in common with itself, moved by a vector h. Also called
// covariogram; it is what translation corrections divide by (Ohser, On estimators for the reduced second moment measure
// of point processes, 1983; Illian et al., Statistical Analysis and Modelling of Spatial Point Patterns, 2008, section
// 4.2.2).
//
// The closed form. Above each x, a region is what lies below its upper edges and not below its lower ones: the sum of
// s_e [y < e(x)], with s = 1 for edges that have the region below them, -1 for others, and a sum of s of 0. The product
// of this and the same of the moved region, integrated over y, is the sum of s_e s_f min(e(x), f(x)), which is that of
// -s_e s_f |e(x) - f(x)| / 2, because sums of s vanish. So
//
//   C(h) = -1/2 sum over edges e, and edges f moved by h, of s_e s_f int |e(x) - f(x)| dx,
//
// over the x that both have: a parabola at most. It takes time in proportion to the pairs of edges that lie above each
// other, at least to the edges.
#pragma once

#include "analysis/regions/boundary_edges.hpp"

#include <span>
#include <vector>

namespace poissonlab {

class SetCovariance
{
public:
    /// Takes the edges that are the boundary of a region.
    explicit SetCovariance(std::span<const RegionEdge> edges);

    /// C(h) at h = (x, y) by the closed form. Rounding leaves some 1e-16 of the area, times the root of the number of
    /// edges.
    double exact(double x, double y) const;

    /// Makes a table of all vectors up to `reach` along each axis, where so many calls of at() are expected to take
    /// longer without it. Between its places at() is bilinear.
    void expect(double calls, double reach);

    /// C(h) at h = (x, y), from the table if there is one that has the vector, else by exact().
    double at(double x, double y) const;

    /// The largest difference that was found between table and closed form in the middle of its cells (all of them, or
    /// some 4,000), as a share of the area; 0 without a table.
    double table_error() const { return table_error_; }

    /// The longest length, up to `most`, for which vectors in all of 16 directions leave at least this share of the
    /// area.
    double reach(double share, double most) const;

    double area() const { return area_; }

    /// Translation corrections leave pairs of points out whose vectors have no larger C(h), as C(h) is 0 but for
    /// rounding where points lie on opposite borders. This lowers estimates by the share of directions with so small
    /// a C(h): with C(h) / area = s or less, at most (2 / pi) sqrt(2 s) = 0.001 in a rectangle (of its width's length).
    double least_common_area() const { return 1e-6 * area_; }

private:
    /// An edge that is not upright, from left to right.
    struct Span
    {
        double left = 0, right = 0;
        double bottom = 0; ///< y at its left end
        double slope = 0;
        double sign = 1;
    };

    double in_table(double x, double y) const;
    void measure_table();

    std::vector<Span> spans_; ///< from left to right
    double area_ = 0;
    int cells_ = 0; ///< of the table, along half an axis; 0: there is none
    double step_ = 0;
    std::vector<double> table_; ///< x from -reach to reach, fastest, y from 0 to reach
    double table_error_ = 0;
};

}
