// Voronoi cells in regions: kernel against reference, and both against Boolean operations of CGAL.
#include "host/sampling/regions/region_lloyd.hpp"

#include "base/regions/obstacles.hpp"
#include "base/regions/region_text.hpp"
#include "host/sampling/regions/region_candidates.hpp"
#include "tests/support/random_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace poissonlab {
namespace {

using contract::region_lloyd::CellMoments;

constexpr double cells_grid = 0x1p31;

struct LloydCase
{
    std::string region; ///< or "star" and a number of corners
    std::size_t sites;
};

void PrintTo(const LloydCase& c, std::ostream* out) { *out << c.sites << " in " << c.region; }

PlaneRegion plane_for(const LloydCase& c)
{
    if (!c.region.starts_with("star")) return read_region(c.region);
    return test::star_with_holes(5, std::stoi(c.region.substr(4)), cells_grid);
}

std::vector<TorusPoint<2>> sites_in(const FixedRegion& region, std::size_t count)
{
    return RegionCandidates(region, stream_key(3, Purpose::random_points, 0)).next(count);
}

bool operator==(const CellMoments& a, const CellMoments& b)
{
    return a.twice_area == b.twice_area && a.x == b.x && a.y == b.y;
}

class RegionCells : public testing::TestWithParam<LloydCase>
{
};

TEST_P(RegionCells, AreTheSameByKernelAndTileTheRegion)
{
    const PlaneRegion plane = plane_for(GetParam());
    const FixedRegion region(plane);
    std::vector<TorusPoint<2>> sites = sites_in(region, GetParam().sites);
    sites.push_back(sites.front()); // twice
    const std::array<double, 2> corner = plane.polygons[0].outline[0];
    sites.push_back({static_cast<std::uint32_t>(std::round((corner[0] - region.box().low[0]) / region.unit())),
                     static_cast<std::uint32_t>(std::round((corner[1] - region.box().low[1]) / region.unit()))});
    SiteGrid grid(region, sites.size());
    grid.sort(sites);
    const std::vector<CellMoments> expected = reference::integrate_cells(grid);
    for (const std::size_t group : {std::size_t{1}, std::size_t{0}}) {
        const std::vector<CellMoments> found = RegionLloyd(Device::open(), group).integrate_cells(grid);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_TRUE(found[i] == expected[i]) << i;
    }
    double area = 0;
    std::set<TorusPoint<2>> places;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (places.insert(grid.sites()[i]).second) area += expected[i].twice_area / 2;
        EXPECT_GT(expected[i].twice_area, 0);
    }
    const double whole = region.area() / (region.unit() * region.unit());
    double perimeter = 0;
    for (const FixedEdge& e : region.directed_boundary())
        perimeter += std::hypot(double{1} * e[2] - e[0], double{1} * e[3] - e[1]);
    EXPECT_NEAR(area, whole, perimeter + 1e-9 * whole); // corners are rounded: edges move by less than a position
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, RegionCells,
                         testing::Values(LloydCase{"rectangle 0 0 3 2", 6}, LloydCase{"star24", 9}));

INSTANTIATE_TEST_SUITE_P(
    Shapes, RegionCells,
    testing::Values(LloydCase{"rectangle 0 0 3 2", 1}, LloydCase{"rectangle 0 0 3 2", 2000}, LloydCase{"star60", 30},
                    LloydCase{"star60", 3000}, LloydCase{"star4000", 20}, LloydCase{"star4000", 1000},
                    LloydCase{"rectangle 0 0 1000 1", 50}, LloydCase{"disk 5 5 2", 300},
                    LloydCase{"POLYGON ((0 0, 9 1, 1 1.0000001, 9 9, 0 9, 0 0), (0.5 4, 1 8, 0.6 8, 0.5 4))", 200},
                    LloydCase{"MULTIPOLYGON (((0 0,1 0,0 1,0 0)),((90 90,91 90,91 91,90 90)))", 40}));

/// The part of a large square that is nearer to a site than to any other one, by plain clipping. Positions are relative
/// to the site.
RegionRing plain_cell(const std::vector<TorusPoint<2>>& sites, std::size_t number)
{
    const double far = 0x1p33;
    RegionRing cell{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
    for (std::size_t j = 0; j < sites.size(); ++j) {
        if (sites[j] == sites[number]) continue;
        const double nx = double{1} * sites[j][0] - sites[number][0], ny = double{1} * sites[j][1] - sites[number][1];
        const auto beyond = [&](const std::array<double, 2>& at) {
            return at[0] * nx + at[1] * ny - (nx * nx + ny * ny) / 2;
        };
        RegionRing cut;
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const auto &from = cell[i], &to = cell[(i + 1) % cell.size()];
            const double before = beyond(from), after = beyond(to);
            if (before <= 0) cut.push_back(from);
            if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
                const double t = before / (before - after);
                cut.push_back({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
            }
        }
        cell = cut;
    }
    return cell;
}

/// Adds twice the signed area of a ring, and six times its first moments.
void add_ring_moments(CellMoments& sum, const RegionRing& ring, double sign)
{
    if (signed_area_of(ring) < 0) sign = -sign;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto& [ax, ay] = ring[i];
        const auto& [bx, by] = ring[(i + 1) % ring.size()];
        const double cross = sign * (ax * by - ay * bx);
        sum.twice_area += cross;
        sum.x += cross * (ax + bx);
        sum.y += cross * (ay + by);
    }
}

/// Cells are cut out of the region by CGAL: the region without all of a square but the cell.
TEST(CellsInRegions, AreThoseOfCgal)
{
    for (const auto& [corners, count] : {std::pair{24, 12}, {80, 25}}) {
        const PlaneRegion plane = test::star_with_holes(7, corners, 0x1p31 - 1);
        const FixedRegion region(plane);
        ASSERT_EQ(region.unit(), 1);
        const std::vector<TorusPoint<2>> sites = sites_in(region, static_cast<std::size_t>(count));
        SiteGrid grid(region, sites.size());
        grid.sort(sites);
        const std::vector<CellMoments> found = reference::integrate_cells(grid);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const std::size_t number = grid.numbers()[i];
            PlaneRegion relative = plane;
            for (RegionPolygon& polygon : relative.polygons) {
                const auto move = [&](RegionRing& ring) {
                    for (auto& corner : ring)
                        for (std::size_t k = 0; k < 2; ++k) corner[k] -= region.box().low[k] + sites[number][k];
                };
                move(polygon.outline);
                std::ranges::for_each(polygon.holes, move);
            }
            const double far = 0x1p35;
            const RegionPolygon all_but_cell{{{-far, -far}, {far, -far}, {far, far}, {-far, far}},
                                             {plain_cell(sites, number)}};
            CellMoments expected{0, 0, 0, 1, 0};
            for (const RegionPolygon& piece : without_polygons(relative, {all_but_cell}).polygons) {
                add_ring_moments(expected, piece.outline, 1);
                for (const RegionRing& hole : piece.holes) add_ring_moments(expected, hole, -1);
            }
            // Corners have 52 bits, and sums some hundred terms, each at most that of the square around the cell.
            const double side = 2 * grid.grid().half_box;
            EXPECT_NEAR(found[i].twice_area, expected.twice_area, 1e-12 * side * side) << i;
            EXPECT_NEAR(found[i].x, expected.x, 1e-12 * side * side * side) << i;
            EXPECT_NEAR(found[i].y, expected.y, 1e-12 * side * side * side) << i;
        }
    }
}

/// Two points in a rectangle of 2 x 1 come to the centres of its halves, four in a square to those of its quarters.
TEST(RelaxationInRegions, ComesToKnownCentroids)
{
    const FixedRegion region(read_region("rectangle 0 0 2 1"));
    const auto sites = relax_in_region(region, region, sites_in(region, 2), 200, reference::integrate_cells);
    std::vector<std::array<double, 2>> places{region.own(sites[0]), region.own(sites[1])};
    std::ranges::sort(places);
    EXPECT_NEAR(places[0][0], 0.5, 1e-6);
    EXPECT_NEAR(places[1][0], 1.5, 1e-6);
    EXPECT_NEAR(places[0][1], 0.5, 1e-6);
    EXPECT_NEAR(places[1][1], 0.5, 1e-6);
}

/// The mean squared distance from the nearest site, over a lattice of places in the region.
double lattice_energy(const FixedRegion& region, const std::vector<TorusPoint<2>>& sites)
{
    double sum = 0, count = 0;
    constexpr std::uint32_t step = 1u << 24;
    for (std::uint32_t y = step / 2; y < 1u << 31; y += step)
        for (std::uint32_t x = step / 2; x < 1u << 31; x += step) {
            if (!region.contains({x, y})) continue;
            double nearest = HUGE_VAL;
            for (const auto& [sx, sy] : sites)
                nearest = std::min(nearest, std::pow((double{1} * sx - x) * 0x1p-31, 2) +
                                                std::pow((double{1} * sy - y) * 0x1p-31, 2));
            sum += nearest;
            ++count;
        }
    return sum / count;
}

/// In a region that is not convex, with holes: sites stay inside, and the energy falls with each step, but for what a
/// lattice cannot see.
TEST(RelaxationInRegions, LowersTheEnergyAndStaysInside)
{
    const FixedRegion region(test::star_with_holes(5, 60, cells_grid), 0.002);
    std::vector<TorusPoint<2>> sites = sites_in(region, 40);
    double before = lattice_energy(region, sites);
    for (int step = 0; step < 6; ++step) {
        sites = relax_in_region(region, region, sites, 1, reference::integrate_cells);
        for (const auto& site : sites) EXPECT_TRUE(region.contains_plainly(site));
        const double energy = lattice_energy(region, sites);
        EXPECT_LT(energy, before * 1.001) << step;
        before = energy;
    }
}

}
}
