// The Voronoi diagram of a point set on the unit torus in 2D, and the statistics of its cells.
//
// Okabe, Boots, Sugihara and Chiu, Spatial Tessellations (2000), chapter 5. The variance of cell areas
// measures how evenly a set covers the plane (0.280 for a Poisson process: Gilbert, Random subdivisions of
// space into crystals, Ann. Math. Statist. 33, 1962); the shares of cells by their number of neighbours
// measure local order: the mean is 6 (Euler), and only sets with hexagonal order have mostly sixes. From
// CGAL's periodic Delaunay triangulation, with exact predicates.
#pragma once

#include "base/geometry/point_set.hpp"

#include <array>
#include <vector>

namespace poissonlab {

/// The cell of one point.
struct VoronoiCell
{
    double area = 0;
    /// Voronoi edges, each shared with a neighbour; a cell can have several with the same neighbour, or with
    /// images of its own point.
    int neighbours = 0;
    /// Vertices counterclockwise from the one in the lowest direction, atan2 in [-pi, pi), relative to the
    /// point, as many as neighbours. A cell may reach across the borders of the unit square.
    std::vector<std::array<double, 2>> polygon;
};

/// One cell a point, in the order of the points.
struct VoronoiDiagram
{
    std::vector<VoronoiCell> cells;
};

/// The diagram of at least one point. Throws InputError for the empty set and for sets that are not 2D.
/// Coordinates must lie in [0, 1).
///
/// Edges shorter than 1e-13 are corners where four or more cells meet, as those of a square lattice do, told
/// apart by rounding only: no neighbours. Of coinciding points the first has the cell; the others have none:
/// area 0, no neighbours, no polygon. A corner is within some 1e-15 over the
/// sine of the sharpest angle of its Delaunay triangle, so that areas of all but clustered sets sum up to 1
/// within 1e-13. Runs on one thread.
VoronoiDiagram voronoi_diagram(const PointSet& points);

struct VoronoiStatistics
{
    double relative_area_variance = 0;       ///< variance (divisor N) of the cell areas over their squared mean
    std::array<double, 5> neighbour_share{}; ///< cells with up to 4, with 5, 6, 7, and at least 8 neighbours

    bool operator==(const VoronoiStatistics&) const = default;
};

/// Shares are of all cells. A diagram without cells has zeros.
VoronoiStatistics voronoi_statistics(const VoronoiDiagram& diagram);

}
