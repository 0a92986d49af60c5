// Methods other than darts in regions that are very long: relaxation by darts into squares, Lloyd's method with listed
// cells, Bridson's, and grids that are folded. Oracles are dense grids, and sets in which all pairs are looked at.
#include "base/regions/region_text.hpp"
#include "host/sampling/classics/torus_grid.hpp"
#include "host/sampling/regions/region_bridson.hpp"
#include "host/sampling/regions/region_candidates.hpp"
#include "host/sampling/regions/region_lloyd.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "tests/support/named_region.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace poissonlab {
namespace {

struct LongRelaxationCase
{
    std::string region;
    std::size_t points;
    bool is_in_space = false;
    double initial_radius = 0.001;
};

/// A corridor 900 units long. Those of 1, 2, 4 and 50 units across are filled by some 750, 1,450, 2,600 and 32,000
/// points at a distance of 1, which is 1 / 1,800 of the torus or a little more.
std::string corridor(double degrees, double across)
{
    const double angle = degrees / 180 * std::numbers::pi, x = 900 * std::cos(angle), y = 900 * std::sin(angle);
    const double left = -across * std::sin(angle), up = across * std::cos(angle);
    return fmt::format("POLYGON ((0 0, {} {}, {} {}, {} {}, 0 0))", x, y, x + left, y + up, left, up);
}

LongRelaxationCase filled_corridor(double degrees, double across, std::size_t points)
{
    return {corridor(degrees, across), points, false, 1.3 / 3600};
}

/// A corridor that is bent like the letter S, with holes.
std::string bent_corridor()
{
    constexpr int steps = 60;
    std::string up, down, holes;
    for (int i = 0; i <= steps; ++i) {
        const double x = 15.0 * i, y = 90 * std::sin(i * 2 * std::numbers::pi / steps);
        down += fmt::format("{} {}, ", x, y);
        up = fmt::format("{} {}, ", x, y + 3) + up;
        if (i > 0 && i < steps)
            holes += fmt::format(", ({0} {1}, {0} {2}, {3} {2}, {0} {1})", x, y + 1.2, y + 1.8, x + 0.3);
    }
    return "POLYGON ((" + down + up + "0 0)" + holes + ")";
}

/// A hundred triangles, far from each other.
std::string islands()
{
    std::string text;
    for (int i = 0; i < 100; ++i) {
        const double x = 97.0 * (i % 10) + i % 7, y = 89.0 * (i / 10) + i % 5;
        text += fmt::format("{0}(({1} {2}, {3} {4}, {5} {6}, {1} {2}))", i > 0 ? ", " : "", x, y, x + 4, y + 1, x + 1,
                            y + 5);
    }
    return "MULTIPOLYGON (" + text + ")";
}

void PrintTo(const LongRelaxationCase& c, std::ostream* out) { *out << c.points << " in " << c.region; }

class RelaxationInSquares : public testing::TestWithParam<LongRelaxationCase>
{
};

TEST_P(RelaxationInSquares, IsThatOfTheReferenceInsideAndFarEnoughApart)
{
    const auto& [name, points, is_in_space, initial_radius] = GetParam();
    RelaxationDartThrowingRequest request;
    request.dimension = is_in_space ? 3 : 2;
    request.points = points;
    request.initial_radius = initial_radius;
    request.factor = 0.9;
    request.attempts = 300;
    request.stream = stream_key(7, Purpose::relaxation_dart_throwing, 0);
    if (is_in_space) {
        request.space = std::make_shared<const FixedSpace>(read_space_region(name));
        request.cubes = std::make_shared<const RegionSquares<FixedSpace>>(squares_of(*request.space, 1 << 14));
    } else {
        request.region = std::make_shared<const FixedRegion>(test::named_region(name));
        request.squares = std::make_shared<const RegionSquares<FixedRegion>>(squares_of(*request.region, 1 << 14));
    }
    const RelaxationDarts expected = reference::throw_relaxation_darts(request);
    for (const unsigned threads : {1U, 0U})
        for (const std::size_t group : {std::size_t{1}, std::size_t{0}})
            EXPECT_TRUE(RelaxationDartThrower(Device::open({}, threads), group).throw_darts(request) == expected);
    ASSERT_EQ(expected.points.size(), points);
    for (std::size_t i = 0; i < points; ++i) {
        const auto p = expected.points[i];
        if (!is_in_space) {
            EXPECT_TRUE(request.region->contains_plainly(
                {static_cast<std::uint32_t>(p[0] * 0x1p32), static_cast<std::uint32_t>(p[1] * 0x1p32)}));
        }
        for (std::size_t j = 0; j < i && i < 3000; ++j) {
            double squared = 0;
            for (std::size_t k = 0; k < p.size(); ++k)
                squared += (p[k] - expected.points[j][k]) * (p[k] - expected.points[j][k]);
            ASSERT_GE(std::sqrt(squared), 2 * expected.radius);
        }
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, RelaxationInSquares, testing::Values(LongRelaxationCase{"rectangle 0 0 90 1", 6}));

INSTANTIATE_TEST_SUITE_P(
    Shapes, RelaxationInSquares,
    testing::Values(LongRelaxationCase{"rectangle 0 0 30000 1", 1500},
                    LongRelaxationCase{"POLYGON ((0 0, 900 700, 900 703, 0 3, 0 0))", 1000},
                    LongRelaxationCase{"star60", 300},
                    LongRelaxationCase{"MULTIPOLYGON (((0 0,1 0,0 1,0 0)),((9000 9000,9001 9000,9001 9001,9000 9000)))",
                                       400},
                    LongRelaxationCase{"box 0 0 0 900 1 2", 500, true},
                    LongRelaxationCase{"box 0 0 0 900 4 5", 9000, true, 1.3 / 3600}));

INSTANTIATE_TEST_SUITE_P(Filled, RelaxationInSquares,
                         testing::Values(filled_corridor(0, 1, 750), filled_corridor(30, 1, 750),
                                         filled_corridor(45, 2, 1450), filled_corridor(89, 2, 1450),
                                         filled_corridor(90.0001, 4, 2600), filled_corridor(0, 4, 2600),
                                         filled_corridor(30, 50, 30'000),
                                         LongRelaxationCase{bent_corridor(), 2200, false, 1.3 / 3600},
                                         LongRelaxationCase{islands(), 900, false, 1.3 / 3600}));

struct ListedCase
{
    std::string region;
    std::size_t sites;
};

void PrintTo(const ListedCase& c, std::ostream* out) { *out << c.sites << " in " << c.region; }

class ListedCells : public testing::TestWithParam<ListedCase>
{
};

/// Moments are those of a grid with all cells but for rounding, and of the kernel to the last bit.
TEST_P(ListedCells, HaveTheMomentsOfAllCells)
{
    const FixedRegion region(test::named_region(GetParam().region));
    const std::vector<TorusPoint<2>> sites =
        RegionCandidates(region, stream_key(3, Purpose::random_points, 0)).next(GetParam().sites);
    SiteGrid all(region, sites.size()), listed(region, sites.size(), true);
    all.sort(sites);
    listed.sort(sites);
    const auto expected = reference::integrate_cells(all), found = reference::integrate_cells(listed);
    std::vector<double> areas(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) areas[all.numbers()[i]] = expected[i].twice_area;
    for (std::size_t i = 0; i < sites.size(); ++i)
        EXPECT_NEAR(found[i].twice_area, areas[listed.numbers()[i]], 1e-9 * areas[listed.numbers()[i]] + 1e-3);
    for (const std::size_t group : {std::size_t{1}, std::size_t{0}}) {
        const auto by_kernel = RegionLloyd(Device::open(), group).integrate_cells(listed);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            EXPECT_EQ(by_kernel[i].twice_area, found[i].twice_area);
            EXPECT_EQ(by_kernel[i].x, found[i].x);
            EXPECT_EQ(by_kernel[i].y, found[i].y);
        }
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, ListedCells, testing::Values(ListedCase{"star24", 9}));

INSTANTIATE_TEST_SUITE_P(Shapes, ListedCells,
                         testing::Values(ListedCase{"rectangle 0 0 3 2", 500}, ListedCase{"star60", 700},
                                         ListedCase{"star4000", 200}, ListedCase{"rectangle 0 0 1000 1", 800},
                                         ListedCase{"POLYGON ((0 0, 900 700, 900 703, 0 3, 0 0))", 1500},
                                         ListedCase{"MULTIPOLYGON (((0 0,1 0,0 1,0 0)),((90 90,91 90,91 91,90 90)))",
                                                    40}));

/// Lloyd's method on a narrow road ends where points are evenly spaced.
TEST(LloydInLongRegions, SpacesPointsEvenlyOnARoad)
{
    const FixedRegion region(read_region("rectangle 0 0 100000 1"));
    std::vector<TorusPoint<2>> sites;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(0.3, 0.7);
    constexpr std::size_t count = 20'000; // 5 units each
    for (std::size_t i = 0; i < count; ++i)
        sites.push_back({static_cast<std::uint32_t>((static_cast<double>(i) + part(random)) / count * 0x1p31),
                         static_cast<std::uint32_t>(part(random) / 100'000 * 0x1p31)});
    const auto spread = [&](const std::vector<TorusPoint<2>>& all) {
        double squares = 0;
        for (std::size_t i = 1; i < count; ++i) {
            const double gap = (double{1} * all[i][0] - all[i - 1][0]) / 0x1p31 * count;
            squares += (gap - 1) * (gap - 1);
        }
        return std::sqrt(squares / count);
    };
    RegionLloyd lloyd(Device::open());
    const auto by_kernel = [&](const SiteGrid& grid) { return lloyd.integrate_cells(grid); };
    const auto moved = relax_in_region(region, region, sites, 20, by_kernel, true);
    EXPECT_LT(spread(moved), spread(sites) / 10);
    for (const TorusPoint<2>& site : moved) EXPECT_NEAR(site[1] / 0x1p31 * 100'000, 0.5, 0.02);
}

/// Bridson's points on a road keep their distance, and leave no place on its middle line that is far from all of them.
TEST(BridsonInLongRegions, KeepsDistancesAndFillsTheRoad)
{
    const FixedRegion region(read_region("rectangle 0 0 20000 2"));
    const PointSet points = throw_bridson_darts(region, {.min_distance = 1 / 40'000.0,
                                                         .attempts = 30,
                                                         .stream = stream_key(1, Purpose::bridson, 0),
                                                         .area = CandidateArea::squares});
    std::vector<std::array<double, 2>> places;
    for (std::size_t i = 0; i < points.size(); ++i) places.push_back({points[i][0] * 40'000, points[i][1] * 40'000});
    std::ranges::sort(places);
    const auto gap = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
        return std::hypot(a[0] - b[0], a[1] - b[1]);
    };
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = i; j-- > 0 && places[i][0] - places[j][0] < 1;)
            ASSERT_GE(gap(places[i], places[j]), 1 - 1e-4);
    std::size_t far = 0, next = 0;
    for (double x = 0.5; x < 20'000; x += 0.5) {
        while (places[next][0] < x - 1.5) ++next;
        double nearest = 10;
        for (std::size_t i = next; i < places.size() && places[i][0] < x + 1.5; ++i)
            nearest = std::min(nearest, gap(places[i], {x, 1}));
        far += nearest > 1.1;
    }
    EXPECT_LT(far, 100U); // of 40,000
}

class FoldedGrids : public testing::TestWithParam<int>
{
};

/// Answers of folded grids are those of all points.
TEST_P(FoldedGrids, FindWhatAllPointsTell)
{
    const int dimension = GetParam();
    std::mt19937 random(7);
    TorusGrid folded(2000, dimension, 1 << 12);
    std::vector<TorusPosition> points;
    for (int i = 0; i < 2000; ++i) {
        TorusPosition position{};
        for (int k = 0; k < dimension; ++k) {
            // A diagonal, and some points anywhere.
            const std::uint32_t along = static_cast<std::uint32_t>(i) << 12;
            position[static_cast<std::size_t>(k)] =
                static_cast<std::uint32_t>(i % 10 == 0 ? random() : along + random() % 5000);
        }
        points.push_back(position);
        folded.add(position);
    }
    for (std::size_t i = 0; i < 200; ++i) {
        TorusPosition from = points[random() % points.size()];
        from[0] += static_cast<std::uint32_t>(random() % 9000);
        for (const double reach : {3000.0, 20'000.0, 5e6, 2e9}) {
            std::set<std::size_t> expected;
            std::uint64_t nearest = UINT64_MAX;
            for (std::size_t j = 0; j < points.size(); ++j) {
                const std::uint64_t squared = squared_torus_distance(points[j], from);
                nearest = std::min(nearest, squared);
                if (static_cast<double>(squared) < reach * reach) expected.insert(j);
            }
            const std::vector<std::size_t> found = folded.within(from, reach);
            EXPECT_EQ(std::set<std::size_t>(found.begin(), found.end()), expected);
            EXPECT_EQ(found.size(), expected.size());
            EXPECT_EQ(folded.squared_nearest(from), nearest);
            EXPECT_EQ(folded.is_near(from, static_cast<std::uint64_t>(reach)),
                      nearest < static_cast<std::uint64_t>(reach) * static_cast<std::uint64_t>(reach));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, FoldedGrids, testing::Values(2, 3));

}
}
