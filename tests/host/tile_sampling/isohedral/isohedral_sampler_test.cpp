// Points that an isohedral tiling repeats: their distances by brute force, their periods, and the peaks of their
// spectrum.
#include "host/tile_sampling/isohedral/isohedral_sampler.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/settings/sampler_registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace poissonlab {
namespace {

struct RepeatedSet
{
    IsohedralTile tile;
    std::vector<PlanePoint> repeated;
    double min_distance;
};

RepeatedSet repeated_set(int type, std::size_t count)
{
    IsohedralTile tile = random_tile(isohedral_types()[static_cast<std::size_t>(type - 1)], 3, 0.3, 0.12);
    const double distance = 0.6 * max_min_distance(count, 2) * std::sqrt(area_of(tile.outline()));
    auto points = repeated_points(tile, count, distance, 5, 0);
    return {std::move(tile), std::move(points), distance};
}

/// All points of the tiles that may be in a square around the origin.
std::vector<PlanePoint> points_near(const RepeatedSet& set, double reach)
{
    std::vector<PlanePoint> all;
    for (const TilePlace& place : set.tile.tiles_near({-reach, -reach}, {reach, reach}))
        for (const PlanePoint& point : set.repeated) all.push_back(set.tile.motion(place)(point));
    return all;
}

double distance_between(const PlanePoint& a, const PlanePoint& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

TEST(RepeatedPoints, KeepTheirDistanceInTheWholeTiling)
{
    for (const int type : {1, 5, 16, 28, 43, 77}) { // with and without mirrors; tiles with symmetries
        const RepeatedSet set = repeated_set(type, 12);
        ASSERT_EQ(set.repeated.size(), 12) << type;
        const auto points = points_near(set, 3 * std::sqrt(area_of(set.tile.outline())));
        ASSERT_GT(points.size(), 200);
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                ASSERT_GE(distance_between(points[i], points[j]), set.min_distance * (1 - 1e-9)) << type;
    }
}

TEST(RepeatedPoints, AreTheSameForTheSameSeed)
{
    const IsohedralTile tile(isohedral_types()[27], {});
    const auto points = repeated_points(tile, 8, 0.1, 1, 2);
    EXPECT_EQ(points, repeated_points(tile, 8, 0.1, 1, 2));
    EXPECT_NE(points, repeated_points(tile, 8, 0.1, 1, 3));
    EXPECT_NE(points, repeated_points(tile, 8, 0.1, 2, 2));
    EXPECT_LT(repeated_points(tile, 1000, 1, 1, 2).size(), 1000) << "no more fit";
}

PointSet sampled(std::size_t points, const std::string& key = "type", std::int64_t value = 28)
{
    const SamplerSpec& spec = *find_sampler("isohedral-tiles");
    Parameters parameters(spec.parameters);
    parameters.set(key, value);
    return spec.create(parameters, {points, 2, 9}, Engine::reference, {})->sample(0);
}

TEST(IsohedralTiles, HaveAboutAsManyPointsAsAreAskedFor)
{
    for (const std::int64_t type : {1, 28, 93})
        for (const std::size_t points : {1000U, 16384U}) {
            const PointSet set = sampled(points, "type", type);
            // A border of one tile is cut: points there are 2 sqrt(points per tile) on a length of a spacing.
            EXPECT_NEAR(static_cast<double>(set.size()), static_cast<double>(points),
                        4 * std::sqrt(32.0 * std::sqrt(points)));
            for (const double x : set.coordinates) ASSERT_TRUE(x >= 0 && x < 1);
        }
}

/// A window of one point's room is between points as often as not: no set is without points.
TEST(IsohedralTiles, OfFewPointsAreNotEmpty)
{
    const SamplerSpec& spec = *find_sampler("isohedral-tiles");
    for (const std::size_t points : {1, 2, 3}) {
        const auto sampler = spec.create(Parameters(spec.parameters), {points, 2, 9}, Engine::reference, {});
        for (std::uint32_t realization = 0; realization < 60; ++realization)
            EXPECT_GE(sampler->sample(realization).size(), 1U) << points << ", " << realization;
    }
}

TEST(IsohedralTiles, HavePeaksAtTheLatticeOfTheirTranslations)
{
    const std::size_t asked = 4096;
    const PointSet set = sampled(asked);
    const IsohedralTile tile(isohedral_types()[27], {});
    const double side = std::sqrt(static_cast<double>(asked) * area_of(tile.outline()) / 32);
    const auto& [a, b] = tile.translations();
    const double determinant = a[0] * b[1] - a[1] * b[0];
    double highest = 0;
    for (int h = 0; h <= 6; ++h)
        for (int k = -6; k <= 6; ++k) {
            if (h == 0 && k <= 0) continue;
            // Frequencies f with f . a = h and f . b = k; for points of a unit square, times the side.
            const double fx = side * (h * b[1] - k * a[1]) / determinant,
                         fy = side * (k * a[0] - h * b[0]) / determinant;
            std::complex<double> sum = 0;
            for (std::size_t i = 0; i < set.size(); ++i)
                sum += std::polar(1.0, 2 * std::numbers::pi * (fx * set[i][0] + fy * set[i][1]));
            highest = std::max(highest, std::norm(sum) / static_cast<double>(set.size()));
        }
    // Independent points have exponentially distributed powers of mean 1: one of 84 is above 30 once in 10^11.
    EXPECT_GT(highest, 30);
}

TEST(IsohedralTiles, RefuseTypesThatNeedMarkings)
{
    const SamplerSpec& spec = *find_sampler("isohedral-tiles");
    Parameters parameters(spec.parameters);
    parameters.set("type", std::int64_t{19});
    EXPECT_THROW(spec.check(parameters, {}, {}), std::exception);
    parameters.set("type", std::int64_t{28});
    EXPECT_NO_THROW(spec.check(parameters, {}, {}));
}

}
}
