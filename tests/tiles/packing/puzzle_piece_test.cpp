// Jigsaw pieces: those of a set fit exactly where their tiles do.
#include "tiles/packing/puzzle_piece.hpp"

#include "tiles/packing/tile_packing.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_2<Kernel>;

CgalPolygon polygon_of(const std::vector<PiecePoint>& outline)
{
    CgalPolygon polygon;
    for (const PiecePoint& point : outline) polygon.push_back({point[0], point[1]});
    return polygon;
}

/// The largest distance of two lines of as many points, the second one run backwards after a step by (x, y).
double distance_when_joined(const std::vector<PiecePoint>& line, const std::vector<PiecePoint>& other, double x,
                            double y)
{
    if (line.size() != other.size()) return 1;
    double most = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const PiecePoint& there = other[other.size() - 1 - i];
        most = std::max(most, std::hypot(line[i][0] - there[0] - x, line[i][1] - there[1] - y));
    }
    return most;
}

class PuzzlePiece : public testing::TestWithParam<std::tuple<TileKind, Color>>
{
protected:
    TileKind kind() const { return std::get<0>(GetParam()); }
    Color colors() const { return std::get<1>(GetParam()); }
    TileIndex tiles() const { return colors() * colors() * colors() * colors(); }
};

TEST_P(PuzzlePiece, FitsWhereItsTileFitsAndNowhereElse)
{
    // Each pair of tiles decides by colours, each pair of pieces by outlines: they agree. Rounding alone is 1e-15; the
    // smallest wrong pair of knobs is a tenth of a tile apart for up to four colours.
    for (TileIndex a = 0; a < tiles(); ++a)
        for (TileIndex b = 0; b < tiles(); ++b) {
            const auto first = piece_sides(kind(), a, colors()), second = piece_sides(kind(), b, colors());
            const double east = distance_when_joined(first[1], second[3], 1, 0);
            const double north = distance_when_joined(first[2], second[0], 0, 1);
            ASSERT_EQ(east < 1e-12, fits_east(kind(), colors(), a, b)) << a << " " << b;
            ASSERT_EQ(north < 1e-12, fits_north(kind(), colors(), a, b)) << a << " " << b;
            ASSERT_FALSE(east >= 1e-12 && east < 0.09) << a << " " << b;
            ASSERT_FALSE(north >= 1e-12 && north < 0.09) << a << " " << b;
        }
}

TEST_P(PuzzlePiece, HasAnOutlineThatDoesNotCrossItself)
{
    for (TileIndex tile = 0; tile < tiles(); ++tile) {
        const CgalPolygon polygon = polygon_of(piece_outline(kind(), tile, colors()));
        ASSERT_TRUE(polygon.is_simple()) << tile;
        ASSERT_TRUE(polygon.is_counterclockwise_oriented()) << tile;
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, PuzzlePiece,
                         testing::Combine(testing::Values(TileKind::corner, TileKind::wang),
                                          testing::Values(Color{2}, Color{3}, Color{4})));

/// Steiner's formula: what lies within d of a convex shape of area A and length L has area A + L d + pi d^2.
TEST(GrownOutline, HasTheAreaOfSteinersFormula)
{
    const std::vector<PiecePoint> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const double d = 0.01;
    const double area = polygon_of(grown_outline(square, d)).area();
    // Arcs are polygons of 90 corners a circle, which lack d^2 (pi - 45 sin(2 pi / 90)).
    EXPECT_NEAR(area, 1 + 4 * d + std::numbers::pi * d * d, d * d * 0.003);
}

/// All points around a piece are as far away from it as asked. Boost.Geometry counts coordinates in steps of about
/// 1e-7.
TEST(GrownOutline, KeepsItsDistance)
{
    const double d = 0.005;
    for (const TileKind kind : {TileKind::corner, TileKind::wang}) {
        const CgalPolygon piece = polygon_of(piece_outline(kind, 5, 2));
        for (const PiecePoint& point : grown_outline(piece_outline(kind, 5, 2), d)) {
            double nearest = 1;
            for (const auto& edge : piece.edges())
                nearest = std::min(nearest,
                                   CGAL::to_double(CGAL::squared_distance(edge, Kernel::Point_2(point[0], point[1]))));
            EXPECT_NEAR(std::sqrt(nearest), d, 1e-6);
            EXPECT_EQ(piece.bounded_side({point[0], point[1]}), CGAL::ON_UNBOUNDED_SIDE);
        }
    }
}

}
}
