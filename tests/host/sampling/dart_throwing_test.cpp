// Kernel and reference dart throwing give the same bytes, whatever the device is told; the minimum distance
// holds.
#include "host/sampling/dart_throwing.hpp"

#include "base/geometry/relative_radius.hpp"
#include "tests/bench/plain_dart_throwing.hpp"
#include "tests/support/brute_force.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

DartThrowingRequest request_for(int dimension, std::size_t points, double relative_radius, std::uint64_t seed)
{
    DartThrowingRequest request;
    request.dimension = dimension;
    request.min_distance = min_distance_for(relative_radius, points, dimension);
    request.points = points;
    request.stream = stream_key(seed, Purpose::dart_throwing, 0);
    return request;
}

struct DartThrowingCase
{
    int dimension;
    std::size_t points;
    double relative_radius;
    std::uint64_t seed;
    bool saturate;
};

void PrintTo(const DartThrowingCase& c, std::ostream* out)
{
    *out << c.dimension << "D, " << c.points << " points, relative radius " << c.relative_radius << ", seed " << c.seed
         << (c.saturate ? ", to saturation" : "");
}

class DartThrowing : public ::testing::TestWithParam<DartThrowingCase>
{
protected:
    DartThrowingRequest request() const
    {
        const DartThrowingCase& c = GetParam();
        DartThrowingRequest request = request_for(c.dimension, c.points, c.relative_radius, c.seed);
        if (c.saturate) request.points.reset();
        return request;
    }
};

TEST_P(DartThrowing, KernelGivesTheReferencesBytesAndKeepsTheDistance)
{
    const PointSet expected = reference::throw_darts(request());
    if (!GetParam().saturate) {
        EXPECT_EQ(expected.size(), GetParam().points);
    }
    for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds}) {
        EXPECT_EQ(DartThrower(Device::open(), 0, settling).throw_darts(request()), expected)
            << (settling == DartSettling::in_order ? "in order" : "in rounds");
    }
    // The oracle is exact up to the final rounding, and so is the distance that was asked for.
    EXPECT_GE(test::brute_force_min_distance(expected), request().min_distance);
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, DartThrowing,
                         ::testing::Values(DartThrowingCase{2, 7, 0.60, 4, false},
                                           DartThrowingCase{2, 50, 0.65, 6, false},
                                           DartThrowingCase{2, 4, 0.77, 12, true},
                                           DartThrowingCase{3, 10, 0.60, 17, false}));

INSTANTIATE_TEST_SUITE_P(
    Sizes, DartThrowing,
    ::testing::Values(DartThrowingCase{2, 1, 0.70, 1, false}, DartThrowingCase{2, 2, 0.70, 1, false},
                      DartThrowingCase{2, 3, 0.60, 2, false}, DartThrowingCase{2, 5, 0.65, 3, false},
                      DartThrowingCase{2, 13, 0.60, 5, false}, DartThrowingCase{2, 331, 0.70, 7, false},
                      DartThrowingCase{2, 1024, 0.10, 8, false}, DartThrowingCase{2, 1024, 0.40, 9, false},
                      DartThrowingCase{2, 4096, 0.75, 10, false}, DartThrowingCase{2, 1, 0.77, 11, true},
                      DartThrowingCase{2, 9, 0.77, 13, true}, DartThrowingCase{2, 100, 0.77, 14, true},
                      DartThrowingCase{2, 3000, 0.77, 15, true}, DartThrowingCase{3, 1, 0.70, 16, false},
                      DartThrowingCase{3, 60, 0.65, 18, false}, DartThrowingCase{3, 2000, 0.75, 19, false},
                      DartThrowingCase{3, 6000, 0.75, 22, false}, DartThrowingCase{3, 20, 0.80, 20, true},
                      DartThrowingCase{3, 500, 0.80, 21, true}));

TEST(DartThrowingOnDevices, WorkGroupsAndThreadsChangeNothing)
{
    for (const bool saturate : {false, true}) {
        DartThrowingRequest request = request_for(2, 2000, 0.74, 3);
        if (saturate) request.points.reset();
        const PointSet expected = reference::throw_darts(request);
        for (const unsigned threads : {1u, 2u}) {
            for (const std::size_t group : {1u, 7u, 64u, 256u}) {
                for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds}) {
                    EXPECT_EQ(DartThrower(Device::open({}, threads), group, settling).throw_darts(request), expected)
                        << threads << " threads, groups of " << group;
                }
            }
        }
    }
}

/// A million cells are four slabs, on however few threads.
TEST(DartThrowingOnDevices, LargeSetsOfMoreSlabsThanThreadsAreThoseOfTheReference)
{
    const DartThrowingRequest request = request_for(2, 300'000, 0.7, 3);
    const PointSet expected = reference::throw_darts(request);
    EXPECT_EQ(DartThrower(Device::open({}, 1), 0, DartSettling::in_order).throw_darts(request), expected);
}

TEST(DartThrowingOnDevices, ReusedBuffersKeepNothingOfEarlierSets)
{
    const DartThrowingRequest large = request_for(2, 3000, 0.70, 1);
    const DartThrowingRequest small = request_for(2, 200, 0.72, 2);
    const DartThrowingRequest other = request_for(3, 700, 0.72, 2);
    for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds}) {
        DartThrower thrower(Device::open(), 0, settling);
        for (const auto* request : {&large, &small, &other, &large, &other}) {
            EXPECT_EQ(thrower.throw_darts(*request), reference::throw_darts(*request));
        }
    }
}

TEST(DartThrowingOrder, PrefixesAreSetsOfTheirOwn)
{
    DartThrowingRequest request = request_for(2, 1000, 0.72, 5);
    const PointSet all = DartThrower(Device::open()).throw_darts(request);
    for (const std::size_t prefix : {1u, 100u, 567u, 999u}) {
        request.points = prefix;
        const PointSet first = DartThrower(Device::open()).throw_darts(request);
        ASSERT_EQ(first.size(), prefix);
        EXPECT_TRUE(std::equal(first.coordinates.begin(), first.coordinates.end(), all.coordinates.begin()));
    }
}

TEST(DartThrowingOrder, StreamsDiffer)
{
    const PointSet a = reference::throw_darts(request_for(2, 100, 0.6, 1));
    const PointSet b = reference::throw_darts(request_for(2, 100, 0.6, 2));
    for (std::size_t i = 0; i < a.coordinates.size(); ++i) EXPECT_NE(a.coordinates[i], b.coordinates[i]);
}

/// The program that kernels are timed against must do the same work.
template <int D>
void check_plain_version(std::size_t count, double relative_radius)
{
    const double min_distance = min_distance_for(relative_radius, count, D);
    const auto points = bench::plain_dart_throwing<D>(count, min_distance, 5);
    EXPECT_EQ(points.size(), count);
    const PointSet set = to_point_set<D>(std::span<const TorusPoint<D>>(points));
    const double least = test::brute_force_min_distance(set);
    EXPECT_GE(least, min_distance);
    EXPECT_LT(least, 1.02 * min_distance) << "farther apart than was asked for";
}

TEST(PlainDartThrowing, KeepsTheDistance)
{
    check_plain_version<2>(2000, 0.74);
    check_plain_version<3>(2000, 0.75);
}

}
}
