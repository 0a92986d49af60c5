// Pairs of points with classes are compared with sums over all pairs and with closed forms.
#include "analysis/classes/class_pairs.hpp"

#include "tests/analysis/classes/class_sets.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace poissonlab {
namespace {

PointSet squeezed(PointSet set, double height)
{
    for (std::size_t i = 1; i < set.coordinates.size(); i += 2) set.coordinates[i] *= height;
    return set;
}

/// Returns the sum over all pairs of two sets, or of a set with itself: on a torus of `sides`, all of whose images
/// within `reach` count, or in a rectangle `box`.
std::vector<double> brute_force_g(const PointSet& a, const PointSet& b, const ClassDistanceSteps& steps,
                                  const std::array<double, 3>* sides, const RegionBox& box)
{
    const bool is_same = &a == &b;
    const double n = static_cast<double>(a.size()), m = static_cast<double>(b.size()) - is_same;
    std::vector<double> g(steps.count);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            for (int across = -1; across <= 1; ++across)
                for (int up = -1; up <= 1; ++up) {
                    if ((is_same && i == j) || (!sides && (across != 0 || up != 0))) continue;
                    double x = a[i][0] - b[j][0] + across, y = a[i][1] - b[j][1] + up;
                    if (sides) x *= (*sides)[0], y *= (*sides)[1];
                    const double area = sides ? 1 : box.width() * box.height();
                    const double common = sides ? 1 : (box.width() - std::abs(x)) * (box.height() - std::abs(y));
                    const double d = std::hypot(x, y);
                    for (std::size_t k = 0; k < steps.count; ++k) {
                        const double t = (steps.step * static_cast<double>(k + 1) - d) / steps.half_width;
                        if (std::abs(t) < 1)
                            g[k] += area * area / (n * m) / common * 0.75 * (1 - t * t) / steps.half_width /
                                    (2 * std::numbers::pi * d);
                    }
                }
    return g;
}

void expect_same(const std::vector<double>& found, const std::vector<double>& expected)
{
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_NEAR(found[k], expected[k], 1e-12 * std::max(1.0, expected[k])) << k;
}

TEST(ClassPairs, AreSumsOverAllPairs)
{
    std::mt19937_64 random(3);
    const std::vector<double> sides{3, 2};
    const PeriodicBox boxes[]{{}, periodic_box(sides)};
    for (const auto& [n, m] : {std::pair{1, 1}, {1, 2}, {2, 3}, {3, 40}, {60, 25}}) {
        const PointSet a = random_class_set(static_cast<std::size_t>(n), random),
                       b = random_class_set(static_cast<std::size_t>(m), random);
        for (const PeriodicBox& box : boxes) {
            const ClassPlace torus(box);
            const ClassDistanceSteps steps = class_distance_steps(torus, a.size() + b.size());
            expect_same(class_pair_correlation(a, b, torus, steps), brute_force_g(a, b, steps, &box.sides, {}));
            if (n > 1)
                expect_same(class_pair_correlation(a, a, torus, steps), brute_force_g(a, a, steps, &box.sides, {}));
        }
        // The frame is a little larger than the rectangle.
        for (const double height : {1.0, 0.6}) {
            const PointSet c = squeezed(a, height), d = squeezed(b, height);
            const ClassPlace region = class_rectangle(height);
            const RegionBox framed = box_of(region.region()->polygons());
            const ClassDistanceSteps steps = class_distance_steps(region, a.size() + b.size());
            expect_same(class_pair_correlation(c, d, region, steps), brute_force_g(c, d, steps, nullptr, framed));
            if (m > 1)
                expect_same(class_pair_correlation(d, d, region, steps), brute_force_g(d, d, steps, nullptr, framed));
        }
    }
}

/// A distance of curves that is longer than the place is is cut to what the place has.
TEST(ClassPairs, CurvesEndWhereThePlaceEnds)
{
    std::mt19937_64 random(10);
    const PointSet a = random_class_set(12, random);
    const ClassPlace square = class_rectangle(1), torus{PeriodicBox{}};
    const RegionBox box = box_of(square.region()->polygons());
    // A vector of length r leaves (1 - r |cos|) (1 - r |sin|) of the square: the root where this is 0.1, least of all
    // in the direction of pi / 16.
    const double c = std::cos(std::numbers::pi / 16), s = std::sin(std::numbers::pi / 16);
    const double expected = (c + s - std::sqrt((c + s) * (c + s) - 3.6 * c * s)) / (2 * c * s);
    for (const double wanted : {2.0, 5000.0, 1e12, 1e300}) {
        const ClassDistanceSteps steps = class_distance_steps(square, a.size(), wanted);
        EXPECT_NEAR(steps.reach(), expected * box.width(), std::numbers::sqrt2 / (16 * 256));
        expect_same(class_pair_correlation(a, a, square, steps), brute_force_g(a, a, steps, nullptr, box));
        EXPECT_DOUBLE_EQ(class_distance_steps(torus, a.size(), wanted).reach(), 0.5);
    }
    // Steps may be so short that a pair is more of them apart than whole numbers count.
    const ClassDistanceSteps shortest = class_distance_steps(square, a.size(), 1e-30);
    expect_same(class_pair_correlation(a, a, square, shortest), brute_force_g(a, a, shortest, nullptr, box));
}

/// Points on opposite borders have vectors that leave nothing of the region in common with itself.
TEST(ClassPairs, OfOppositeBordersAreLeftOut)
{
    constexpr double height = 0.01;
    const ClassPlace strip = class_rectangle(height);
    const RegionBox box = box_of(strip.region()->polygons());
    std::mt19937_64 random(9);
    PointSet low{2, {}}, both{2, {}};
    for (const double x : random_class_set(20, random).coordinates) {
        low.coordinates.insert(low.coordinates.end(), {x * box.width(), 0});
        both.coordinates.insert(both.coordinates.end(), {x * box.width(), 0, x * box.width(), box.high[1]});
    }
    const ClassDistanceSteps steps = class_distance_steps(strip, both.size());
    ASSERT_GT(steps.reach() + steps.half_width, box.height());
    // All pairs of the lower border count, none of both borders do.
    const std::vector<double> g = class_pair_correlation(both, both, strip, steps);
    const std::vector<double> g_low = brute_force_g(low, low, steps, nullptr, box);
    const auto n = static_cast<double>(low.size());
    ASSERT_EQ(g.size(), g_low.size());
    for (std::size_t k = 0; k < g.size(); ++k)
        EXPECT_NEAR(g[k], g_low[k] * 2 * n * (n - 1) / (2 * n * (2 * n - 1)), 1e-11 * std::max(1.0, g[k])) << k;
    const std::vector<std::uint8_t> alternating = [&] {
        std::vector<std::uint8_t> classes(both.size());
        for (std::size_t i = 0; i < classes.size(); ++i) classes[i] = i / 2 % 2;
        return classes;
    }();
    for (const double value : mark_correlation(both, alternating, strip, steps, 3).values)
        EXPECT_FALSE(std::isinf(value) || value < 0);
}

/// Independent random points have g = 1 from the kernel's half width on, in every place. 200 distances in 2 places are
/// tested, and no z-score of 20 seeds may be beyond 5 (Student's t with 19 degrees: 8e-5 twice 180 times is 0.03).
TEST(ClassPairs, OfIndependentClassesAreOne)
{
    constexpr int seeds = 20;
    for (const bool is_torus : {true, false}) {
        const ClassPlace place = is_torus ? ClassPlace(PeriodicBox{}) : class_rectangle(0.6);
        const ClassDistanceSteps steps = class_distance_steps(place, 500);
        std::vector<std::vector<double>> curves;
        for (int seed = 0; seed < seeds; ++seed) {
            std::mt19937_64 random(static_cast<std::uint64_t>(seed) + 100);
            const PointSet a = random_class_set(200, random), b = random_class_set(300, random);
            curves.push_back(
                class_pair_correlation(is_torus ? a : squeezed(a, 0.6), is_torus ? b : squeezed(b, 0.6), place, steps));
        }
        const auto first = static_cast<std::size_t>(std::ceil(steps.half_width / steps.step));
        for (std::size_t k = first; k < steps.count; k += 10) {
            double mean = 0, squares = 0;
            for (const auto& curve : curves) mean += curve[k] / seeds;
            for (const auto& curve : curves) squares += std::pow(curve[k] - mean, 2);
            EXPECT_LT(std::abs(mean - 1) / std::sqrt(squares / (seeds - 1) / seeds), 5) << k;
        }
    }
}

/// A shifted copy has n pairs at the shift, in addition to those of independent points.
TEST(ClassPairs, OfAShiftedCopyHaveTheShiftsPeak)
{
    std::mt19937_64 random(5);
    const ClassPlace torus{PeriodicBox{}};
    // The other distances of this lattice are far from the shift.
    PointSet a{2, {}};
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 20; ++y) a.coordinates.insert(a.coordinates.end(), {x / 20.0, y / 20.0});
    PointSet b = a;
    constexpr double shift = 0.015;
    for (std::size_t i = 0; i < b.coordinates.size(); i += 2)
        b.coordinates[i] = std::fmod(b.coordinates[i] + shift, 1.0);
    ClassDistanceSteps steps{.step = shift / 10, .count = 15, .half_width = 0.004};
    const std::vector<double> g = class_pair_correlation(a, b, torus, steps);
    // 1 / n^2 times n pairs of 3 / (4 h) / (2 pi shift).
    EXPECT_NEAR(g[9], 0.75 / 0.004 / (2 * std::numbers::pi * shift) / 400, 1e-9);
    EXPECT_EQ(std::ranges::max_element(g) - g.begin(), 9);
    EXPECT_EQ(g[3], 0);
}

/// With random labels, pairs of any two classes have the pair correlation of all points, and the mean of the mark
/// correlation over all labellings is exactly 1: the mean over 400 must be within five standard errors.
TEST(ClassPairs, OfRandomLabelsAreThoseOfTheUnion)
{
    std::mt19937_64 random(6);
    constexpr std::size_t points = 120, count = 400;
    const PointSet all = squeezed(random_class_set(points, random), 0.6);
    const ClassPlace place = class_rectangle(0.6);
    const ClassDistanceSteps steps = class_distance_steps(place, points);
    const std::vector<double> of_union = class_pair_correlation(all, all, place, steps);
    std::vector<std::uint8_t> labels(points);
    for (std::size_t i = 0; i < points; ++i) labels[i] = i < 50 ? 0 : i < 90 ? 1 : 2;
    std::vector<double> marks, crosses, p_values;
    for (std::size_t l = 0; l < count; ++l) {
        std::ranges::shuffle(labels, random);
        PointSet sets[2]{{2, {}}, {2, {}}};
        for (std::size_t i = 0; i < points; ++i)
            if (labels[i] < 2)
                sets[labels[i]].coordinates.insert(sets[labels[i]].coordinates.end(), all[i].begin(), all[i].end());
        const MarkCorrelation found = mark_correlation(all, labels, place, steps, l < 100 ? 19 : 0);
        marks.push_back(found.values[150]);
        crosses.push_back(class_pair_correlation(sets[0], sets[1], place, steps)[150]);
        if (l < 100) p_values.push_back(found.p_value);
        EXPECT_EQ(found.low.size(), l < 100 ? steps.count : 0);
    }
    const auto expect_mean = [&](const std::vector<double>& values, double expected) {
        double mean = 0, squares = 0;
        for (const double value : values) mean += value / count;
        for (const double value : values) squares += (value - mean) * (value - mean);
        EXPECT_LT(std::abs(mean - expected), 5 * std::sqrt(squares / (count - 1) / count));
        EXPECT_GT(squares, 0);
    };
    expect_mean(marks, 1);
    expect_mean(crosses, of_union[150]);
    // p-values are uniform over 1/20 .. 20/20: among 100, the least one occurs 5 +- 2.2 times.
    const auto least = std::ranges::count_if(p_values, [](double p) { return p < 0.051; });
    EXPECT_LE(least, 16);
}

TEST(ClassPairs, MarkCorrelationIsTheShareOfPairsOfOneClass)
{
    std::mt19937_64 random(7);
    const PointSet all = random_class_set(80, random);
    const ClassPlace place{PeriodicBox{}};
    const ClassDistanceSteps steps = class_distance_steps(place, 80);
    std::vector<std::uint8_t> labels(80);
    PointSet sets[3]{{2, {}}, {2, {}}, {2, {}}};
    for (std::size_t i = 0; i < 80; ++i) {
        labels[i] = static_cast<std::uint8_t>(all[i][0] < 0.5 ? 0 : 1 + i % 2);
        sets[labels[i]].coordinates.insert(sets[labels[i]].coordinates.end(), all[i].begin(), all[i].end());
    }
    const MarkCorrelation found = mark_correlation(all, labels, place, steps, 39);
    const std::vector<double> g = class_pair_correlation(all, all, place, steps);
    std::vector<double> expected(steps.count);
    double same = 0;
    for (const PointSet& set : sets) {
        const auto n = static_cast<double>(set.size());
        same += n * (n - 1);
        const std::vector<double> own = class_pair_correlation(set, set, place, steps);
        for (std::size_t k = 0; k < steps.count; ++k) expected[k] += n * (n - 1) * own[k];
    }
    for (std::size_t k = 0; k < steps.count; ++k)
        EXPECT_TRUE(g[k] == 0 || std::abs(found.values[k] - expected[k] / same / g[k]) < 1e-11) << k;
    EXPECT_LE(found.p_value, 0.1); // classes lie apart
}

}
}
