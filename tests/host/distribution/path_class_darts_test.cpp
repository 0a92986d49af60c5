// Darts of several classes along a folded rectangle: distances of all pairs and gaps are measured in the flat one, and
// slots that are settled one by one, by its straight lines, have the points of those that are settled in groups.
#include "host/distribution/surface_classes/path_class_darts.hpp"

#include "host/distribution/surface_classes/surface_class_set.hpp"
#include "host/sampling/surfaces/surface_elimination.hpp"
#include "tests/support/folded_rectangle.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace poissonlab {
namespace {

using contract::class_surface::TRIES;

ClassSurfaceRequest folded_request(const FoldedRectangle& folded, const std::vector<double>& distances)
{
    ClassSurfaceRequest request;
    request.surface = folded.surface;
    request.distances = wei_distances(distances, 2);
    for (const double distance : distances) request.shares.push_back(1 / (distance * distance));
    request.stream = stream_key(3, Purpose::class_darts, 0);
    return request;
}

bool are_equal(const std::vector<SurfacePoint>& a, const std::vector<SurfacePoint>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(SurfacePoint)) == 0;
}

/// Settles slot by slot and dart by dart, by distances in the flat rectangle.
class OneByOne final : public ClassSurfaceEngine
{
public:
    OneByOne(const FoldedRectangle& folded, const ClassSurfaceRequest& request)
        : folded_(folded), request_(request), covering_(path_class_engine(request))
    {}

    void restart(const ClassSurfaceRules& rules, const ClassSurfaceDarts& darts, std::size_t) override
    {
        rules_ = rules;
        darts_ = darts;
    }

    void set_pieces(const std::vector<ClassPieces>& all, std::size_t own) override
    {
        open_ = &all;
        covering_->set_pieces(all, own);
    }

    Settled settle(const std::vector<contract::class_surface::SurfaceSlot>& slots, std::size_t first,
                   std::uint32_t skipped) override
    {
        Settled settled;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const std::uint32_t from = i == 0 ? skipped : 0;
            std::uint32_t number = from;
            SurfacePoint dart{};
            for (; number < from + TRIES; ++number) {
                dart = reference::class_surface_dart(*folded_.surface, (*open_)[slots[i].own], slots[i],
                                                     static_cast<std::uint32_t>(first + i), number, request_.stream);
                if (is_free(dart, slots[i].own)) break;
            }
            if (number == from + TRIES) break;
            darts_.points.push_back(dart);
            darts_.classes.push_back(slots[i].own);
            settled.points.push_back(dart);
        }
        return settled;
    }

    std::vector<std::uint32_t> cover(std::uint32_t own) override
    {
        covering_->restart(rules_, darts_, 0);
        return covering_->cover(own);
    }

private:
    bool is_free(const SurfacePoint& dart, std::uint32_t own) const
    {
        for (std::size_t i = 0; i < darts_.points.size(); ++i)
            if (folded_.between(dart, darts_.points[i]) < request_.distances.at(own, darts_.classes[i])) return false;
        return true;
    }

    const FoldedRectangle& folded_;
    const ClassSurfaceRequest& request_;
    std::unique_ptr<ClassSurfaceEngine> covering_;
    ClassSurfaceRules rules_;
    ClassSurfaceDarts darts_;
    const std::vector<ClassPieces>* open_ = nullptr;
};

TEST(PathClassDarts, AreThoseOfSlotsOneByOne)
{
    for (const double angle : {0.02, 0.7}) {
        const FoldedRectangle folded(angle);
        const ClassSurfaceRequest request = folded_request(folded, {0.6, 0.3, 0.15});
        OneByOne plain(folded, request);
        const ClassSurfaceDarts expected = throw_class_surface_darts(request, plain),
                                found = throw_class_surface_darts(request, *path_class_engine(request));
        EXPECT_TRUE(are_equal(found.points, expected.points)) << angle;
        EXPECT_EQ(found.classes, expected.classes);
        EXPECT_GT(found.points.size(), 150u);
    }
}

TEST(PathClassDarts, KeepTheirDistancesAndFillTheSurface)
{
    const FoldedRectangle folded(0.02); // layers are 0.02 apart, or less
    const ClassSurfaceRequest request = folded_request(folded, {0.5, 0.2});
    const ClassSurfaceDarts darts = throw_class_surface_darts(request, *path_class_engine(request));
    for (std::size_t i = 0; i < darts.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(folded.between(darts.points[i], darts.points[j]),
                      request.distances.at(darts.classes[i], darts.classes[j]) * (1 - 1e-9));
    EXPECT_EQ(darts.is_full, (std::vector{true, true}));
    EXPECT_EQ(darts.small_area, 0);
    for (const SurfacePoint& place :
         surface_candidates(*folded.surface, 2000, stream_key(9, Purpose::surface_coverage, 0)))
        for (std::uint32_t own = 0; own < 2; ++own) {
            bool is_covered = false;
            for (std::size_t i = 0; i < darts.points.size() && !is_covered; ++i)
                is_covered = folded.between(place, darts.points[i]) <
                             request.distances.at(own, darts.classes[i]) * (1 + 1e-8) + 1e-8;
            EXPECT_TRUE(is_covered) << own;
        }
    // Through space, points of all layers keep their distance.
    const ClassSurfaceDarts space = throw_class_surface_darts(request, *reference::class_surface_engine(request));
    EXPECT_GT(darts.points.size(), 3 * space.points.size());

    const std::vector<SurfacePair> pairs = pairs_along(*folded.surface, {darts.of_class(0), darts.of_class(1)});
    ASSERT_EQ(pairs.size(), 3u);
    for (const SurfacePair& pair : pairs) {
        double least = INFINITY, sum = 0;
        for (std::size_t i = 0; i < darts.points.size(); ++i) {
            if (darts.classes[i] != pair.first) continue;
            double nearest = INFINITY;
            for (std::size_t j = 0; j < darts.points.size(); ++j)
                if (j != i && darts.classes[j] == pair.second)
                    nearest = std::min(nearest, folded.between(darts.points[i], darts.points[j]));
            least = std::min(least, nearest);
            sum += nearest;
        }
        EXPECT_NEAR(pair.from_first.least, least, 1e-8);
        EXPECT_NEAR(pair.from_first.mean, sum / static_cast<double>(darts.counts()[pair.first]), 1e-8);
    }
}

/// Where no list of pieces is refined, both engines throw the same darts.
TEST(PathClassDarts, OnAFlatSquareAreThoseOfSpace)
{
    SurfaceClassSettings settings;
    const TriangleMesh mesh = square_mesh(5);
    settings.read = std::make_shared<const SurfaceMesh>(SurfaceMesh{mesh, fixed_surface(mesh)});
    settings.normal_angle = 180;
    settings.classes.points = {10, 40, 160};
    settings.classes.relative_radius = 0.45;
    for (const bool follow : {false, true}) {
        if (follow) settings.classes.densities = {"1", "x", "2-y"};
        settings.metric = SurfaceMetric::space;
        const DistributionPlace place{.engine = Engine::reference, .device = {}};
        const SurfaceClassSet space = throw_surface_classes(settings, 1, place);
        settings.metric = SurfaceMetric::surface;
        const SurfaceClassSet along = throw_surface_classes(settings, 1, place);
        EXPECT_TRUE(are_equal(space.darts.points, along.darts.points));
        EXPECT_EQ(space.darts.classes, along.darts.classes);
        const auto a = pairs_of(space), b = pairs_of(along);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i].from_first.least, b[i].from_first.least, 1e-7);
    }
}

TEST(PathClassDarts, DoNotDependOnThreads)
{
    const FoldedRectangle folded(0.3);
    const ClassSurfaceRequest request = folded_request(folded, {0.3, 0.15});
    std::vector<ClassSurfaceDarts> sets;
    for (const std::size_t threads : {1, 3}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        sets.push_back(throw_class_surface_darts(request, *path_class_engine(request)));
    }
    EXPECT_TRUE(are_equal(sets[0].points, sets[1].points));
    EXPECT_EQ(sets[0].classes, sets[1].classes);
}

}
}
