// Dart throwing with classes in regions: the kernel equals the reference, points lie inside and keep their distances,
// sets are saturated (for candidates that are found without cells), and points fall uniformly.
#include "host/sampling/classes/class_darts.hpp"

#include "base/geometry/torus.hpp"
#include "tests/support/named_region.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

struct ClassRegionCase
{
    std::string region;
    std::vector<double> distances;   ///< of the torus
    std::vector<std::size_t> points; ///< empty: to saturation
    double margin = 0;
    double factor = 1;
};

void PrintTo(const ClassRegionCase& c, std::ostream* out)
{
    *out << c.region << ", " << c.distances.size() << " classes from " << c.distances.front() << ", "
         << (c.points.empty() ? "saturated" : "to numbers") << (c.margin > 0 ? ", margin" : "")
         << (c.factor < 1 ? ", relaxed" : "");
}

ClassDartRequest request_of(const ClassRegionCase& c, std::uint32_t realization = 0)
{
    ClassDartRequest request{.dimension = 2,
                             .distances = wei_distances(c.distances, 2),
                             .shares = {},
                             .points = c.points,
                             .factor = c.factor,
                             .stream = stream_key(5, Purpose::class_darts, realization),
                             .region = std::make_shared<const FixedRegion>(test::named_region(c.region), c.margin)};
    for (const double d : c.distances) request.shares.push_back(1 / (d * d));
    if (!c.points.empty()) request.shares.assign(c.points.begin(), c.points.end());
    return request;
}

TorusPoint<2> fixed(const PointSet& points, std::size_t i)
{
    return {static_cast<std::uint32_t>(points[i][0] * 0x1p32), static_cast<std::uint32_t>(points[i][1] * 0x1p32)};
}

/// The distance of two positions, in sides of the torus, through the plane.
double gap(const TorusPoint<2>& a, const TorusPoint<2>& b)
{
    return std::hypot(double{a[0] * 1.0 - b[0]}, double{a[1] * 1.0 - b[1]}) * 0x1p-32;
}

class ClassRegionSets : public testing::TestWithParam<ClassRegionCase>
{
};

TEST_P(ClassRegionSets, AreTheSameByKernels)
{
    for (std::uint32_t realization = 0; realization < 2; ++realization) {
        const ClassDartRequest request = request_of(GetParam(), realization);
        const ClassedPoints expected = reference::throw_class_darts(request);
        EXPECT_EQ(ClassDartThrower(Device::open()).throw_darts(request), expected);
        EXPECT_EQ(ClassDartThrower(Device::open(), 7).throw_darts(request), expected);
    }
}

TEST_P(ClassRegionSets, LieInsideAndKeepDistances)
{
    const ClassDartRequest request = request_of(GetParam());
    const ClassedPoints set = reference::throw_class_darts(request);
    const ClassDistances kept = request.distances.scaled(set.scale);
    for (std::size_t i = 0; i < set.classes.size(); ++i) {
        const TorusPoint<2> at = fixed(set.points, i);
        EXPECT_TRUE(request.region->contains_plainly(at)) << i;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(gap(at, fixed(set.points, j)), kept.at(set.classes[i], set.classes[j]) * (1 - 1e-9))
                << i << " and " << j;
    }
    if (!GetParam().points.empty()) {
        EXPECT_EQ(set.counts(), GetParam().points);
    }
}

/// A position inside that no point is too near to would show that a full class has room.
TEST_P(ClassRegionSets, AreSaturatedWhereTheySaySo)
{
    const ClassDartRequest request = request_of(GetParam());
    const ClassedPoints set = reference::throw_class_darts(request);
    const FixedBox& box = request.region->extent();
    std::mt19937_64 random(3);
    std::uniform_int_distribution<std::uint32_t> x(box.low[0], box.high[0]), y(box.low[1], box.high[1]);
    for (std::uint32_t own = 0; own < set.is_full.size(); ++own) {
        EXPECT_EQ(set.is_full[own], GetParam().points.empty());
        for (std::size_t k = 0; set.is_full[own] && k < 20'000; ++k) {
            const TorusPoint<2> candidate{x(random), y(random)};
            if (!request.region->contains_plainly(candidate)) continue;
            bool is_free = true;
            for (std::size_t i = 0; is_free && i < set.classes.size(); ++i)
                is_free =
                    gap(candidate, fixed(set.points, i)) >= request.distances.at(own, set.classes[i]) * (1 + 1e-9);
            EXPECT_FALSE(is_free) << own << " at " << candidate[0] << ", " << candidate[1];
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Small, ClassRegionSets,
    testing::Values(ClassRegionCase{"star7", {0.06, 0.03, 0.03}, {}}, ClassRegionCase{"star9", {0.05, 0.02}, {20, 100}},
                    ClassRegionCase{"star30", {0.1, 0.02, 0.05}, {}, 0.01},
                    ClassRegionCase{"star5", {0.3, 0.1}, {10, 60}, 0, 0.95},
                    // The distance is larger than the region, which has room for one point of each class at most.
                    ClassRegionCase{"star6", {0.5, 0.5}, {}},
                    // The corridor is thinner than the distances, and its end is one position high.
                    ClassRegionCase{"POLYGON ((0 0, 1000 0, 1000 3, 0 1, 0 0))", {0.02, 0.004}, {}}));

/// Random regions, distances, margins and work-groups, some without room for a point.
TEST(ClassRegionDarts, AreTheSameByKernelsInRandomRegions)
{
    std::mt19937_64 random(11);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const Device device = Device::open();
    std::size_t empty = 0;
    for (int k = 0; k < 60; ++k) {
        ClassRegionCase c{"star" + std::to_string(5 + k % 30), {}, {}};
        const auto classes = static_cast<std::size_t>(1 + k % 4);
        for (std::size_t i = 0; i < classes; ++i) c.distances.push_back(std::exp(uniform(-4.5, -0.7)));
        if (k % 3 == 1)
            for (std::size_t i = 0; i < classes; ++i) c.points.push_back(1 + random() % 20);
        if (k % 4 == 2) c.margin = uniform(0, 0.3);
        if (k % 6 == 1) c.factor = 0.9;
        const ClassDartRequest request = request_of(c, static_cast<std::uint32_t>(k));
        const ClassedPoints expected = reference::throw_class_darts(request);
        empty += expected.classes.empty();
        EXPECT_EQ(ClassDartThrower(device, 1 + random() % 64).throw_darts(request), expected) << k;
    }
    EXPECT_GT(empty, 0U);
    EXPECT_LT(empty, 20U);
}

/// A rectangle twice as wide as high is half a torus wide: its middle is an eighth away from the nearest edge.
TEST(ClassRegionDarts, AreNoneWhereMarginsLeaveNothing)
{
    for (const std::vector<std::size_t>& points : {std::vector<std::size_t>{}, std::vector<std::size_t>{3, 4}}) {
        const ClassDartRequest request = request_of({"POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))", {0.3, 0.1}, points, 0.2});
        const ClassedPoints set = reference::throw_class_darts(request);
        EXPECT_TRUE(set.classes.empty());
        EXPECT_TRUE(set.is_full[0] && set.is_full[1]);
        EXPECT_EQ(ClassDartThrower(Device::open()).throw_darts(request), set);
    }
}

/// The first point of a set falls uniformly: its mean over many sets is the centroid of an L, (5/6, 5/6), within five
/// standard errors; the variance along an axis of the L of three unit squares is 11/36.
TEST(ClassRegionDarts, FallUniformly)
{
    const ClassRegionCase c{"POLYGON ((0 0, 2 0, 2 1, 1 1, 1 2, 0 2, 0 0))", {0.3, 0.1}, {1, 1}};
    constexpr std::uint32_t sets = 4000;
    std::array<double, 2> sum{};
    for (std::uint32_t i = 0; i < sets; ++i) {
        const ClassDartRequest request = request_of(c, i);
        const ClassedPoints set = reference::throw_class_darts(request);
        for (std::size_t k = 0; k < 2; ++k) sum[k] += request.region->own(fixed(set.points, 0))[k] / sets;
    }
    for (const double mean : sum) EXPECT_NEAR(mean, 5.0 / 6, 5 * std::sqrt(11.0 / 36 / sets));
}

}
}
