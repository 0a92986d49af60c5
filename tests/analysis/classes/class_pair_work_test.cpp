// Nearest distances between classes are compared with those of all pairs. Pairs are counted, work on them stops when
// the user asks for it, and its results do not depend on the number of threads.
#include "analysis/classes/class_pairs.hpp"

#include "base/programs/interrupt.hpp"
#include "base/programs/interrupt_scope.hpp"
#include "tests/analysis/classes/class_sets.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace poissonlab {
namespace {

/// Compares the distances from nearest points on a torus with those of all pairs. A point's own copies do not count.
void expect_nearest(const PointSet& a, const PointSet& b, const PeriodicBox& box)
{
    double least = std::numeric_limits<double>::infinity(), sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (&a == &b && i == j) continue;
            double x = std::abs(a[i][0] - b[j][0]), y = std::abs(a[i][1] - b[j][1]);
            x = std::min(x, 1 - x) * box.sides[0], y = std::min(y, 1 - y) * box.sides[1];
            nearest = std::min(nearest, std::hypot(x, y));
        }
        least = std::min(least, nearest);
        sum += nearest;
    }
    const CrossNearest found = cross_nearest(a, b, ClassPlace(box));
    if (std::isinf(least)) {
        EXPECT_EQ(found.least, least);
        EXPECT_EQ(found.mean, least);
        return;
    }
    EXPECT_NEAR(found.least, least, 1e-13);
    EXPECT_NEAR(found.mean, sum / static_cast<double>(a.size()), 1e-13);
}

TEST(ClassPairs, NearestDistancesAreThoseOfAllPairs)
{
    std::mt19937_64 random(4);
    const std::vector<double> sides{1, 7}, longest{100, 1};
    for (const PeriodicBox& box : {PeriodicBox{}, periodic_box(sides), periodic_box(longest)})
        for (const auto& [n, m] : {std::pair{1, 1}, {5, 1}, {2, 3}, {40, 300}}) {
            const PointSet a = random_class_set(static_cast<std::size_t>(n), random),
                           b = random_class_set(static_cast<std::size_t>(m), random);
            expect_nearest(a, b, box);
            expect_nearest(a, a, box);
            expect_nearest(b, b, box);
        }
    const PointSet none{2, {}}, one{2, {0.5, 0.5}}, copied{2, {0.5, 0.5}};
    EXPECT_EQ(cross_nearest(none, one, ClassPlace(PeriodicBox{})).mean, std::numeric_limits<double>::infinity());
    EXPECT_EQ(cross_nearest(one, one, ClassPlace(PeriodicBox{})).mean, std::numeric_limits<double>::infinity());
    EXPECT_EQ(cross_nearest(one, copied, ClassPlace(PeriodicBox{})).mean, 0);
    EXPECT_TRUE(std::isnan(class_pair_correlation(one, one, ClassPlace(PeriodicBox{}),
                                                  class_distance_steps(ClassPlace(PeriodicBox{}), 1))[0]));
}

TEST(ClassPairs, AreCountedOnce)
{
    std::mt19937_64 random(11);
    const PointSet a = random_class_set(90, random), b = random_class_set(50, random);
    const ClassPlace place = class_rectangle(1);
    const ClassDistanceSteps steps = class_distance_steps(place, 140);
    const double reach = steps.reach() + steps.half_width;
    double own = 0, cross = 0, summed = -1;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) own += std::hypot(a[i][0] - a[j][0], a[i][1] - a[j][1]) <= reach;
        for (std::size_t j = 0; j < b.size(); ++j) cross += std::hypot(a[i][0] - b[j][0], a[i][1] - b[j][1]) <= reach;
    }
    const std::vector<double> g = class_pair_correlation(a, a, place, steps, &summed);
    EXPECT_EQ(summed, own);
    EXPECT_EQ(class_pair_correlation(a, a, place, steps), g);
    class_pair_correlation(a, b, place, steps, &summed);
    EXPECT_EQ(summed, cross);
    const PointSet none{2, {}};
    class_pair_correlation(none, b, place, steps, &summed);
    EXPECT_EQ(summed, 0);
}

TEST(ClassPairs, StopWhenTheUserAsksForIt)
{
    std::mt19937_64 random(12);
    const PointSet a = random_class_set(30, random);
    const std::vector<std::uint8_t> classes = [] {
        std::vector<std::uint8_t> some(30);
        for (std::size_t i = 0; i < some.size(); ++i) some[i] = i % 2;
        return some;
    }();
    const ClassPlace place = class_rectangle(1);
    const ClassDistanceSteps steps = class_distance_steps(place, a.size());
    {
        const InterruptScope scope;
        std::raise(SIGINT);
        EXPECT_THROW(class_pair_correlation(a, a, place, steps), Interrupted);
        EXPECT_THROW(cross_nearest(a, a, place), Interrupted);
        EXPECT_THROW(mark_correlation(a, classes, place, steps, 1), Interrupted);
    }
    const InterruptScope forgets; // the signal
}

TEST(ClassPairs, AreTheSameBytesOnAnyNumberOfThreads)
{
    std::mt19937_64 random(8);
    const PointSet a = random_class_set(500, random), b = random_class_set(700, random);
    const ClassPlace place{PeriodicBox{}};
    const ClassDistanceSteps steps = class_distance_steps(place, 1200);
    const std::vector<double> g = class_pair_correlation(a, b, place, steps);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(class_pair_correlation(a, b, place, steps), g);
}

}
}
