// Darts by Voronoi cells: both engines give the same bytes, the distance holds, and nothing fits into full sets. The
// law is that of dart throwing.
#include "host/sampling/classics/voronoi_darts.hpp"

#include "analysis/measures/largest_empty_ball.hpp"
#include "base/geometry/relative_radius.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/chi_square.hpp"
#include "tests/support/set_features.hpp"
#include "tests/support/textbook_dart_throwing.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

DartThrowingRequest request_for(std::size_t points, double relative_radius, std::uint32_t realization)
{
    DartThrowingRequest request;
    request.min_distance = min_distance_for(relative_radius, points, 2);
    request.points = points;
    request.stream = stream_key(1, Purpose::voronoi_darts, realization);
    return request;
}

DartThrowingRequest full_set(double min_distance, std::uint32_t realization)
{
    DartThrowingRequest request = request_for(1, 0.5, realization);
    request.min_distance = min_distance;
    request.points.reset();
    return request;
}

struct VoronoiDartCase
{
    std::size_t points;
    double relative_radius;
};

void PrintTo(const VoronoiDartCase& c, std::ostream* out)
{
    *out << c.points << " points, relative radius " << c.relative_radius;
}

class VoronoiDartSets : public ::testing::TestWithParam<VoronoiDartCase>
{
};

TEST_P(VoronoiDartSets, KernelGivesTheReferencesBytesAndKeepsTheDistance)
{
    const DartThrowingRequest request = request_for(GetParam().points, GetParam().relative_radius, 3);
    const PointSet expected = reference::throw_voronoi_darts(request);
    EXPECT_EQ(expected.size(), request.points);
    EXPECT_EQ(VoronoiDarts(Device::open()).throw_darts(request), expected);
    EXPECT_GE(test::brute_force_min_distance(expected), request.min_distance);
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, VoronoiDartSets, ::testing::Values(VoronoiDartCase{7, 0.6}, VoronoiDartCase{90, 0.74}));
INSTANTIATE_TEST_SUITE_P(Sizes, VoronoiDartSets,
                         ::testing::Values(VoronoiDartCase{1, 0.7}, VoronoiDartCase{2, 0.7}, VoronoiDartCase{33, 0.7},
                                           VoronoiDartCase{331, 0.7}, VoronoiDartCase{1024, 0.1},
                                           VoronoiDartCase{4096, 0.75}));

/// Exactly the distance that is asked for or more, and no circle of that radius is empty, but for the rounding of
/// darts.
TEST(VoronoiDarts, FillTheTorus)
{
    for (const double distance : {0.9, 0.71, 0.5, 0.3, 0.124, 0.03, 0.01}) {
        for (std::uint32_t realization = 0; realization < 3; ++realization) {
            const DartThrowingRequest request = full_set(distance, realization);
            const PointSet set = VoronoiDarts(Device::open()).throw_darts(request);
            EXPECT_EQ(set, reference::throw_voronoi_darts(request));
            EXPECT_GE(test::brute_force_min_distance(set), distance);
            EXPECT_LT(largest_empty_ball(set).radius, distance * (1 + 1e-7) + 4 * 0x1p-32);
        }
    }
}

TEST(VoronoiDarts, CoverWhatRandomSequentialAdditionCovers)
{
    // The sets are those of saturation_test.cpp: 24 sets of about 16,384 points.
    const double distance = min_distance_for(saturation_relative_radius(2), 16384, 2);
    VoronoiDarts darts(Device::open());
    std::vector<double> fractions;
    for (std::uint32_t realization = 0; realization < 24; ++realization)
        fractions.push_back(covered_fraction(distance, darts.throw_darts(full_set(distance, realization)).size(), 2));
    const test::Mean mean = test::mean_of(fractions);
    EXPECT_NEAR(mean.standard_error, 2.1e-4, 1e-4); // 0.547 sqrt(0.059 / 16384 / 24)
    EXPECT_NEAR(mean.value, saturation_covered_fraction(2), test::z_bound(1) * mean.standard_error);
}

/// The nearest of a set's first points.
struct NearestPoint
{
    NearestPoint(const PointSet& set, std::size_t count, std::span<const double> position)
    {
        for (std::size_t i = 0; i < count; ++i) {
            const double other = test::squared_distance(set[i], position);
            if (other >= squared) continue;
            squared = other;
            const auto toward = [&](std::size_t k) { return std::remainder(position[k] - set[i][k], 1.0); };
            direction = std::atan2(toward(1), toward(0));
        }
    }

    double squared = 2;
    double direction = 0;
};

/// The place of the last dart among 19 that are uniform in what is free before it (of plain random positions, those
/// that no point covers) is as likely to be the first as the second, and so on, by anything that can be said of a
/// place.
TEST(VoronoiDarts, FallUniformlyIntoTheFreeArea)
{
    constexpr std::size_t others = 19, points = 60, sets = 2000;
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(0, 1);
    std::array<std::vector<std::uint64_t>, 3> ranks;
    ranks.fill(std::vector<std::uint64_t>(others + 1));
    for (std::uint32_t realization = 0; realization < sets; ++realization) {
        const DartThrowingRequest request = request_for(points, 0.72, realization);
        const PointSet set = reference::throw_voronoi_darts(request);
        const auto said_of = [&](std::span<const double> position) {
            const NearestPoint nearest(set, points - 1, position);
            return std::array{nearest.squared, nearest.direction, position[0]};
        };
        const auto dart = said_of(set[points - 1]);
        std::array<std::size_t, 3> before{};
        for (std::size_t i = 0; i < others;) {
            const auto place = said_of(std::array{unit(random), unit(random)});
            if (place[0] < request.min_distance * request.min_distance) continue;
            for (std::size_t k = 0; k < before.size(); ++k) before[k] += place[k] < dart[k];
            ++i;
        }
        for (std::size_t k = 0; k < before.size(); ++k) ++ranks[k][before[k]];
    }
    for (const auto& counts : ranks) EXPECT_TRUE(test::are_equally_likely(counts, ranks.size()));
}

TEST(VoronoiDarts, HaveTheStatisticsOfTheTextbook)
{
    constexpr std::size_t points = 512, sets = 150;
    const double distance = min_distance_for(0.74, points, 2);
    std::vector<PointSet> ours, textbook;
    for (std::uint32_t k = 0; k < sets; ++k) {
        ours.push_back(reference::throw_voronoi_darts(request_for(points, 0.74, k)));
        textbook.push_back(test::textbook_dart_throwing(points, distance, 5000 + k));
    }
    test::expect_same_means(
        [&](const PointSet& set) { return test::pairs_by_distance(set, distance, 2 * distance, 20); }, ours, textbook);
    test::expect_same_means([](const PointSet& set) { return test::radial_power(set, 64); }, ours, textbook);
    test::expect_same_means([](const PointSet& set) { return test::distances_to_predecessors(set, 64); }, ours,
                            textbook);
    const double cells = voronoi_dart_torus(distance).grid_size;
    test::expect_same_means([&](const PointSet& set) { return test::points_in_cells(set, cells); }, ours, textbook);
}

TEST(VoronoiDarts, DoNotDependOnWorkGroupsAndThreads)
{
    const DartThrowingRequest request = full_set(0.02, 7);
    const PointSet expected = reference::throw_voronoi_darts(request);
    for (const unsigned threads : {1u, 2u})
        for (const std::size_t group : {1u, 7u, 128u})
            EXPECT_EQ(VoronoiDarts(Device::open({}, threads), group).throw_darts(request), expected) << group;
}

TEST(VoronoiDarts, KeepNothingOfEarlierSets)
{
    VoronoiDarts darts(Device::open());
    const DartThrowingRequest large = full_set(0.02, 1), small = request_for(200, 0.72, 2);
    for (const auto* request : {&large, &small, &large})
        EXPECT_EQ(darts.throw_darts(*request), reference::throw_voronoi_darts(*request));
}

TEST(VoronoiDarts, PrefixesAreSetsOfTheirOwn)
{
    DartThrowingRequest request = request_for(1000, 0.74, 5);
    const PointSet all = VoronoiDarts(Device::open()).throw_darts(request);
    for (const std::size_t prefix : {1u, 567u, 999u}) {
        request.points = prefix;
        const PointSet first = VoronoiDarts(Device::open()).throw_darts(request);
        ASSERT_EQ(first.size(), prefix);
        EXPECT_TRUE(std::equal(first.coordinates.begin(), first.coordinates.end(), all.coordinates.begin()));
    }
}

}
}
