// Kernel dart throwing is unbiased: its statistics are those of the textbook algorithm, which shares no code
// with it.
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "tests/support/set_features.hpp"
#include "tests/support/textbook_dart_throwing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::size_t point_count = 1024;
constexpr std::size_t set_count = 200;

double min_distance() { return min_distance_for(0.72, point_count, 2); }

/// `set_count` sets by the kernels.
const std::vector<PointSet>& kernel_sets()
{
    static const std::vector<PointSet> sets = [] {
        std::vector<PointSet> result;
        DartThrower thrower(Device::open());
        for (std::uint32_t k = 0; k < set_count; ++k) {
            DartThrowingRequest request;
            request.min_distance = min_distance();
            request.points = point_count;
            request.stream = stream_key(77, Purpose::dart_throwing, k);
            result.push_back(thrower.throw_darts(request));
        }
        return result;
    }();
    return sets;
}

/// `set_count` sets by the textbook's program.
const std::vector<PointSet>& textbook_sets()
{
    static const std::vector<PointSet> sets = [] {
        std::vector<PointSet> result;
        for (std::size_t k = 0; k < set_count; ++k) {
            result.push_back(test::textbook_dart_throwing(point_count, min_distance(), 1000 + k));
        }
        return result;
    }();
    return sets;
}

void expect_same_means(const test::Features& features)
{
    test::expect_same_means(features, kernel_sets(), textbook_sets());
}

TEST(DartThrowingStatistics, PairCorrelationNearContactIsTheTextbooks)
{
    // Distances from contact to twice the minimum distance, in 20 classes.
    expect_same_means(
        [](const PointSet& set) { return test::pairs_by_distance(set, min_distance(), 2 * min_distance(), 20); });
}

TEST(DartThrowingStatistics, RadialPowerIsTheTextbooks)
{
    expect_same_means([](const PointSet& set) { return test::radial_power(set, 128); });
}

TEST(DartThrowingStatistics, PointsDoNotKnowTheCellsTheyWereThrownIn)
{
    // Places of points within cells of level 0 are uniform, for single axes and for quarters and sixteenths of a
    // cell. The textbook's points do not know that grid at all, so a preference shows as a difference.
    const std::uint32_t cells = cell_hierarchy(min_distance(), 2).size;
    expect_same_means([&](const PointSet& set) { return test::points_in_cells(set, cells); });
}

TEST(DartThrowingStatistics, EarlyAndLatePointsAreTheTextbooks)
{
    // Points are in the order of darts.
    expect_same_means([](const PointSet& set) { return test::distances_to_predecessors(set, 64); });
}

}
}
