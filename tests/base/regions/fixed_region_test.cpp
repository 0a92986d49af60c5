// Regions in whole numbers against CGAL and against all edges.
#include "base/regions/fixed_region.hpp"

#include "base/regions/fixed_edges.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/random_region.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using OracleKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// CGAL's answer for a ring of whole numbers.
CGAL::Bounded_side side_by_cgal(const RegionRing& ring, const TorusPoint<2>& p)
{
    std::vector<OracleKernel::Point_2> corners;
    for (const auto& [x, y] : ring) corners.emplace_back(x, y);
    return CGAL::bounded_side_2(corners.begin(), corners.end(), OracleKernel::Point_2(p[0], p[1]), OracleKernel());
}

bool contains_by_cgal(const PlaneRegion& region, const TorusPoint<2>& p)
{
    for (const RegionPolygon& polygon : region.polygons) {
        const CGAL::Bounded_side outline = side_by_cgal(polygon.outline, p);
        if (outline == CGAL::ON_UNBOUNDED_SIDE) continue;
        const bool is_in_hole = std::ranges::any_of(
            polygon.holes, [&](const RegionRing& hole) { return side_by_cgal(hole, p) == CGAL::ON_BOUNDED_SIDE; });
        if (!is_in_hole) return true;
    }
    return false;
}

/// Whole corners whose box begins at 0 and has the longest side that is possible: a unit is 1, and nothing is rounded.
constexpr double whole_side = 0x1p31 - 1;

/// A polygon of an outline and holes.
PlaneRegion of_rings(std::vector<RegionRing> rings)
{
    PlaneRegion region;
    RegionPolygon& polygon = region.polygons.emplace_back();
    polygon.outline = rings.front();
    polygon.holes.assign(rings.begin() + 1, rings.end());
    return region;
}

/// A narrow band with so many corners on either side that cells of the grid are divided.
PlaneRegion road()
{
    constexpr int corners = 10'000;
    RegionRing outline;
    for (int i = 0; i <= corners; ++i) outline.push_back({std::floor(whole_side * i / corners), 1000.0 * (i % 7)});
    for (int i = corners; i >= 0; --i)
        outline.push_back({std::floor(whole_side * i / corners), 10'000 + 1000.0 * (i % 5)});
    return of_rings({outline});
}

std::vector<PlaneRegion> whole_regions()
{
    const double w = whole_side;
    std::vector<PlaneRegion> regions{
        of_rings({{{0, 0}, {w, 0}, {w, 70}, {0, 70}}}), // one row of cells
        of_rings({{{0, 0}, {w, 0}, {w, w}, {0, w}},
                  {{0x1p30, 0x1p29}, {0x1p30 + 0x1p26, 0x1p30}, {0x1p30, 0x1p30 + 0x1p26}, {0x1p29, 0x1p30}}}),
        of_rings({{{0, 0}, {w, 1}, {w, w}}, {{5, 3}, {0x1p30, 0x1p29}, {0x1p30 + 7, 2}}})};
    for (std::uint32_t seed = 1; seed <= 4; ++seed)
        regions.push_back(test::star_with_holes(seed, seed < 3 ? 40 : 4000, whole_side));
    regions.push_back(road());
    return regions;
}

/// Positions on corners and edges, beside them, on corners of cells, and anywhere.
std::vector<TorusPoint<2>> awkward_positions(const PlaneRegion& region, std::size_t count, std::uint32_t seed,
                                             std::size_t corners = 20)
{
    std::mt19937 random(seed);
    std::vector<TorusPoint<2>> positions;
    const auto add = [&](double x, double y) {
        for (const double dx : {-1.0, 0.0, 1.0})
            for (const double dy : {-1.0, 0.0, 1.0})
                if (x + dx >= 0 && y + dy >= 0)
                    positions.push_back({static_cast<std::uint32_t>(x + dx), static_cast<std::uint32_t>(y + dy)});
    };
    for (const RegionPolygon& polygon : region.polygons) {
        std::vector<RegionRing> rings{polygon.outline};
        rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
        for (const RegionRing& ring : rings)
            for (std::size_t i = 0; i < std::min(ring.size(), corners); ++i) {
                const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
                add(a[0], a[1]);
                add(std::floor((a[0] + b[0]) / 2), std::floor((a[1] + b[1]) / 2));
                add(std::floor(a[0] / 0x1p22) * 0x1p22, std::floor(a[1] / 0x1p22) * 0x1p22);
                add(std::floor(a[0] / 0x1p22) * 0x1p22, a[1]);
            }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<std::uint32_t>(random()), y = static_cast<std::uint32_t>(random());
        positions.push_back({x >> i % 2, y >> i % 2});
    }
    return positions;
}

TEST(FixedRegions, ContainWhatCgalSays)
{
    std::uint32_t seed = 0;
    for (const PlaneRegion& region : whole_regions()) {
        check_region(region, "region");
        const FixedRegion fixed(region);
        ASSERT_EQ(fixed.unit(), 1);
        std::size_t inside = 0;
        for (const TorusPoint<2>& p : awkward_positions(region, 400, ++seed)) {
            const bool expected = contains_by_cgal(region, p);
            inside += expected;
            ASSERT_EQ(fixed.contains(p), expected) << seed << ": " << p[0] << " " << p[1];
            ASSERT_EQ(fixed.contains_plainly(p), expected) << seed << ": " << p[0] << " " << p[1];
        }
        EXPECT_GT(inside, 10U);
    }
}

TEST(FixedRegions, SayTheSameByTheGridAndByAllEdges)
{
    for (const auto& [corners, positions] : {std::pair{500, 20'000}, {100'000, 10}}) {
        const PlaneRegion region = test::star_with_holes(9, corners, 1000);
        const FixedRegion fixed(region);
        for (const TorusPoint<2>& p : awkward_positions(region, static_cast<std::size_t>(positions), 5, 3))
            ASSERT_EQ(fixed.contains(p), fixed.contains_plainly(p)) << p[0] << " " << p[1];
    }
}

/// Distances from edges by CGAL's exact numbers: with a margin what is nearer to an edge is outside.
TEST(FixedRegions, KeepTheirMargin)
{
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    const PlaneRegion region = test::star_with_holes(2, 60, whole_side);
    std::vector<Exact::Segment_2> edges;
    for (const RegionPolygon& polygon : region.polygons) {
        std::vector<RegionRing> rings{polygon.outline};
        rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
        for (const RegionRing& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
                edges.emplace_back(Exact::Point_2(a[0], a[1]), Exact::Point_2(b[0], b[1]));
            }
    }
    for (const double margin : {0x1p-32, 3 * 0x1p-32, 0x1p-20, 0.003, 0.05}) {
        const FixedRegion fixed(region, margin);
        const Exact::FT squared = Exact::FT(margin * 0x1p32) * Exact::FT(margin * 0x1p32);
        int inside = 0, outside = 0;
        for (const TorusPoint<2>& p : awkward_positions(region, 500, 3, 2)) {
            const bool is_far = std::ranges::all_of(edges, [&](const Exact::Segment_2& edge) {
                return CGAL::squared_distance(edge, Exact::Point_2(p[0], p[1])) >= squared;
            });
            const bool expected = is_far && contains_by_cgal(region, p);
            ++(expected ? inside : outside);
            ASSERT_EQ(fixed.contains(p), expected) << margin << ": " << p[0] << " " << p[1];
            ASSERT_EQ(fixed.contains_plainly(p), expected) << margin << ": " << p[0] << " " << p[1];
        }
        EXPECT_GT(inside, 5) << margin;
        EXPECT_GT(outside, 100) << margin;
    }
}

/// The share of random positions that are inside is the area of the region, within five standard deviations.
TEST(FixedRegions, HaveTheAreaOfTheRegion)
{
    const PlaneRegion region = test::star_with_holes(3, 1000, 250);
    const FixedRegion fixed(region);
    std::mt19937 random(7);
    constexpr int trials = 200'000;
    int inside = 0;
    for (int i = 0; i < trials; ++i) {
        const auto x = static_cast<std::uint32_t>(random()), y = static_cast<std::uint32_t>(random());
        inside += fixed.contains({x >> 1, y >> 1});
    }
    const double share = area_of(region) / std::pow(fixed.unit() * 0x1p31, 2);
    EXPECT_NEAR(inside / double{trials}, share, 5 * std::sqrt(share * (1 - share) / trials));
}

std::vector<std::pair<PlaneRegion, double>> regions_with_margins()
{
    std::vector<std::pair<PlaneRegion, double>> all;
    for (const PlaneRegion& region : whole_regions())
        for (const double margin : {0.0, 1e-6, 0.01}) all.emplace_back(region, margin);
    return all;
}

/// Boxes of all sizes: what is said to be outside or inside holds for each position that is looked at, and small boxes
/// that are said to be crossed are.
TEST(FixedRegions, KnowOnWhichSideBoxesLie)
{
    std::mt19937 random(11);
    std::array<int, 3> count{};
    for (const auto& [region, margin] : regions_with_margins()) {
        const FixedRegion fixed(region, margin);
        const RegionRing& corners = region.polygons[0].outline;
        for (int i = 0; i < 1500; ++i) {
            const auto extent = static_cast<std::uint32_t>((1u << random() % 31) - 1);
            const auto& near = corners[random() % corners.size()];
            FixedBox box;
            for (std::size_t k = 0; k < 2; ++k) {
                const auto back = static_cast<double>(random() % (2 * std::uint64_t{extent} + 2));
                const double low = i % 2 == 0 ? static_cast<double>(random() >> 1) : near[k] - back;
                box.low[k] = static_cast<std::uint32_t>(std::max(0.0, low));
                box.high[k] = box.low[k] + extent;
            }
            const RegionSide side = fixed.side_of(box);
            ++count[static_cast<std::size_t>(side)];
            if (side == RegionSide::crossed && extent == 0 && margin == 0) {
                ASSERT_TRUE(fixed.contains(box.low)) << "an edge touches the only position";
            }
            for (std::uint32_t j = 0; j < 20 && side != RegionSide::crossed; ++j) {
                TorusPoint<2> p;
                for (std::uint32_t k = 0; k < 2; ++k)
                    p[k] = box.low[k] + (j < 4 ? (j >> k & 1) * extent
                                               : static_cast<std::uint32_t>(random() % (std::uint64_t{extent} + 1)));
                ASSERT_EQ(fixed.contains_plainly(p), side == RegionSide::inside) << p[0] << " " << p[1];
            }
        }
    }
    for (const int each : count) EXPECT_GT(each, 100);
}

/// Two positions are both inside or both outside exactly when an even number of crossing edges' lines separates them.
TEST(FixedRegions, FindTheEdgesThatCrossBoxes)
{
    std::mt19937 random(6);
    std::size_t with_edges = 0;
    for (const PlaneRegion& region : {test::star_with_holes(3, 60, 0x1p31), test::star_with_holes(4, 3000, 0x1p31),
                                      read_region("POLYGON ((0 0, 900 700, 900 703, 0 3, 0 0))")}) {
        const FixedRegion fixed(region);
        for (int i = 0; i < 4000; ++i) {
            const std::uint32_t side = 1u << random() % 24;
            const double along = static_cast<double>(random()) * 0x1p-32 * 0x1p31;
            const std::uint32_t x = static_cast<std::uint32_t>(along) / 2,
                                y = i % 2 == 0 ? static_cast<std::uint32_t>(along * 7 / 18)
                                               : static_cast<std::uint32_t>(random() >> 2);
            const FixedBox box{{x, y}, {x + side, y + side}};
            std::vector<FixedEdge> edges;
            if (!fixed.find_crossing(box, edges)) continue;
            with_edges += !edges.empty();
            const auto place = [&] {
                return TorusPoint<2>{x + static_cast<std::uint32_t>(random()) % (side + 1),
                                     y + static_cast<std::uint32_t>(random()) % (side + 1)};
            };
            const TorusPoint<2> a = place(), b = place();
            bool is_same = true, is_on_edge = false;
            for (const FixedEdge& e : edges) {
                const std::int64_t of_a = fixed_edges::line_side(e, a[0], a[1]),
                                   of_b = fixed_edges::line_side(e, b[0], b[1]);
                is_on_edge |= of_a == 0 || of_b == 0;
                is_same ^= (of_a > 0) != (of_b > 0);
            }
            if (is_on_edge) continue;
            EXPECT_EQ(fixed.contains_plainly(a) == fixed.contains_plainly(b), is_same);
        }
    }
    EXPECT_GT(with_edges, 500U);
}

/// A gap below a position makes one edge of two, of which parity would count one.
TEST(FixedRegions, FindNoCrossingsWhereEdgesCoincide)
{
    std::vector<FixedEdge> edges;
    const FixedBox around{{(1u << 30) - 10, 100}, {(1u << 30) + 10, 120}};
    const auto squares = [](const char* gap) {
        return FixedRegion(
            read_region(fmt::format("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), (({0} 0, 2 0, 2 1, {0} 1, "
                                    "{0} 0)))",
                                    gap)));
    };
    EXPECT_FALSE(squares("1.0000000001").find_crossing(around, edges));
    EXPECT_TRUE(squares("1.1").find_crossing(around, edges));
}

TEST(FixedRegions, GiveTheirOwnCoordinatesBack)
{
    const FixedRegion fixed(read_region("rectangle 500000 5640000 500400 5640100"));
    EXPECT_EQ(fixed.own({0, 0}), (std::array{500000.0, 5640000.0}));
    const auto [x, y] = fixed.own({(1u << 31) - 1, (1u << 31) / 4});
    EXPECT_NEAR(x, 500400, 1e-9);
    EXPECT_NEAR(y, 5640100, 1e-6);
    EXPECT_EQ(fixed.area(), 40000);
}

}
}
