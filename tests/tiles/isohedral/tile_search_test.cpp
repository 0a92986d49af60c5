// The search for tiles that look like a goal: goals that are tiles come back, and no tile crosses itself.
#include "tiles/isohedral/tile_search.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

namespace poissonlab {
namespace {

/// The outline at some other place, in some other size, from another corner on.
std::vector<PlanePoint> displaced(std::vector<PlanePoint> outline, double angle)
{
    const std::complex<double> scale = std::polar(13.7, angle);
    for (PlanePoint& p : outline) {
        const auto z = scale * std::complex<double>(p[0], p[1]);
        p = {z.real() + 5, z.imag() - 70};
    }
    std::ranges::rotate(outline, outline.begin() + 2);
    return outline;
}

void expect_tile(const GoalTile& found)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const IsohedralTile tile(type_of(found), found.parameters);
    CGAL::Polygon_2<Kernel> polygon;
    for (const auto& [x, y] : tile.outline()) polygon.push_back({x, y});
    EXPECT_TRUE(polygon.is_simple()) << "IH" << found.type;
    const auto& [a, b] = tile.translations();
    const double area = CGAL::to_double(polygon.area());
    EXPECT_NEAR(a[0] * b[1] - a[1] * b[0], static_cast<double>(tile.aspects().size()) * area, 1e-9 * area);
}

/// The goal's corners, laid on the tile, are corners of the tile's outline.
void expect_on_outline(const GoalOutline& goal, const GoalTile& found)
{
    const auto& [c, s] = found.scale;
    const IsohedralTile tile(type_of(found), found.parameters);
    const double side = std::sqrt(area_of(tile.outline()));
    for (const auto& [x, y] : goal.corners()) {
        const PlanePoint p{c * x - s * y + found.shift[0], s * x + c * y + found.shift[1]};
        double gap = 1e300;
        for (const PlanePoint& q : tile.outline()) gap = std::min(gap, std::hypot(p[0] - q[0], p[1] - q[1]));
        EXPECT_LT(gap, 0.06 * side) << "IH" << found.type; // points lie 1/144 of the perimeter apart
    }
}

TEST(TileSearches, FindTilesAgain)
{
    for (const int type : {1, 4, 5, 7, 21, 28, 41, 55, 61, 71, 79, 84})
        for (const bool is_mirrored : {false, true}) {
            SCOPED_TRACE("IH" + std::to_string(type) + (is_mirrored ? " in a mirror" : ""));
            const IsohedralTile tile = random_tile(isohedral_types()[static_cast<std::size_t>(type - 1)], 9, 0.3, 0.2);
            std::vector<PlanePoint> outline = tile.outline();
            for (PlanePoint& p : outline) p[0] *= is_mirrored ? -1 : 1;
            const GoalOutline goal(displaced(outline, 0.3 * type));
            const GoalSearch search = tiles_like(goal, {type});
            ASSERT_EQ(search.tiles.size(), 1);
            EXPECT_EQ(search.tiles[0].type, type);
            EXPECT_EQ(search.tiles[0].is_mirrored, is_mirrored && mirrored_type(type) != nullptr);
            EXPECT_LT(search.tiles[0].distance, 0.01);
            EXPECT_LT(search.tiles[0].turning, 0.1);
            expect_tile(search.tiles[0]);
            expect_on_outline(goal, search.tiles[0]);
        }
    EXPECT_NE(mirrored_type(21), nullptr);
    EXPECT_EQ(mirrored_type(1), nullptr);
}

/// Shapes whose corners lie at the places that are tried first are tiles without any difference.
TEST(TileSearches, FindShapesThatTileExactly)
{
    const double high = std::sqrt(0.75);
    std::vector<int> types;
    for (const IsohedralType& type : isohedral_types())
        if (!type.is_marked) types.push_back(type.number);
    for (const std::vector<PlanePoint>& shape :
         {std::vector<PlanePoint>{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
          {{1, 0}, {0.5, high}, {-0.5, high}, {-1, 0}, {-0.5, -high}, {0.5, -high}},
          {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}) {
        const GoalSearch search = tiles_like(GoalOutline(shape), types);
        ASSERT_FALSE(search.tiles.empty()) << shape.size();
        EXPECT_LT(std::ranges::min(search.tiles, {}, &GoalTile::distance).distance, 1e-6) << shape.size();
    }
}

/// An L of three squares tiles by several types; a star of five points by none, but something is nearest.
TEST(TileSearches, FindTilesThatAreSimple)
{
    std::vector<PlanePoint> star;
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 1 : 0.4, angle = 0.2 * std::numbers::pi * i;
        star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const std::vector<PlanePoint> l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    const std::vector<int> types{1, 2, 4, 6, 28, 41, 55, 76};
    for (const auto& [shape, is_tile] : {std::pair(star, false), std::pair(l, true)}) {
        const GoalSearch search = tiles_like(GoalOutline(shape), types);
        ASSERT_FALSE(search.tiles.empty());
        for (std::size_t i = 0; i < search.tiles.size(); ++i) {
            expect_tile(search.tiles[i]);
            if (i > 0) {
                EXPECT_LE(std::pair(search.tiles[i - 1].is_narrow, search.tiles[i - 1].turning),
                          std::pair(search.tiles[i].is_narrow, search.tiles[i].turning));
            }
        }
        EXPECT_EQ(search.tiles[0].distance < 0.01, is_tile) << search.tiles[0].distance;
        // Another run, whose threads share the work in another way.
        const GoalSearch again = tiles_like(GoalOutline(shape), types);
        ASSERT_EQ(again.tiles.size(), search.tiles.size());
        EXPECT_EQ(again.candidates, search.candidates);
        for (std::size_t i = 0; i < search.tiles.size(); ++i) {
            EXPECT_EQ(again.tiles[i].parameters.deformations, search.tiles[i].parameters.deformations);
            EXPECT_EQ(again.tiles[i].parameters.curves, search.tiles[i].parameters.curves);
        }
    }
}

}
}
