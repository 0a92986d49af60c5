// Kernel and reference relaxation dart throwing give the same bytes, whatever the device is told; both do
// what a loop over all pairs does.
#include "host/sampling/relaxation_dart_throwing.hpp"

#include "base/geometry/torus.hpp"
#include "tests/support/brute_force.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

struct Case
{
    int dimension;
    std::size_t points;
    double initial_radius;
    double factor;
    std::uint64_t attempts;
    std::uint64_t seed;
};

void PrintTo(const Case& c, std::ostream* out)
{
    *out << c.dimension << "D, " << c.points << " points, radius " << c.initial_radius << ", times " << c.factor
         << " after " << c.attempts << ", seed " << c.seed;
}

RelaxationDartThrowingRequest request_for(const Case& c)
{
    const StreamKey stream = stream_key(c.seed, Purpose::relaxation_dart_throwing, 0);
    return {c.dimension, c.points, c.initial_radius, c.factor, c.attempts, stream};
}

class RelaxationDartThrowing : public ::testing::TestWithParam<Case>
{
};

TEST_P(RelaxationDartThrowing, KernelGivesTheReferencesBytesAndKeepsTheDistance)
{
    const auto request = request_for(GetParam());
    const RelaxationDarts expected = reference::throw_relaxation_darts(request);
    const RelaxationDarts made = RelaxationDartThrower(Device::open()).throw_darts(request);
    EXPECT_EQ(made.darts, expected.darts);
    EXPECT_EQ(made.radius, expected.radius);
    ASSERT_EQ(made.points, expected.points);
    EXPECT_EQ(expected.points.size(), GetParam().points);
    // The oracle is exact up to the final rounding, and so is the distance.
    EXPECT_GE(test::brute_force_min_distance(expected.points), 2 * expected.radius);
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, RelaxationDartThrowing,
                         ::testing::Values(Case{2, 40, 0.15, 0.9, 30, 5}, Case{2, 100, 0.5, 0.5, 1, 7},
                                           Case{3, 40, 0.15, 0.9, 30, 19},
                                           // Few darts become points: they are thrown in batches.
                                           Case{2, 40, 0.15, 0.95, 300, 25}, Case{3, 20, 0.3, 0.95, 300, 26}));

INSTANTIATE_TEST_SUITE_P(Sizes, RelaxationDartThrowing,
                         ::testing::Values(Case{2, 1, 0.15, 0.9, 100, 1}, Case{2, 2, 0.15, 0.99, 1000, 2},
                                           Case{2, 3, 0.5, 0.9, 100, 3}, Case{2, 17, 0.5, 0.99, 20, 4},
                                           Case{2, 100, 0.15, 0.99, 1000, 6}, Case{2, 1024, 0.15, 0.9, 100, 8},
                                           Case{2, 1024, 0.15, 0.99, 1000, 9}, Case{2, 1024, 0.15, 0.999, 500, 10},
                                           // No dart is ever rejected; one failure is enough; many levels a batch.
                                           Case{2, 1024, 1e-7, 0.9, 100, 11}, Case{2, 3000, 0.15, 0.5, 1, 12},
                                           Case{2, 500, 0.3, 0.9999, 1, 13}, Case{2, 2, 1e-300, 0.5, 1, 14},
                                           Case{2, 16384, 0.15, 0.9, 100, 15}, Case{3, 1, 0.15, 0.9, 100, 16},
                                           Case{3, 2, 0.5, 0.99, 100, 17}, Case{3, 17, 0.5, 0.9, 50, 18},
                                           Case{3, 100, 0.15, 0.99, 1000, 20}, Case{3, 1024, 0.15, 0.99, 1000, 21},
                                           Case{3, 1024, 0.5, 0.5, 1, 22}, Case{3, 1024, 1e-7, 0.9, 100, 23},
                                           Case{3, 16384, 0.15, 0.9, 100, 24}));

TEST(RelaxationDartThrowingOnDevices, TheDissertationsSetsAreTheReferences)
{
    // The last takes millions of darts, large batches, and thousands of levels.
    for (const Case& c : {Case{2, 16384, 0.15, 0.99, 1'000, 1}, Case{2, 16384, 0.15, 0.999, 10'000, 1}}) {
        EXPECT_EQ(RelaxationDartThrower(Device::open()).throw_darts(request_for(c)),
                  reference::throw_relaxation_darts(request_for(c)));
    }
}

TEST(RelaxationDartThrowingOnDevices, WorkGroupsAndThreadsChangeNothing)
{
    for (const Case& c : {Case{2, 2000, 0.15, 0.99, 500, 3}, Case{3, 1000, 0.15, 0.99, 500, 3}}) {
        const auto request = request_for(c);
        const RelaxationDarts expected = reference::throw_relaxation_darts(request);
        for (const unsigned threads : {1u, 2u}) {
            for (const std::size_t group : {1u, 7u, 64u, 256u}) {
                EXPECT_EQ(RelaxationDartThrower(Device::open({}, threads), group).throw_darts(request), expected)
                    << threads << " threads, groups of " << group;
            }
        }
    }
}

TEST(RelaxationDartThrowingOnDevices, ReusedBuffersKeepNothingOfEarlierSets)
{
    RelaxationDartThrower thrower(Device::open());
    const auto large = request_for({2, 3000, 0.15, 0.99, 100, 1});
    const auto small = request_for({2, 200, 0.15, 0.9, 100, 2});
    const auto other = request_for({3, 700, 0.15, 0.9, 100, 2});
    for (const auto* request : {&large, &small, &other, &large, &other})
        EXPECT_EQ(thrower.throw_darts(*request), reference::throw_relaxation_darts(*request));
}

/// The definition, word for word: every dart against every point, in integers.
template <int D>
RelaxationDarts all_pairs(const RelaxationDartThrowingRequest& request)
{
    std::vector<TorusPoint<D>> points;
    double radius = request.initial_radius;
    std::uint64_t failures = 0;
    std::uint64_t dart = 0;
    for (; points.size() < request.points; ++dart) {
        const std::uint64_t block = D == 2 ? dart / 2 : dart;
        const auto words =
            philox({static_cast<std::uint32_t>(block), static_cast<std::uint32_t>(block >> 32), 0, 0}, request.stream);
        TorusPoint<D> position;
        for (std::size_t k = 0; k < D; ++k) position[k] = words[k + (D == 2 ? 2 * (dart % 2) : 0)];
        bool free = true;
        for (const TorusPoint<D>& point : points)
            free = free && squared_distance<D>(point, position) >= squared_threshold(2 * radius);
        if (free) {
            points.push_back(position);
            failures = 0;
            continue;
        }
        ++failures;
        if (failures == request.attempts) {
            radius = radius * request.factor;
            failures = 0;
        }
    }
    return {to_point_set<D>(std::span<const TorusPoint<D>>(points)), radius, dart};
}

TEST(RelaxationDartThrowingReference, DoesWhatALoopOverAllPairsDoes)
{
    for (const Case& c : {Case{2, 1, 0.5, 0.9, 10, 1}, Case{2, 30, 0.5, 0.9, 10, 2}, Case{2, 300, 0.15, 0.97, 50, 3},
                          Case{2, 200, 0.4, 0.5, 1, 4}, Case{2, 150, 0.2, 0.99, 7, 5}, Case{2, 100, 1e-9, 0.5, 1, 6}})
        EXPECT_EQ(reference::throw_relaxation_darts(request_for(c)), all_pairs<2>(request_for(c)));
    for (const Case& c : {Case{3, 1, 0.5, 0.9, 10, 1}, Case{3, 60, 0.5, 0.9, 10, 2}, Case{3, 300, 0.15, 0.97, 50, 3},
                          Case{3, 200, 0.4, 0.5, 1, 4}})
        EXPECT_EQ(reference::throw_relaxation_darts(request_for(c)), all_pairs<3>(request_for(c)));
}

TEST(RelaxationDartThrowingOrder, PrefixesAreSetsOfTheirOwn)
{
    auto request = request_for({2, 1000, 0.15, 0.99, 300, 5});
    const PointSet all = RelaxationDartThrower(Device::open()).throw_darts(request).points;
    for (const std::size_t prefix : {1u, 100u, 567u, 999u}) {
        request.points = prefix;
        const PointSet first = RelaxationDartThrower(Device::open()).throw_darts(request).points;
        ASSERT_EQ(first.size(), prefix);
        EXPECT_TRUE(std::equal(first.coordinates.begin(), first.coordinates.end(), all.coordinates.begin()));
    }
}

TEST(RelaxationDartThrowingOrder, StreamsDiffer)
{
    const PointSet a = reference::throw_relaxation_darts(request_for({2, 100, 0.15, 0.9, 100, 1})).points;
    const PointSet b = reference::throw_relaxation_darts(request_for({2, 100, 0.15, 0.9, 100, 2})).points;
    for (std::size_t i = 0; i < a.coordinates.size(); ++i) EXPECT_NE(a.coordinates[i], b.coordinates[i]);
}

}
}
