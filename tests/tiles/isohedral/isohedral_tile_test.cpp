// Tiles of all isohedral types: they fill the plane once, edges lie on edges, and colourings are what they promise.
#include "tiles/isohedral/isohedral_tile.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace poissonlab {
namespace {

constexpr std::array seeds{1, 2, 3};

IsohedralTile tried_tile(const IsohedralType& type, int seed)
{
    return random_tile(type, static_cast<std::uint64_t>(seed), 0.3, 0.12);
}

TEST(IsohedralTiles, UnitsAreAsLargeAsTheirTiles)
{
    for (const IsohedralType& type : isohedral_types())
        for (const int seed : seeds) {
            const IsohedralTile tile = tried_tile(type, seed);
            const auto& [a, b] = tile.translations();
            const double area = area_of(tile.outline());
            EXPECT_NEAR(a[0] * b[1] - a[1] * b[0], static_cast<double>(tile.aspects().size()) * area, 1e-9 * area)
                << "IH" << type.number;
        }
}

/// The number of tiles with a point inside: crossings of a ray to the right.
bool is_inside(const std::vector<PlanePoint>& outline, const PlaneMotion& motion, const PlanePoint& p)
{
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePoint a = motion(outline[i]), b = motion(outline[(i + 1) % outline.size()]);
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]))
            inside = !inside;
    }
    return inside;
}

TEST(IsohedralTiles, EveryPointOfAGridIsInOneTile)
{
    for (const IsohedralType& type : isohedral_types()) {
        const IsohedralTile tile = tried_tile(type, 4);
        const double side = std::sqrt(area_of(tile.outline()) * static_cast<double>(tile.aspects().size()));
        const auto places = tile.tiles_near({0, 0}, {side, side});
        for (int i = 0; i < 14; ++i)
            for (int j = 0; j < 14; ++j) {
                // Away from symmetric places, where corners and edges are.
                const PlanePoint p{(i + 0.3719) / 14 * side, (j + 0.6113) / 14 * side};
                int tiles = 0;
                for (const TilePlace& place : places) tiles += is_inside(tile.outline(), tile.motion(place), p);
                EXPECT_EQ(tiles, 1) << "IH" << type.number << " at " << p[0] << ", " << p[1];
            }
    }
}

TEST(IsohedralTiles, EdgesLieOnThoseOfNeighbours)
{
    for (const IsohedralType& type : isohedral_types())
        for (const int seed : seeds) {
            const IsohedralTile tile = tried_tile(type, seed);
            const auto& outline = tile.outline();
            const auto place_of = [&](std::size_t corner) {
                return std::ranges::find(outline, tile.corners()[corner]) - outline.begin();
            };
            for (std::size_t edge = 0; edge < tile.corners().size(); ++edge) {
                const std::size_t first = place_of(edge);
                const std::size_t end = edge + 1 < tile.corners().size() ? place_of(edge + 1) : outline.size();
                double farthest = 0;
                ASSERT_LT(first, end);
                for (std::size_t i = first; i < end; ++i) {
                    double nearest = std::numeric_limits<double>::infinity();
                    for (const PlanePoint& p : outline) {
                        const PlanePoint q = tile.hops()[edge](p);
                        nearest = std::min(nearest, std::hypot(q[0] - outline[i][0], q[1] - outline[i][1]));
                    }
                    farthest = std::max(farthest, nearest);
                }
                EXPECT_LT(farthest, 1e-9) << "IH" << type.number << ", edge " << edge;
            }
        }
}

TEST(IsohedralTiles, NeighboursAreMutual)
{
    for (const IsohedralType& type : isohedral_types()) {
        const IsohedralTile tile = tried_tile(type, 5);
        for (std::size_t edge = 0; edge < tile.corners().size(); ++edge) {
            const TilePlace there = tile.neighbour({0, 3, -2}, edge);
            bool is_back = false;
            for (std::size_t other = 0; other < tile.corners().size(); ++other)
                is_back |= tile.neighbour(there, other) == TilePlace{0, 3, -2};
            EXPECT_TRUE(is_back) << "IH" << type.number << ", edge " << edge;
        }
    }
}

/// Kaplan's notes, section 7.4.1: permutations that are no shifts, on IH41, whose symmetries are translations alone, so
/// that all colourings by permutations that commute are perfect; those that do not are none. Shifts written as
/// permutations are shifts.
TEST(IsohedralTiles, TakeColouringsByAnyPermutations)
{
    const IsohedralTile tile(isohedral_types()[40], {});
    const TileColoring four{4, {0}, {}, {{{1, 0, 3, 2}, {2, 3, 0, 1}}}};
    for (int column = -5; column <= 5; ++column)
        for (int row = -5; row <= 5; ++row) EXPECT_EQ(four.of({0, column, row}), (column & 1) + 2 * (row & 1));
    EXPECT_TRUE(is_perfect(tile, four));
    EXPECT_FALSE(is_perfect(tile, {3, {0}, {}, {{{1, 0, 2}, {0, 2, 1}}}}));
    for (const IsohedralType& type : isohedral_types()) {
        const IsohedralTile any(type, {});
        TileColoring shifts = proper_coloring(any), permuted = shifts;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::uint32_t color = 0; color < shifts.colors; ++color)
                permuted.permutations[i].push_back((color + shifts.steps[i]) % shifts.colors);
        EXPECT_EQ(permuted.of({0, -7, 12}), shifts.of({0, -7, 12}));
        EXPECT_EQ(is_perfect(any, permuted), shifts.is_perfect) << "IH" << type.number;
        EXPECT_EQ(is_perfect(any, shifts), shifts.is_perfect) << "IH" << type.number;
    }
}

/// A window of 12 units holds all that colourings of up to 4 colours do: they repeat after at most 4 units, or 6.
TEST(IsohedralTiles, SayWhichColouringsArePerfectAndProper)
{
    std::array<int, 2> perfect{}, proper{};
    const auto expect_counted = [&](const IsohedralTile& tile, const TileColoring& coloring) {
        bool is_function = true, differs = true;
        for (std::size_t edge = 0; edge < tile.corners().size(); ++edge) {
            std::map<std::uint32_t, std::uint32_t> image;
            for (std::uint32_t aspect = 0; aspect < tile.aspects().size(); ++aspect)
                for (std::int32_t column = -6; column < 6; ++column)
                    for (std::int32_t row = -6; row < 6; ++row) {
                        const TilePlace place{aspect, column, row};
                        const std::uint32_t color = coloring.of(place), to = coloring.of(tile.image(place, edge));
                        is_function = is_function && image.try_emplace(color, to).first->second == to;
                        differs = differs && color != coloring.of(tile.neighbour(place, edge));
                    }
        }
        EXPECT_EQ(is_perfect(tile, coloring), is_function);
        EXPECT_EQ(is_proper(tile, coloring), differs);
        ++perfect[is_function];
        ++proper[differs];
    };
    for (const IsohedralType& type : isohedral_types()) {
        if (type.number % 3 != 0) continue;
        const IsohedralTile tile(type, {});
        for (std::uint32_t first = 0; first < 4; ++first)
            for (std::uint32_t second = 0; second < 4; ++second) {
                TileColoring shifts{4, {}, {first, second}};
                for (std::uint32_t k = 0; k < tile.aspects().size(); ++k) shifts.aspects.push_back((2 * first + k) % 4);
                expect_counted(tile, shifts);
                shifts.permutations = {{{1, 2, 0, 3}, {1, 0, 2, 3}}};
                expect_counted(tile, shifts);
            }
    }
    // Colours that meet only from the second column on: IH41 has neighbours at (1, 0) and (0, 1).
    const IsohedralTile squares(isohedral_types()[40], {});
    const TileColoring later{3, {0}, {}, {{{1, 2, 0}, {1, 0, 2}}}};
    EXPECT_NE(later.of({0, 0, 0}), later.of({0, 0, 1}));
    EXPECT_EQ(later.of({0, 2, 0}), later.of({0, 2, 1}));
    EXPECT_FALSE(is_proper(squares, later));
    EXPECT_TRUE(is_proper(squares, {4, {0}, {}, {{{1, 0, 3, 2}, {2, 3, 0, 1}}}}));
    for (const auto& counts : {perfect, proper})
        for (const int count : counts) EXPECT_GT(count, 10);
}

TEST(IsohedralTiles, ColouringsTellNeighboursApart)
{
    int perfect = 0;
    for (const IsohedralType& type : isohedral_types()) {
        const IsohedralTile tile(type, {});
        const TileColoring coloring = proper_coloring(tile);
        perfect += coloring.is_perfect;
        std::map<std::uint32_t, std::uint32_t> image;
        for (std::uint32_t aspect = 0; aspect < tile.aspects().size(); ++aspect)
            for (int column = -2; column <= 2; ++column)
                for (int row = -2; row <= 2; ++row) {
                    const TilePlace place{aspect, column, row};
                    for (std::size_t edge = 0; edge < tile.corners().size(); ++edge)
                        EXPECT_NE(coloring.of(place), coloring.of(tile.neighbour(place, edge))) << "IH" << type.number;
                    // The motion across the first edge permutes the colours of a perfect one.
                    const std::uint32_t to = coloring.of(tile.image(place, 0));
                    if (!coloring.is_perfect) continue;
                    EXPECT_EQ(image.try_emplace(coloring.of(place), to).first->second, to) << "IH" << type.number;
                }
    }
    EXPECT_EQ(perfect, 92);
    // Hexagons that meet in threes need three colours, and squares two: regular tiles of IH20 and IH76.
    EXPECT_EQ(proper_coloring(IsohedralTile(isohedral_types()[19], {})).colors, 3U);
    EXPECT_EQ(proper_coloring(IsohedralTile(isohedral_types()[75], {})).colors, 2U);
}

TEST(IsohedralTiles, CurvesTakeTheShapeOfTheirEdges)
{
    const PlaneCurve curve{{0, 0}, {0.4, 0.2}, {1, 0}};
    EXPECT_EQ(shaped_curve(curve, EdgeShape::free), curve);
    EXPECT_EQ(shaped_curve(curve, EdgeShape::straight), (PlaneCurve{{0, 0}, {1, 0}}));
    EXPECT_EQ(shaped_curve(curve, EdgeShape::turned), (PlaneCurve{{0, 0}, {0.2, 0.1}, {0.5, 0}, {0.8, -0.1}, {1, 0}}));
    EXPECT_EQ(shaped_curve(curve, EdgeShape::mirrored), (PlaneCurve{{0, 0}, {0.2, 0.2}, {0.5, 0}, {0.8, 0.2}, {1, 0}}));
}

/// Pieces of one straight line lie side by side, in any direction, and do not meet.
TEST(IsohedralTiles, TakesStraightCurvesInPieces)
{
    const PlaneCurve pieces{{0, 0}, {0.1, 0}, {0.3, 0}, {0.35, 0}, {0.7, 0}, {1, 0}};
    for (const int number : {1, 4, 7, 21, 28, 41, 79}) {
        const IsohedralType& type = isohedral_types()[static_cast<std::size_t>(number - 1)];
        const std::vector<PlaneCurve> curves(type.shape.curve_shapes.size(), pieces);
        const IsohedralTile tile(type, {{}, curves}), whole(type, {});
        EXPECT_NEAR(area_of(tile.outline()), area_of(whole.outline()), 1e-12);
    }
    // A piece that goes back along the line does meet it.
    const PlaneCurve back{{0, 0}, {0.6, 0}, {0.4, 0}, {1, 0}};
    EXPECT_THROW(IsohedralTile(isohedral_types()[0], {{}, {back}}), InputError);
}

TEST(IsohedralTiles, RefusesWhatIsNoTile)
{
    const IsohedralType& type = isohedral_types()[0];
    EXPECT_EQ(message_of([&] { IsohedralTile(type, {{1, 2}, {}}); }), "IH1 has 4 parameters, not 2");
    EXPECT_EQ(message_of([&] { IsohedralTile(type, {{0, 0, 0, std::nan("")}, {}}); }), "a parameter is not a number");
    const PlaneCurve loop{{0, 0}, {0.6, 3}, {0.4, -3}, {1, 0}};
    EXPECT_EQ(message_of([&] {
                  IsohedralTile(type, {{}, {loop}});
              }),
              "the outline of the tile crosses itself with these parameters and curves");
    // One parameter of IH72 makes rectangles of any length: some value makes a side vanish.
    const IsohedralType& rectangle = isohedral_types()[71];
    const auto& moved = rectangle.shape.deformations[0];
    const auto& base = rectangle.shape.base;
    const double vanishing = -(base[1][0] - base[0][0]) / (moved[1][0] - moved[0][0]);
    EXPECT_EQ(message_of([&] {
                  IsohedralTile(rectangle, {{vanishing}, {}});
              }),
              "edge 0 of the tile has no length with these parameters");
}

}
}
