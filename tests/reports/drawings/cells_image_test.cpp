// The picture of Voronoi cells: the same cells as the diagram of the whole torus has, and their colours.
#include "reports/drawings/cells_image.hpp"

#include "analysis/measures/voronoi_diagram.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace poissonlab {
namespace {

using Position = std::array<double, 2>;

/// The cells of the whole torus that meet the window, by their points.
std::map<Position, std::pair<int, double>> expected_cells(const PointSet& points, double window)
{
    const auto diagram = voronoi_diagram(points);
    std::map<Position, std::pair<int, double>> cells;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const double dx : {0.0, -1.0})
            for (const double dy : {0.0, -1.0}) {
                const Position p{points[i][0] + dx, points[i][1] + dy};
                const auto meets = [&](std::size_t axis) {
                    const auto along = [&](const Position& corner) { return corner[axis]; };
                    const auto [low, high] = std::ranges::minmax(diagram.cells[i].polygon, {}, along);
                    return p[axis] + along(low) < window && p[axis] + along(high) > 0;
                };
                if (meets(0) && meets(1)) cells[p] = {diagram.cells[i].neighbours, diagram.cells[i].area};
            }
    return cells;
}

/// Points of a large set are moved to the cut-out and back: places are equal within rounding.
void expect_cells(const CellsView& view, const PointSet& points)
{
    auto expected = expected_cells(points, view.window);
    ASSERT_EQ(view.cells.size(), expected.size());
    for (const auto& cell : view.cells) {
        const auto near = std::ranges::min_element(expected, {}, [&](const auto& entry) {
            return std::hypot(entry.first[0] - cell.point[0], entry.first[1] - cell.point[1]);
        });
        EXPECT_LT(std::hypot(near->first[0] - cell.point[0], near->first[1] - cell.point[1]), 1e-14);
        EXPECT_EQ(cell.neighbours, near->second.first);
        EXPECT_NEAR(test::area_of(cell.polygon), near->second.second, 1e-12);
        expected.erase(near);
    }
}

TEST(CellsImage, LargeSetsShowTheCellsOfTheWholeTorus)
{
    std::mt19937_64 random(5);
    const auto points = test::random_points(4000, 2, random);
    const auto view = choose_cells_view(points);
    EXPECT_NEAR(view.window, std::sqrt(400.0 / 4000), 1e-15);
    expect_cells(view, points);
}

TEST(CellsImage, HolesThatReachBeyondTheCutOutAreSeen)
{
    // A hole of a fifth of the torus around the window's corner, where the cut-out's margin is 8/sqrt(2000) = 0.18.
    std::mt19937_64 random(6);
    PointSet points;
    for (const auto all = test::random_points(4000, 2, random); points.size() < 2000;)
        for (std::size_t i = 0; i < all.size() && points.size() < 2000; ++i)
            if (std::hypot(all[i][0] - 0.2, all[i][1] - 0.2) > 0.3)
                points.coordinates.insert(points.coordinates.end(), all[i].begin(), all[i].end());
    expect_cells(choose_cells_view(points), points);
}

TEST(CellsImage, SmallSetsAreShownWhole)
{
    std::mt19937_64 random(7);
    const auto points = test::random_points(100, 2, random);
    const auto view = choose_cells_view(points);
    EXPECT_EQ(view.window, 1);
    EXPECT_GT(view.cells.size(), 100) << "with images of those that reach across the border";
    const auto own = std::ranges::count_if(view.cells, [](const ShownCell& cell) {
        return std::ranges::all_of(cell.point, [](double x) { return x >= 0 && x < 1; });
    });
    EXPECT_EQ(own, 100);
}

TEST(CellsImage, OnePointHasACellThatCoversAll)
{
    PointSet point;
    point.coordinates = {0.25, 0.5};
    const auto view = choose_cells_view(point);
    ASSERT_FALSE(view.cells.empty());
    for (const auto& cell : view.cells) EXPECT_NEAR(test::area_of(cell.polygon), 1, 1e-12);
}

TEST(CellsImage, LatticesHaveOneColour)
{
    const auto view = choose_cells_view(test::square_lattice(64, 2));
    for (const auto& cell : view.cells) EXPECT_EQ(cell.neighbours, 4);
    const auto drawing = draw_cells(view);
    EXPECT_EQ(drawing.shapes.size(), 2 * view.cells.size()) << "a cell and a dot each";
    EXPECT_EQ(drawing.shapes.front().fill, cell_class_color(0));
}

TEST(CellsImage, ClassesAreThoseOfTheStatistics)
{
    EXPECT_EQ(cell_class(3), 0);
    EXPECT_EQ(cell_class(4), 0);
    EXPECT_EQ(cell_class(6), 2);
    EXPECT_EQ(cell_class(8), 4);
    EXPECT_EQ(cell_class(12), 4);
    EXPECT_EQ(cell_class_name(3), "7");
}

TEST(CellsImage, TheOriginIsAtTheLowerLeft)
{
    CellsView view{0.5, {{{0.1, 0.1}, 6, {{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}}}};
    const auto drawing = draw_cells(view);
    const auto& outline = std::get<Polygon>(drawing.shapes[0].form);
    EXPECT_NEAR(outline[0][0], 0, 1e-12);
    EXPECT_NEAR(outline[0][1], drawing.height, 1e-12);
    EXPECT_NEAR(outline[2][1], 0.6 * drawing.height, 1e-12);
}

}
}
