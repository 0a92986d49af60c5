// Kernel relaxation dart throwing is unbiased, reaches the radii of the dissertation, and is hierarchical.
#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "tests/support/set_features.hpp"
#include "tests/support/textbook_relaxation_dart_throwing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace poissonlab {
namespace {

/// Sets by the kernels, one for each realization from 0 to count - 1.
std::vector<PointSet> relaxation_kernel_sets(RelaxationDartThrowingRequest request, std::uint64_t seed,
                                             std::uint32_t count)
{
    std::vector<PointSet> sets;
    RelaxationDartThrower thrower(Device::open());
    for (std::uint32_t k = 0; k < count; ++k) {
        request.stream = stream_key(seed, Purpose::relaxation_dart_throwing, k);
        sets.push_back(thrower.throw_darts(request).points);
    }
    return sets;
}

double relative_radius_of(const PointSet& set)
{
    return relative_radius(min_toroidal_distance(set), set.size(), set.dimension);
}

std::vector<double> relative_radii_of(const std::vector<PointSet>& sets)
{
    std::vector<double> radii;
    for (const PointSet& set : sets) radii.push_back(relative_radius_of(set));
    return radii;
}

struct Published
{
    int dimension;
    std::size_t points;
    double factor;
    std::uint64_t attempts;
    double relative_radius; ///< to two digits
    double nearest_other;   ///< the published value of another setting that is nearest to it; 0: none
    std::uint32_t sets;     ///< that we make: more where they are cheap and scatter more
};

TEST(RelaxationDartThrowingStatistics, RelativeRadiiAreTheDissertations)
{
    // Sets end at one of few levels of the radius. With a factor of 0.9 these are far apart: 0.587 for some
    // 95 sets in 100, from 0.528 to 0.565 for the others (of 1,000 sets none rounds to 0.57). So the
    // published value is taken for a mean. Of how many sets is not said; ten is what the spectra beside it
    // average.
    constexpr double published_sets = 10;
    const std::vector<Published> cases = {{2, 16384, 0.9, 100, 0.57, 0.68, 100},
                                          {2, 16384, 0.99, 1'000, 0.68, 0.73, 30},
                                          {2, 16384, 0.999, 10'000, 0.73, 0.68, 10},
                                          {3, 65536, 0.99, 1'000, 0.70, 0, 5}};
    for (const Published& p : cases) {
        SCOPED_TRACE(p.factor);
        const auto sets = relaxation_kernel_sets({p.dimension, p.points, 0.15, p.factor, p.attempts}, 1, p.sets);
        const test::Mean mean = test::mean_of(relative_radii_of(sets));
        // Half a digit of rounding, and what chance allows for the difference of both means.
        const double n = static_cast<double>(p.sets);
        const double spread = mean.standard_error * std::sqrt(n);
        const double standard_error = spread * std::sqrt(1 / n + 1 / published_sets);
        const double tolerance = 0.005 + test::z_bound(cases.size()) * standard_error;
        EXPECT_NEAR(mean.value, p.relative_radius, tolerance) << "sets deviate by " << spread;
        // A test that could not tell the settings apart would be none.
        if (p.nearest_other > 0) {
            EXPECT_LT(tolerance, std::abs(p.relative_radius - p.nearest_other) / 2);
        }
        RecordProperty(std::to_string(p.factor) + "_" + std::to_string(p.dimension) + "D",
                       std::to_string(mean.value) + " +- " + std::to_string(spread) + ", tolerance " +
                           std::to_string(tolerance));
    }
}

TEST(RelaxationDartThrowingStatistics, PrefixesAreAsWellSpreadAsSetsOfTheirSize)
{
    const auto sets = relaxation_kernel_sets({2, 4096, 0.15, 0.99, 1'000}, 2, 30);
    const std::vector<std::size_t> sizes = {2048, 1024, 512, 256, 128, 64};
    for (const std::size_t size : sizes) {
        std::vector<PointSet> prefixes;
        for (const PointSet& set : sets) {
            const auto end = set.coordinates.begin() + static_cast<std::ptrdiff_t>(2 * size);
            prefixes.push_back({2, {set.coordinates.begin(), end}});
        }
        const test::Mean of_prefixes = test::mean_of(relative_radii_of(prefixes));
        const test::Mean of_sets =
            test::mean_of(relative_radii_of(relaxation_kernel_sets({2, size, 0.15, 0.99, 1'000}, 3, 30)));
        EXPECT_LT(std::abs(test::z_score(of_prefixes, of_sets)), test::z_bound(sizes.size()))
            << size << " points: " << of_prefixes.value << " and " << of_sets.value;
        EXPECT_GT(of_prefixes.value, 0.65);
    }
}

constexpr std::size_t relaxation_points = 512;
constexpr std::uint32_t relaxation_sets = 200;

const std::vector<PointSet>& relaxation_kernel_sets()
{
    static const std::vector<PointSet> sets =
        relaxation_kernel_sets({2, relaxation_points, 0.15, 0.97, 60}, 4, relaxation_sets);
    return sets;
}

const std::vector<PointSet>& relaxation_textbook_sets()
{
    static const std::vector<PointSet> sets = [] {
        std::vector<PointSet> result;
        for (std::size_t k = 0; k < relaxation_sets; ++k)
            result.push_back(test::textbook_relaxation_dart_throwing(relaxation_points, 0.15, 0.97, 60, 1000 + k));
        return result;
    }();
    return sets;
}

void expect_same_relaxation_means(const test::Features& features)
{
    test::expect_same_means(features, relaxation_kernel_sets(), relaxation_textbook_sets());
}

TEST(RelaxationDartThrowingStatistics, PairCorrelationIsTheTextbooks)
{
    const double unit = max_min_distance(relaxation_points, 2);
    expect_same_relaxation_means(
        [&](const PointSet& set) { return test::pairs_by_distance(set, 0.55 * unit, 2 * unit, 20); });
}

TEST(RelaxationDartThrowingStatistics, RadialPowerIsTheTextbooks)
{
    expect_same_relaxation_means([](const PointSet& set) { return test::radial_power(set, 96); });
}

TEST(RelaxationDartThrowingStatistics, PointsDoNotKnowTheCellsOfTheGrids)
{
    // Places of points are uniform in the whole torus and in cells of the grids, which are powers of two.
    for (const double cells : {1.0, 4.0, 32.0}) {
        SCOPED_TRACE(cells);
        expect_same_relaxation_means([&](const PointSet& set) { return test::points_in_cells(set, cells); });
    }
}

TEST(RelaxationDartThrowingStatistics, EarlyAndLatePointsAreTheTextbooks)
{
    // Points are in the order of acceptance.
    expect_same_relaxation_means([](const PointSet& set) { return test::distances_to_predecessors(set, 32); });
}

}
}
