// Dart throwing with classes: the matrix against its formula, kernels against their twin, distances of all pairs, the
// order of classes, where points fall, and saturation by places where a gap would show.
#include "host/sampling/classes/class_darts.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

TEST(ClassDistances, KeepTheDensityOfAllClassesSoFar)
{
    // Two classes of equal distance are, together, twice as dense.
    const ClassDistances equal = wei_distances({0.2, 0.2}, 2);
    EXPECT_DOUBLE_EQ(equal.at(0, 0), 0.2);
    EXPECT_DOUBLE_EQ(equal.at(1, 0), 0.2 / std::sqrt(2));
    EXPECT_DOUBLE_EQ(wei_distances({0.2, 0.2}, 3).at(0, 1), 0.2 / std::cbrt(2));
    // Densities 100, 25 and 100: the class of 0.2 comes first, then both of 0.1 together.
    const ClassDistances three = wei_distances({0.1, 0.2, 0.1}, 2);
    for (const auto& [i, j] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}})
        EXPECT_DOUBLE_EQ(three.at(i, j), 1 / std::sqrt(225.0)) << i << j;
    EXPECT_EQ(three.at(1, 1), 0.2);
    // One after the other: 1, 1 + 4, 1 + 4 + 16.
    const ClassDistances steps = wei_distances({0.25, 0.5, 1}, 2);
    EXPECT_DOUBLE_EQ(steps.at(1, 2), 1 / std::sqrt(5.0));
    EXPECT_DOUBLE_EQ(steps.at(0, 2), 1 / std::sqrt(21.0));
    EXPECT_DOUBLE_EQ(steps.at(0, 1), 1 / std::sqrt(21.0));
}

struct ClassCase
{
    int dimension;
    std::vector<double> distances;
    std::vector<std::size_t> points; ///< empty: to saturation
    double between = 0;              ///< of all pairs of classes; 0: by Wei's matrix
    double factor = 1;
};

void PrintTo(const ClassCase& c, std::ostream* out)
{
    *out << c.dimension << "D, " << c.distances.size() << " classes from " << c.distances.front() << ", "
         << (c.points.empty() ? "saturated" : "to numbers") << (c.between > 0 ? ", own matrix" : "")
         << (c.factor < 1 ? ", relaxed" : "");
}

ClassDartRequest request_of(const ClassCase& c, std::uint32_t realization = 0)
{
    ClassDartRequest request{.dimension = c.dimension,
                             .distances = wei_distances(c.distances, c.dimension),
                             .shares = {},
                             .points = c.points,
                             .factor = c.factor,
                             .stream = stream_key(5, Purpose::class_darts, realization)};
    for (const double d : c.distances) request.shares.push_back(std::pow(d, -c.dimension));
    if (!c.points.empty()) request.shares.assign(c.points.begin(), c.points.end());
    for (std::size_t i = 0; c.between > 0 && i < c.distances.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) request.distances.set(i, j, c.between);
    return request;
}

/// The least distance of points of two classes, from all pairs, in exact integers until the root.
double least_distance(const ClassedPoints& set, std::uint32_t a, std::uint32_t b)
{
    std::uint64_t least = UINT64_MAX;
    const auto fixed = [&](std::size_t i) {
        std::array<std::uint32_t, 3> p{};
        for (std::size_t k = 0; k < set.points[i].size(); ++k)
            p[k] = static_cast<std::uint32_t>(set.points[i][k] * 0x1p32);
        return p;
    };
    for (std::size_t i = 0; i < set.classes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if ((set.classes[i] == a && set.classes[j] == b) || (set.classes[i] == b && set.classes[j] == a))
                least = std::min(least, squared_distance<3>(fixed(i), fixed(j)));
    return std::sqrt(static_cast<double>(least)) * 0x1p-32;
}

class ClassDartSets : public testing::TestWithParam<ClassCase>
{
};

TEST_P(ClassDartSets, AreTheSameByKernels)
{
    const ClassDartRequest request = request_of(GetParam());
    const ClassedPoints expected = reference::throw_class_darts(request);
    ClassDartThrower thrower(Device::open());
    EXPECT_EQ(thrower.throw_darts(request), expected);
    // Buffers are used again, work-groups have another size.
    EXPECT_EQ(ClassDartThrower(Device::open(), 16).throw_darts(request), expected);
    EXPECT_EQ(thrower.throw_darts(request_of(GetParam(), 1)), reference::throw_class_darts(request_of(GetParam(), 1)));
}

TEST_P(ClassDartSets, KeepTheDistanceOfEachPair)
{
    const ClassedPoints set = reference::throw_class_darts(request_of(GetParam()));
    const ClassDistances distances = request_of(GetParam()).distances.scaled(set.scale);
    for (std::uint32_t a = 0; a < distances.classes(); ++a)
        for (std::uint32_t b = 0; b <= a; ++b) {
            EXPECT_GE(least_distance(set, a, b), distances.at(a, b) * (1 - 1e-15)) << a << " and " << b;
            // Many points come near to it; few need not.
            if (set.points.size() > 500) {
                EXPECT_LT(least_distance(set, a, b), distances.at(a, b) * 1.2) << a << " and " << b;
            }
        }
}

/// This holds the sentence of docs/classes.md about a prefix of n points, n_i of class i, whose share is p: n_i is at
/// most n p + 1 - p, and at least n p - p for each other class. Let t be the part of the least filled class. The last
/// point of any other one came when it was the least filled, so n_i is from t w_i to t w_i + 1, for all of W points w_i
/// of the class; n is the sum.
void expect_shares(const std::vector<std::size_t>& counts, const std::vector<std::size_t>& points)
{
    const auto all = std::accumulate(points.begin(), points.end(), std::int64_t{0}),
               now = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto own = static_cast<std::int64_t>(points[i]);
        const std::int64_t off = static_cast<std::int64_t>(counts[i]) * all - now * own; // times all points
        EXPECT_LE(off, all - own);
        EXPECT_GE(off, -own * static_cast<std::int64_t>(counts.size() - 1));
    }
}

TEST_P(ClassDartSets, FillClassesEvenly)
{
    const ClassCase& c = GetParam();
    const ClassedPoints set = reference::throw_class_darts(request_of(c));
    if (c.points.empty()) {
        for (std::size_t i = 0; i < c.distances.size(); ++i) EXPECT_TRUE(set.is_full[i]);
        return;
    }
    EXPECT_EQ(set.counts(), c.points);
    std::vector<std::size_t> counts(c.points.size());
    for (const std::uint32_t own : set.classes) {
        for (std::size_t i = 0; i < counts.size(); ++i) // the one that comes is filled least
            EXPECT_LE(counts[own] * c.points[i], counts[i] * c.points[own]);
        ++counts[own];
        expect_shares(counts, c.points);
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, ClassDartSets,
                         testing::Values(ClassCase{2, {0.4, 0.2}, {1, 4}}, ClassCase{3, {1, 0.9}, {}},
                                         ClassCase{2, {0.9, 0.5}, {2, 5}, 0, 0.8}));
INSTANTIATE_TEST_SUITE_P(Sizes, ClassDartSets,
                         testing::Values(ClassCase{2, {0.1, 0.05, 0.025}, {40, 160, 640}},
                                         ClassCase{2, {0.1, 0.05, 0.025}, {}}, ClassCase{2, {0.03}, {}},
                                         ClassCase{2, {0.06, 0.06, 0.06, 0.06}, {}},
                                         ClassCase{2, {0.02, 0.02}, {200, 700}, 0.05}, ClassCase{3, {0.25, 0.12}, {}},
                                         ClassCase{3, {0.2, 0.2, 0.1}, {50, 50, 330}},
                                         ClassCase{2, {0.16, 0.08, 0.04}, {40, 160, 640}, 0, 0.98},
                                         ClassCase{3, {0.4, 0.24}, {40, 300}, 0, 0.95}, ClassCase{3, {0.7, 0.5}, {}}));

/// Circles of the distances that class `own` keeps cross at the corners of what they leave free. Returns how far the
/// freest of these places is from the nearest disk.
double largest_gap(const ClassedPoints& set, const ClassDistances& distances, std::uint32_t own)
{
    double largest = 0;
    const auto shortest = [](double d) { return d - std::round(d); };
    for (std::size_t i = 0; i < set.classes.size(); ++i) {
        const double r = distances.at(own, set.classes[i]);
        for (std::size_t j = 0; j < set.classes.size(); ++j) {
            const double s = distances.at(own, set.classes[j]);
            const double dx = shortest(set.points[j][0] - set.points[i][0]);
            const double dy = shortest(set.points[j][1] - set.points[i][1]), d = std::hypot(dx, dy);
            if (i == j || d > r + s || d < std::abs(r - s)) continue;
            const double along = (d * d + r * r - s * s) / (2 * d),
                         up = std::sqrt(std::max(0.0, r * r - along * along));
            const double x = set.points[i][0] + (along * dx - up * dy) / d;
            const double y = set.points[i][1] + (along * dy + up * dx) / d;
            double gap = INFINITY;
            for (std::size_t k = 0; k < set.classes.size(); ++k)
                if (k != i && k != j)
                    gap = std::min(gap, std::hypot(shortest(set.points[k][0] - x), shortest(set.points[k][1] - y)) -
                                            distances.at(own, set.classes[k]));
            largest = std::max(largest, gap);
        }
    }
    return largest;
}

TEST(SaturatedClasses, LeaveNoGap)
{
    const ClassDartRequest request = request_of({2, {0.2, 0.1, 0.06}, {}});
    const ClassedPoints set = reference::throw_class_darts(request);
    for (std::uint32_t own = 0; own < 3; ++own) EXPECT_LT(largest_gap(set, request.distances, own), 1e-7) << own;
    // The measure sees the gap that a point leaves that is taken away.
    ClassedPoints less = set;
    less.points.coordinates.resize(2 * less.classes.size() - 2);
    const std::uint32_t last = less.classes.back();
    less.classes.pop_back();
    EXPECT_GT(largest_gap(less, request.distances, last), 1e-4);
}

/// Had distances been a step larger at the end, the last point that needed this step would not have fitted.
TEST(RelaxedClasses, KeepTheFirstDistancesThatHaveRoomForAll)
{
    const ClassCase c{2, {0.2, 0.1}, {30, 120}, 0, 0.97};
    const ClassedPoints set = reference::throw_class_darts(request_of(c));
    EXPECT_EQ(set.counts(), c.points);
    const double steps = std::log(set.scale) / std::log(0.97);
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_GE(steps, 1);
    double nearest = INFINITY; // over the pair's distance before the last step
    for (std::uint32_t a = 0; a < 2; ++a)
        for (std::uint32_t b = 0; b <= a; ++b)
            nearest =
                std::min(nearest, least_distance(set, a, b) * 0.97 / (set.scale * request_of(c).distances.at(a, b)));
    EXPECT_LT(nearest, 1);
    // Where there is room at once, nothing changes.
    ClassCase roomy{2, {0.1, 0.05}, {30, 120}};
    const ClassedPoints as_before = reference::throw_class_darts(request_of(roomy));
    roomy.factor = 0.97;
    EXPECT_EQ(reference::throw_class_darts(request_of(roomy)), as_before);
}

/// The share of 2,000 sets whose second point has less than `within` to the first one, of two classes.
double share_within(double between, double within)
{
    int count = 0;
    for (std::uint32_t realization = 0; realization < 2000; ++realization) {
        ClassCase c{2, {0.5, 0.5}, {1, 1}, between};
        count += least_distance(reference::throw_class_darts(request_of(c, realization)), 0, 1) < within;
    }
    return count / 2000.0;
}

TEST(ClassDarts, FallUniformlyWhereThereIsRoom)
{
    const double pi = std::numbers::pi;
    const auto error = [](double p) { return 4 * std::sqrt(p * (1 - p) / 2000); };
    const double plenty = pi * (0.4 * 0.4 - 0.3 * 0.3) / (1 - pi * 0.3 * 0.3);
    EXPECT_NEAR(share_within(0.3, 0.4), plenty, error(plenty));
    // Beyond 1/2 a circle leaves four corners of the torus' square, of this area.
    const auto corners = [&](double r) {
        return 1 - (pi * r * r - 4 * (r * r * std::acos(0.5 / r) - 0.5 * std::sqrt(r * r - 0.25)));
    };
    const double few = 1 - corners(0.702) / corners(0.7);
    ASSERT_LT(corners(0.7), 1.0 / 256); // so that cells are refined
    EXPECT_NEAR(share_within(0.7, 0.702), few, error(few));
}

}
}
