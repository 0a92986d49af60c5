// Pairs on meshes are compared with the plane's pair correlation, with the closed form of the sphere and with random
// points.
#include "host/distribution/surface_spectra/mesh_pairs.hpp"

#include "base/random/random.hpp"
#include "host/distribution/surfaces/given_points.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/sampling/surfaces/surface_elimination.hpp"
#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

/// A mesh with random points, and pairs on it.
class PairMesh
{
public:
    explicit PairMesh(const TriangleMesh& mesh)
        : surface_(fixed_surface(mesh)),
          mesh_(triangles_of(surface_)), ground_{surface_, mesh_, random_points(20'000, 99), least_cosine(180)}
    {}

    const FixedSurface& surface() const { return surface_; }

    std::vector<SurfacePoint> random_points(std::size_t count, std::uint64_t seed) const
    {
        return surface_candidates(surface_, count, stream_key(seed, Purpose::surface_candidates, 0));
    }

    MeshPairs pairs(const std::vector<SurfacePoint>& points, const PartsOfPoints& parts = {}) const
    {
        return pairs_on_mesh(ground_, points, parts, 1);
    }

private:
    FixedSurface surface_;
    TriangleMesh mesh_;
    PairGround ground_;
};

/// The pairs of points nearer than a bin's ends, by looking at all of them: through space or by angle on a sphere.
template <class Distance>
double pairs_between(const std::vector<MeshPoint>& places, double low, double high, const Distance& distance)
{
    double pairs = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (const double d = distance(places[i], places[j]); d >= low && d < high) ++pairs;
    return pairs;
}

double space_distance(const MeshPoint& a, const MeshPoint& b)
{
    const MeshPoint d = difference(a, b);
    return std::sqrt(dot(d, d));
}

std::vector<MeshPoint> places_of(const FixedSurface& surface, const std::vector<SurfacePoint>& points)
{
    const PointSet set = points_of(surface, points);
    std::vector<MeshPoint> places;
    for (std::size_t i = 0; i < set.size(); ++i) places.push_back({set[i][0], set[i][1], set[i][2]});
    return places;
}

/// Independent points have g = 1 at all distances, whatever the mesh: deviations are some errors at most.
TEST(MeshPairs, OfRandomPointsAreOne)
{
    for (const auto& mesh : {sphere_mesh(16), square_mesh(6), sheet_mesh(0.05)}) {
        const PairMesh on(mesh);
        PartsOfPoints parts{{}, 4};
        for (std::uint32_t i = 0; i < 600; ++i) parts.of_point.push_back(i % 4);
        const MeshPairs pairs = on.pairs(on.random_points(600, 3), parts);
        EXPECT_EQ(pairs.sources, 600U);
        for (const auto* bins : {&pairs.in_space, &pairs.along}) {
            ASSERT_EQ(bins->size(), pair_bins);
            double squares = 0;
            for (const PairCorrelationBin& bin : *bins) {
                EXPECT_NEAR(bin.value, 1, 4.5 * std::max(bin.standard_error, 1 / std::sqrt(bin.pairs + 1)));
                squares += std::pow((bin.value - 1) / bin.standard_error, 2);
            }
            // Chi-square of 80 bins that are nearly independent.
            EXPECT_NEAR(squares, 80, 5 * std::sqrt(160));
        }
        ASSERT_FALSE(pairs.localised.empty());
        for (const PairCorrelationBin& bin : pairs.localised)
            if (bin.pairs > 400) {
                EXPECT_NEAR(bin.value, 1, 0.25);
            }
        for (const auto& [distance, db] : pairs.anisotropy) EXPECT_LT(db, 10 * std::log10(34.0 / 11)) << distance;
    }
}

/// On the unit sphere the share of pairs with angles from a to b is (cos a - cos b) / 2, along the surface; of chords
/// it is (b^2 - a^2) / 4. Lengths on this mesh of squares of side pi / 64 are shorter than arcs by less than the part
/// diagonal^2 / 8 by which places lie within the sphere.
TEST(MeshPairs, OnASphereFollowItsClosedForm)
{
    const TriangleMesh mesh = sphere_mesh(64);
    const PairMesh on(mesh);
    const std::size_t count = 400;
    MeshPointSettings settings;
    settings.read = std::make_shared<const SurfaceMesh>(SurfaceMesh{mesh, on.surface()});
    settings.points = count;
    const auto points = make_surface_set(settings, 5, {.engine = Engine::reference, .device = {}}).points;
    const MeshPairs pairs = on.pairs(points);
    ASSERT_EQ(pairs.sources, count);
    const std::vector<MeshPoint> places = places_of(on.surface(), points);
    const double all = 0.5 * static_cast<double>(count) * (count - 1), width = farthest_pair / pair_bins * pairs.unit;
    const double shorter = std::pow(std::numbers::pi / 64, 2) / 4;
    const auto arc = [](const MeshPoint& a, const MeshPoint& b) {
        return 2 * std::asin(space_distance(unit(a), unit(b)) / 2);
    };
    for (std::size_t k = 0; k < pair_bins; ++k) {
        const double low = static_cast<double>(k) * width, high = low + width;
        EXPECT_LE(pairs.along[k].pairs, pairs_between(places, low, high / (1 - shorter), arc)) << k;
        EXPECT_GE(pairs.along[k].pairs, pairs_between(places, low / (1 - shorter), high, arc)) << k;
        EXPECT_EQ(pairs.in_space[k].pairs, pairs_between(places, low, high, space_distance)) << k;
        // g is known as well as 20,000 random points have counts, and the area of a ring to twice that part.
        const auto expect_closed = [&](const PairCorrelationBin& bin, double share) {
            const double error = 4.5 / std::sqrt(share * count * 20'000) + 2 * shorter;
            EXPECT_NEAR(bin.value, bin.pairs / (all * share), error * bin.value) << k;
        };
        expect_closed(pairs.along[k], (std::cos(low) - std::cos(high)) / 2);
        expect_closed(pairs.in_space[k], (high * high - low * low) / 4);
    }
}

/// On a flat mesh paths are straight: both functions are that of space, and differences are those of coordinates.
TEST(MeshPairs, OnAPlaneAreThoseOfSpace)
{
    const PairMesh on(square_mesh(5, 2));
    const MeshPairs pairs = on.pairs(on.random_points(300, 8));
    for (std::size_t k = 0; k < pair_bins; ++k) {
        EXPECT_NEAR(pairs.along[k].pairs, pairs.in_space[k].pairs, 1) << "a pair may lie on the end of a bin";
        EXPECT_NEAR(pairs.along[k].value, pairs.in_space[k].value, 0.02 + 2 / (1 + pairs.in_space[k].pairs));
    }
}

/// A lattice has its differences at lattice places, and its rings are far from isotropic.
TEST(MeshPairs, OfALatticeHavePeaks)
{
    const PairMesh on(square_mesh(1));
    std::vector<SurfacePoint> lattice;
    for (const std::uint32_t t : {0u, 1u})
        for (std::uint32_t i = 0; i < 30; ++i)
            for (std::uint32_t j = 0; j < 30; ++j) {
                const double x = (i + 0.5) / 30, y = (j + 0.5) / 30;
                if ((y > x) != (t == 1)) continue;
                // Triangle 0 is (0,0), (1,0), (1,1), triangle 1 (0,0), (1,1), (0,1).
                const double second = t == 0 ? x - y : x, third = t == 0 ? y : y - x;
                SurfacePoint point{};
                point.triangle = t;
                point.shares[0] = static_cast<std::uint32_t>(std::ldexp(second, 31));
                point.shares[1] = static_cast<std::uint32_t>(std::ldexp(third, 31));
                const MeshPlace place = place_on(on.surface().triangles[t], point.shares[0], point.shares[1]);
                for (std::size_t k = 0; k < 3; ++k) point.place[k] = static_cast<int>(place[k]);
                lattice.push_back(point);
            }
    const MeshPairs pairs = on.pairs(lattice);
    const double step = 1.0 / 30 / pairs.unit;
    EXPECT_NEAR(*pairs.least_along, step, 1e-6);
    EXPECT_NEAR(pairs.nearest_along, step, 1e-6);
    ASSERT_FALSE(pairs.anisotropy.empty());
    for (const auto& [distance, db] : pairs.anisotropy) EXPECT_GT(db, 10) << distance;
    // The differences of neighbours lie on both axes, none on the diagonals at that distance.
    const auto density = [&](double x, double y) {
        const double scale = difference_squares / (2 * farthest_pair);
        return pairs.differences[static_cast<std::size_t>((farthest_pair - y) * scale) * difference_squares +
                                 static_cast<std::size_t>((farthest_pair + x) * scale)];
    };
    for (const double sign : {-1.0, 1.0}) {
        EXPECT_GT(density(sign * step, 0), 5);
        EXPECT_GT(density(0, sign * step), 5);
        EXPECT_LT(density(sign * step * std::numbers::sqrt2 / 2, step * std::numbers::sqrt2 / 2), 0.1);
    }
}

/// Two points on two sides of a thin sheet are far apart along the surface if the sheet is closed, and have no path if
/// not.
TEST(MeshPairs, OfTwoAndThreePoints)
{
    const PairMesh on(sheet_mesh(0.01));
    for (const std::size_t count : {2u, 3u}) {
        const auto points = on.random_points(count, 4);
        const MeshPairs pairs = on.pairs(points);
        EXPECT_EQ(pairs.sources, count);
        EXPECT_FALSE(pairs.in_space.empty());
        for (const PairCorrelationBin& bin : pairs.along) EXPECT_TRUE(std::isfinite(bin.value));
        const std::string csv = mesh_pairs_csv(pairs);
        EXPECT_EQ(std::ranges::count(csv, '\n'), pair_bins + 1);
    }
}

/// Many points on few triangles: paths start from a part of them, because each looks at all points of its triangle.
TEST(MeshPairs, OfManyPointsOnTwoTriangles)
{
    const PairMesh on(square_mesh(1));
    const MeshPairs pairs = on.pairs(on.random_points(40'000, 5));
    EXPECT_LT(pairs.sources, 36'000U);
    EXPECT_GT(pairs.sources, 28'000U); // 1e8 windows, over a tenth of half of the 60,000 points
    for (const PairCorrelationBin& bin : pairs.along) EXPECT_NEAR(bin.value, 1, 5 * bin.standard_error);
}

/// A density that differs from part to part looks like an attraction, except to the localised function.
TEST(MeshPairs, AreLocalisedWhereDensitiesDiffer)
{
    const PairMesh on(square_mesh(12));
    std::vector<SurfacePoint> points;
    PartsOfPoints parts{{}, 4};
    std::mt19937 random(1);
    for (const SurfacePoint& p : on.random_points(2400, 6)) {
        const double x = on.surface().origin[0] + p.place[0] * on.surface().unit;
        const auto part = static_cast<std::uint32_t>(std::min(3.0, x * 4));
        if (part >= 2 || random() % 2 == 0) points.push_back(p), parts.of_point.push_back(part);
    }
    const MeshPairs pairs = on.pairs(points, parts);
    double along = 0, local = 0;
    for (std::size_t k = 10; k < 40; ++k) along += pairs.along[k].value / 30, local += pairs.localised[k].value / 30;
    EXPECT_GT(along, 1.08);
    EXPECT_NEAR(local, 1, 0.03);
}

}
}
