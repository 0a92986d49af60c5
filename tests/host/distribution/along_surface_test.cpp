// Points by distances along a surface, on a folded rectangle: paths along it are straight lines of the flat rectangle,
// while its layers are near each other in space. Distances of all pairs and gaps are measured in the flat rectangle.
#include "host/distribution/surfaces/along_surface.hpp"

#include "host/distribution/surfaces/surface_files.hpp"
#include "tests/support/folded_rectangle.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace poissonlab {
namespace {

SurfaceDarts along(const SurfaceDartRequest& request)
{
    return throw_surface_darts(request, *path_dart_engine(request), 1'000'000);
}

double least_flat(const FoldedRectangle& folded, const std::vector<SurfacePoint>& points, std::size_t first = 0)
{
    double least = INFINITY;
    for (std::size_t i = first; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, folded.between(points[i], points[j]));
    return least;
}

/// The largest distance of one of these places from its nearest point.
double widest_gap(const FoldedRectangle& folded, const std::vector<SurfacePoint>& points)
{
    double widest = 0;
    for (const SurfacePoint& place :
         surface_candidates(*folded.surface, 4000, stream_key(9, Purpose::surface_coverage, 0))) {
        double nearest = INFINITY;
        for (const SurfacePoint& point : points) nearest = std::min(nearest, folded.between(place, point));
        widest = std::max(widest, nearest);
    }
    return widest;
}

TEST(DartsAlongSurfaces, AreThoseOfTheFlatRectangle)
{
    for (const double distance : {0.5, 0.15, 0.09}) {
        const FoldedRectangle folded(0.02); // layers are 0.04 apart at most
        SurfaceDarts set = along(folded.request(distance));
        EXPECT_TRUE(set.is_saturated);
        EXPECT_GE(least_flat(folded, set.points), distance * (1 - 1e-6));
        EXPECT_LT(widest_gap(folded, set.points), distance);
        // Random sequential addition in a window without neighbours: half a distance is gained around it.
        const double area = (fold_length + distance / 2) * (fold_width + distance / 2);
        EXPECT_NEAR(static_cast<double>(set.points.size()) / saturated_count(area, distance), 1, distance / 2);
        // In space there would be far fewer, as one point keeps others away from several layers.
        const SurfaceDartRequest space = folded.request(distance);
        EXPECT_LT(throw_surface_darts(space, *reference::surface_dart_engine(space), 1'000'000).points.size(),
                  set.points.size() * 3 / 5);
        // The measure sees the gap of a point that is taken away.
        const SurfacePoint last = set.points.back();
        set.points.pop_back();
        EXPECT_EQ(uncovered_along(*folded.surface, set.points, {last}, distance), 1U);
    }
}

TEST(DartsAlongSurfaces, HaveTheirNumberAndTheirStart)
{
    const FoldedRectangle folded(0.02);
    SurfaceDartRequest request = folded.request(0.2);
    request.points = 150;
    request.shrinking = 0.95;
    request.start = surface_candidates(*folded.surface, 2, stream_key(1, Purpose::surface_candidates, 0));
    request.obstacles = surface_candidates(*folded.surface, 3, stream_key(2, Purpose::surface_candidates, 0));
    const SurfaceDarts set = along(request);
    ASSERT_EQ(set.points.size(), 150U);
    EXPECT_EQ(std::memcmp(set.points.data(), request.start.data(), 2 * sizeof(SurfacePoint)), 0);
    std::vector<SurfacePoint> all = request.obstacles;
    all.insert(all.end(), set.points.begin(), set.points.end());
    EXPECT_GE(least_flat(folded, all, 5), set.min_distance * (1 - 1e-6));
    EXPECT_TRUE(keep_distance_along(*folded.surface, all, set.min_distance, 5));
    EXPECT_FALSE(keep_distance_along(*folded.surface, all, 1.2 * set.min_distance, 5));
}

TEST(DartsAlongSurfaces, SeeNoOtherPart)
{
    const auto sheet = std::make_shared<const FixedSurface>(fixed_surface(sheet_mesh(0.001)));
    const SurfaceDartRequest request{
        .surface = sheet, .min_distance = 2, .stream = stream_key(1, Purpose::surface_darts, 0)};
    EXPECT_EQ(along(request).points.size(), 2U); // a point on each square, whose diagonals are shorter
}

TEST(DartsAlongSurfaces, DoNotDependOnTheNumberOfThreads)
{
    const FoldedRectangle folded(0.1);
    std::vector<SurfaceDarts> found;
    for (const std::size_t threads : {1, 2, 4}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        found.push_back(along(folded.request(0.1)));
    }
    for (const SurfaceDarts& other : found) {
        ASSERT_EQ(other.points.size(), found[0].points.size());
        EXPECT_EQ(other.darts, found[0].darts);
        EXPECT_EQ(std::memcmp(other.points.data(), found[0].points.data(), other.points.size() * sizeof(SurfacePoint)),
                  0);
    }
}

TEST(EliminationAlongSurfaces, IsThatOfTheFlatRectangle)
{
    const FoldedRectangle folded(0.02), flat(1e-9);
    const auto points = surface_candidates(*folded.surface, 800, stream_key(4, Purpose::surface_candidates, 0));
    auto flat_points = points; // of a rectangle whose layers lie side by side
    const auto spread = std::make_shared<const FixedSurface>(fixed_surface(textured_mesh(24, 5, [](double u, double v) {
        return MeshPoint{u * fold_length, v * fold_width, 0};
    })));
    for (SurfacePoint& point : flat_points)
        std::ranges::copy(place_on(spread->triangles[point.triangle], point.shares[0], point.shares[1]), point.place);
    const SurfaceReach reach{0.15, 0.05, 180};
    EXPECT_EQ(removal_order_along(*folded.surface, points, reach, 600),
              reference::surface_removal_order(*spread, flat_points, reach, 600));
}

TEST(DistancesAlongSurfaces, AreThoseOfTheFlatRectangle)
{
    const FoldedRectangle folded(0.02);
    for (const std::size_t count : {2, 3, 200}) {
        const auto points = surface_candidates(*folded.surface, count, stream_key(6, Purpose::surface_candidates, 0));
        double least = INFINITY, sum = 0;
        for (const SurfacePoint& point : points) {
            double nearest = INFINITY;
            for (const SurfacePoint& other : points)
                if (&other != &point) nearest = std::min(nearest, folded.between(point, other));
            least = std::min(least, nearest);
            sum += nearest;
        }
        const PathDistances found = distances_along(*folded.surface, points);
        EXPECT_NEAR(found.least, least, 1e-7);
        EXPECT_NEAR(found.mean_nearest, sum / static_cast<double>(count), 1e-7);
    }
}

}
}
