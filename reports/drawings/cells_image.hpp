// The picture of Voronoi cells, coloured by their number of neighbours: where a set is ordered, and where order breaks.
//
// The colours are those of studies of two-dimensional crystals: cells with 6 neighbours are pale, those with fewer
// blue, with more orange. Colours after Okabe and Ito, which people with colour deficiencies tell apart.
#pragma once

#include "base/geometry/point_set.hpp"
#include "reports/drawings/drawing.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// A cell with its point, in units of the torus' side; it may reach beyond the window.
struct ShownCell
{
    std::array<double, 2> point{};
    int neighbours = 0;
    std::vector<std::array<double, 2>> polygon;
};

/// The cells that lie in [0, window)^2, wholly or in part.
struct CellsView
{
    double window = 1;
    std::vector<ShownCell> cells;
};

/// Sets of at most 600 points are shown whole, larger ones in a window that holds about 400 of them. Of these, only
/// the surroundings of the window are triangulated, where that is proven to give the same cells. 2D, at least one
/// point.
CellsView choose_cells_view(const PointSet& points);

/// Classes of cells by their number of neighbours: up to 4, 5, 6, 7, at least 8, as in VoronoiStatistics.
constexpr std::size_t cell_classes = 5;
std::size_t cell_class(int neighbours);

/// The class in words, "up to 4" to "8 and more", and its colour as "#rrggbb".
std::string cell_class_name(std::size_t cell_class);
std::string cell_class_color(std::size_t cell_class);

/// Cells with their points, the origin at the lower left.
Drawing draw_cells(const CellsView& view);

}
