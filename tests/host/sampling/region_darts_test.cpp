// Dart throwing in regions: kernel against reference, distances, what is inside, and saturation by candidates for
// uncovered places that are found without cells.
#include "host/sampling/dart_throwing.hpp"

#include "tests/support/named_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using Place = std::array<double, 2>; // units of the region's grid

constexpr double grid = 0x1p31;

struct RegionDartCase
{
    std::string region;
    double min_distance;    ///< of the torus
    std::size_t points;     ///< 0: to saturation
    bool has_disks = false; ///< inside whole
};

void PrintTo(const RegionDartCase& c, std::ostream* out)
{
    *out << c.region << ", distance " << c.min_distance << ", " << c.points << " points"
         << (c.has_disks ? ", disks" : "");
}

DartThrowingRequest request_of(const RegionDartCase& c)
{
    DartThrowingRequest request;
    request.min_distance = c.min_distance;
    if (c.points > 0) request.points = c.points;
    request.stream = stream_key(7, Purpose::dart_throwing, 0);
    request.region =
        std::make_shared<const FixedRegion>(test::named_region(c.region), c.has_disks ? c.min_distance / 2 : 0);
    return request;
}

std::vector<Place> places_of(const PointSet& points)
{
    std::vector<Place> places;
    for (std::size_t i = 0; i < points.size(); ++i) places.push_back({points[i][0] * 0x1p32, points[i][1] * 0x1p32});
    return places;
}

TorusPoint<2> fixed(const Place& p) { return {static_cast<std::uint32_t>(p[0]), static_cast<std::uint32_t>(p[1])}; }

double gap(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

class RegionDartSets : public testing::TestWithParam<RegionDartCase>
{
};

TEST_P(RegionDartSets, AreThoseOfTheReferenceInTheRegionAndFarEnoughApart)
{
    const DartThrowingRequest request = request_of(GetParam());
    const PointSet expected = reference::throw_darts(request);
    ASSERT_GT(expected.size(), 0U);
    if (request.points) {
        EXPECT_EQ(expected.size(), *request.points);
    }
    for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds})
        EXPECT_EQ(DartThrower(Device::open(), 0, settling).throw_darts(request), expected);
    const std::vector<Place> places = places_of(expected);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_TRUE(request.region->contains_plainly(fixed(places[i]))) << i;
        for (std::size_t j = 0; j < i; ++j) ASSERT_GE(gap(places[i], places[j]), request.min_distance * 0x1p32);
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, RegionDartSets,
                         testing::Values(RegionDartCase{"rectangle 0 0 3 2", 0.4, 0}, RegionDartCase{"star60", 0.15, 3},
                                         RegionDartCase{"star60", 0.12, 2, true}));

INSTANTIATE_TEST_SUITE_P(
    Shapes, RegionDartSets,
    testing::Values(RegionDartCase{"rectangle 0 0 3 2", 0.2, 0}, RegionDartCase{"star60", 0.09, 0},
                    RegionDartCase{"star60", 0.06, 0, true}, RegionDartCase{"rectangle 0 0 3 2", 0.5, 0},
                    RegionDartCase{"rectangle 0 0 3 2", 0.02, 0}, RegionDartCase{"rectangle 0 0 1000 1", 0.001, 0},
                    RegionDartCase{"disk 5 5 2", 0.03, 0}, RegionDartCase{"disk 5 5 2", 0.02, 200},
                    RegionDartCase{"star60", 0.01, 0}, RegionDartCase{"star4000", 0.01, 0},
                    RegionDartCase{"star4000", 0.1, 0}, RegionDartCase{"star4000", 0.3, 0},
                    RegionDartCase{"star4000", 0.005, 1000},
                    RegionDartCase{"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 0, 3 1, 1 3, 0 0))", 0.01, 0},
                    RegionDartCase{"rectangle 0 0 3 2", 0.02, 0, true},
                    RegionDartCase{"rectangle 0 0 3 2", 0.3, 0, true}, RegionDartCase{"star60", 0.01, 0, true},
                    RegionDartCase{"star4000", 0.01, 0, true}, RegionDartCase{"star4000", 0.03, 30, true},
                    RegionDartCase{"MULTIPOLYGON (((0 0,1 0,0 1,0 0)),((90 90,91 90,91 91,90 90)))", 0.2, 0}));

/// Places where an uncovered part of the region must have a corner if there is one: corners of the region, crossings of
/// its edges with circles of the minimum distance around points, and crossings of two circles.
class UncoveredPlaces
{
public:
    UncoveredPlaces(const FixedRegion& region, std::vector<Place> points, double distance)
        : region_(region), points_(std::move(points)), distance_(distance)
    {}

    /// Counts the places that lie inside and are farther than the minimum distance from all points, by a part of 1e-5,
    /// so that there are thousands of positions around; `candidates` counts all.
    int count(const PlaneRegion& plane, double unit, const RegionBox& box, int& candidates)
    {
        for (const RegionPolygon& polygon : plane.polygons) {
            add_ring(polygon.outline, unit, box);
            for (const RegionRing& hole : polygon.holes) add_ring(hole, unit, box);
        }
        for (std::size_t i = 0; i < points_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) add_crossings_of_circles(i, j);
        candidates = candidates_;
        return uncovered_;
    }

private:
    void look_at(const Place& place, bool is_on_boundary, std::size_t but_i = SIZE_MAX, std::size_t but_j = SIZE_MAX)
    {
        if (!is_on_boundary && (place[0] < 0 || place[1] < 0 || !region_.contains_plainly(fixed(place)))) return;
        ++candidates_;
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (i != but_i && i != but_j && gap(points_[i], place) < distance_ * (1 + 1e-5)) return;
        ++uncovered_;
    }

    void add_ring(const RegionRing& ring, double unit, const RegionBox& box)
    {
        const auto placed = [&](const std::array<double, 2>& corner) {
            return Place{(corner[0] - box.low[0]) / unit, (corner[1] - box.low[1]) / unit};
        };
        for (std::size_t e = 0; e < ring.size(); ++e) {
            const Place a = placed(ring[e]), b = placed(ring[(e + 1) % ring.size()]);
            look_at(a, true);
            const double length = gap(a, b);
            for (std::size_t i = 0; i < points_.size(); ++i) {
                const double along =
                    ((points_[i][0] - a[0]) * (b[0] - a[0]) + (points_[i][1] - a[1]) * (b[1] - a[1])) / length;
                const double across = gap(points_[i], a) * gap(points_[i], a) - along * along;
                const double half = std::sqrt(std::max(0.0, distance_ * distance_ - across));
                if (half == 0) continue;
                for (const double at : {along - half, along + half})
                    if (at > 0 && at < length)
                        look_at({a[0] + (b[0] - a[0]) * at / length, a[1] + (b[1] - a[1]) * at / length}, true, i);
            }
        }
    }

    void add_crossings_of_circles(std::size_t i, std::size_t j)
    {
        const Place &a = points_[i], &b = points_[j];
        const double between = gap(a, b);
        if (between >= 2 * distance_) return;
        const double height = std::sqrt(distance_ * distance_ - between * between / 4);
        for (const double side : {-height, height})
            look_at({(a[0] + b[0]) / 2 - (b[1] - a[1]) * side / between,
                     (a[1] + b[1]) / 2 + (b[0] - a[0]) * side / between},
                    false, i, j);
    }

    const FixedRegion& region_;
    std::vector<Place> points_;
    double distance_;
    int candidates_ = 0, uncovered_ = 0;
};

int uncovered_places(const RegionDartCase& c, const PointSet& points, int& candidates)
{
    const PlaneRegion plane = test::named_region(c.region);
    const FixedRegion region(plane);
    return UncoveredPlaces(region, places_of(points), c.min_distance * 0x1p32)
        .count(plane, region.unit(), region.box(), candidates);
}

TEST(RegionDartSaturation, LeavesNothingUncoveredInside)
{
    for (const RegionDartCase& c : {RegionDartCase{"rectangle 0 0 3 2", 0.02, 0},
                                    {"star60", 0.02, 0},
                                    {"star400", 0.012, 0},
                                    {"disk 5 5 2", 0.02, 0},
                                    {"rectangle 0 0 1000 1", 0.002, 0},
                                    {"star400", 0.3, 0}}) {
        const PointSet all = reference::throw_darts(request_of(c));
        int candidates = 0;
        EXPECT_EQ(uncovered_places(c, all, candidates), 0) << c.region << " " << all.size();
        EXPECT_GT(candidates, 10);
        // The last point that was thrown is needed: without it, its own place is uncovered.
        PointSet fewer = all;
        fewer.coordinates.resize(fewer.coordinates.size() - 2);
        EXPECT_GT(uncovered_places(c, fewer, candidates), 0) << c.region;
    }
}

/// The distance of a place from a line between two others.
double gap_from_edge(const Place& p, const Place& a, const Place& b)
{
    const double squared = std::pow(gap(a, b), 2);
    const double part = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / squared;
    const double at = std::clamp(part, 0.0, 1.0);
    return gap(p, {a[0] + at * (b[0] - a[0]), a[1] + at * (b[1] - a[1])});
}

double gap_from_boundary(const PlaneRegion& plane, const FixedRegion& region, const Place& p)
{
    double least = HUGE_VAL;
    const auto add = [&](const RegionRing& ring) {
        const auto placed = [&](const auto& corner) {
            return Place{(corner[0] - region.box().low[0]) / region.unit(),
                         (corner[1] - region.box().low[1]) / region.unit()};
        };
        for (std::size_t i = 0; i < ring.size(); ++i)
            least = std::min(least, gap_from_edge(p, placed(ring[i]), placed(ring[(i + 1) % ring.size()])));
    };
    for (const RegionPolygon& polygon : plane.polygons) {
        add(polygon.outline);
        for (const RegionRing& hole : polygon.holes) add(hole);
    }
    return least;
}

/// By distances in floating point and a fine grid of places: disks lie inside, and each place that is farther from the
/// boundary than half the distance is nearer than the distance to a point.
TEST(RegionDartDisks, LieInsideAndLeaveNoRoom)
{
    for (const RegionDartCase& c :
         {RegionDartCase{"rectangle 0 0 3 2", 0.02, 0, true}, {"star60", 0.02, 0, true}, {"star400", 0.05, 0, true}}) {
        const DartThrowingRequest request = request_of(c);
        const PlaneRegion plane = test::named_region(c.region);
        const FixedRegion whole(plane);
        const double distance = c.min_distance * 0x1p32;
        const std::vector<Place> points = places_of(reference::throw_darts(request));
        for (const Place& p : points) {
            EXPECT_TRUE(whole.contains_plainly(fixed(p)));
            EXPECT_GE(gap_from_boundary(plane, whole, p), distance / 2 - 2) << "corners are rounded";
        }
        constexpr int places = 150;
        int looked_at = 0;
        for (int i = 0; i < places * places; ++i) {
            const Place p{(i % places + 0.5) * grid / places, (i / places + 0.5) * grid / places};
            if (!whole.contains_plainly(fixed(p)) || gap_from_boundary(plane, whole, p) < distance / 2 + 2) continue;
            ++looked_at;
            EXPECT_TRUE(std::ranges::any_of(points, [&](const Place& q) { return gap(p, q) < distance + 2; }))
                << c.region << ": " << p[0] << " " << p[1];
        }
        EXPECT_GT(looked_at, 1000) << c.region;
    }
}

/// Darts fall evenly: with a distance so small that few are rejected, counts in both halves of a region of two parts
/// are as their areas, within five standard deviations.
TEST(RegionDartRuns, FallEvenly)
{
    const RegionDartCase c{"MULTIPOLYGON (((0 0,3 0,3 3,0 3,0 0)),((9 9,12 9,12 12,9 9)))", 0.001, 1000};
    int first = 0;
    for (const Place& p : places_of(reference::throw_darts(request_of(c)))) first += p[0] < grid / 2;
    EXPECT_NEAR(first, 1000 * 2.0 / 3, 5 * std::sqrt(1000 * 2.0 / 9));
}

TEST(RegionDartRuns, DoNotDependOnWorkGroupsAndThreads)
{
    const DartThrowingRequest request = request_of({"star4000", 0.004, 0});
    const PointSet expected = reference::throw_darts(request);
    for (const unsigned threads : {1u, 2u})
        for (const std::size_t group : {1u, 7u, 128u})
            for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds})
                EXPECT_EQ(DartThrower(Device::open({}, threads), group, settling).throw_darts(request), expected);
}

TEST(RegionDartRuns, FollowSetsOfTheTorusInTheSameBuffers)
{
    DartThrower thrower(Device::open());
    DartThrowingRequest torus = request_of({"star60", 0.02, 0});
    torus.region.reset();
    const DartThrowingRequest star = request_of({"star60", 0.02, 0}), other = request_of({"star4000", 0.01, 50});
    for (const auto* request : std::initializer_list<const DartThrowingRequest*>{&torus, &star, &other, &torus, &star})
        EXPECT_EQ(thrower.throw_darts(*request), reference::throw_darts(*request));
}

}
}
