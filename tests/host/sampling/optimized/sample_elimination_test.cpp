// Sample elimination in rounds gives the order of the sequential algorithm, and sets as good as published.
#include "host/sampling/optimized/sample_elimination.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/settings/sampler_registry.hpp"
#include "kernels/common/optimized/sample_elimination.h"
#include "tests/support/brute_force.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/set_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <span>

namespace poissonlab {
namespace {

PointSet uniform_set(std::size_t points, int dimension, unsigned seed)
{
    std::mt19937_64 random(seed);
    return test::random_points_32(points, dimension, random);
}

struct EliminationCase
{
    int dimension;
    std::size_t points, kept;
};

void PrintTo(const EliminationCase& c, std::ostream* out)
{
    *out << c.dimension << "D, " << c.kept << " of " << c.points << " points";
}

class SampleEliminationOrder : public ::testing::TestWithParam<EliminationCase>
{
};

TEST_P(SampleEliminationOrder, IsThatOfTheHeap)
{
    const auto [dimension, points, kept] = GetParam();
    const PointSet set = uniform_set(points, dimension, 7);
    const EliminationReach reach = elimination_reach(kept, points, dimension);
    const auto expected = reference::removal_order(set, reach, points);
    ASSERT_EQ(expected.size(), points);
    for (const std::size_t group : {std::size_t{1}, std::size_t{0}}) {
        SampleElimination elimination(Device::open(), group);
        EXPECT_EQ(elimination.removal_order(set, reach, points), expected);
        const auto first = elimination.removal_order(set, reach, points - kept);
        ASSERT_EQ(first.size(), points - kept);
        EXPECT_TRUE(std::ranges::equal(first, std::span(expected).first(points - kept)));
    }
}

/// Pairs weigh more for one of their points than for the other.
TEST_P(SampleEliminationOrder, IsThatOfTheHeapWithFactors)
{
    const auto [dimension, points, kept] = GetParam();
    const PointSet set = uniform_set(points, dimension, 7);
    const EliminationReach reach = elimination_reach(kept, points, dimension);
    std::mt19937 random(3);
    std::vector<std::uint32_t> factors(points);
    for (std::uint32_t& factor : factors)
        factor = contract::sample_elimination::FACTOR_UNITS + static_cast<std::uint32_t>(random() % 48);
    const auto expected = reference::factored_removal_order(set, reach, points - kept, factors);
    EXPECT_EQ(SampleElimination(Device::open()).removal_order(set, reach, points - kept, factors), expected);
    factors.assign(points, contract::sample_elimination::FACTOR_UNITS);
    EXPECT_EQ(reference::factored_removal_order(set, reach, points - kept, factors),
              reference::removal_order(set, reach, points - kept));
}

/// Points on a road, in a small part of the torus: only cells that have some are listed.
TEST_P(SampleEliminationOrder, IsThatOfTheHeapOnARoad)
{
    const auto [dimension, points, kept] = GetParam();
    PointSet set = uniform_set(points, dimension, 7);
    double area = 1;
    for (std::size_t k = 0; k < set.coordinates.size(); ++k)
        set.coordinates[k] *= k % static_cast<std::size_t>(dimension) == 0 ? 0.5 : 0x1p-16;
    for (std::size_t i = 0; i < points; ++i) set.coordinates[i * static_cast<std::size_t>(dimension) + 1] += 0.3;
    for (int k = 0; k < dimension; ++k) area *= k == 0 ? 0.5 : 0x1p-16;
    const double side = std::pow(area, 1.0 / dimension);
    EliminationReach reach = elimination_reach(kept, points, dimension);
    reach = {reach.most * side, reach.least * side};
    std::vector<std::uint32_t> factors;
    for (std::size_t i = 0; i < points; ++i)
        factors.push_back(contract::sample_elimination::FACTOR_UNITS + static_cast<std::uint32_t>(i * 7 % 48));
    for (const std::size_t group : {std::size_t{1}, std::size_t{0}}) {
        SampleElimination elimination(Device::open(), group);
        EXPECT_EQ(elimination.removal_order(set, reach, points), reference::removal_order(set, reach, points));
        EXPECT_EQ(elimination.removal_order(set, reach, points - kept, factors),
                  reference::factored_removal_order(set, reach, points - kept, factors));
    }
}

// Oclgrind interprets these as well, see tests/CMakeLists.txt: one tile, and four of each colour.
INSTANTIATE_TEST_SUITE_P(Small, SampleEliminationOrder,
                         ::testing::Values(EliminationCase{2, 40, 8}, EliminationCase{2, 160, 80},
                                           EliminationCase{3, 20, 4}));
INSTANTIATE_TEST_SUITE_P(Sizes, SampleEliminationOrder,
                         ::testing::Values(EliminationCase{2, 1, 1}, EliminationCase{2, 5, 1}, EliminationCase{2, 9, 3},
                                           EliminationCase{2, 700, 100}, EliminationCase{2, 10000, 2000},
                                           EliminationCase{3, 3000, 1000}));

/// The definition: whenever a point is removed, no other one has more around it that is still there.
TEST(SampleElimination, RemovesTheHeaviestPointByDirectSums)
{
    constexpr std::size_t points = 120, kept = 30;
    const PointSet set = uniform_set(points, 2, 3);
    const EliminationReach reach = elimination_reach(kept, points, 2);
    EXPECT_NEAR(reach.most, std::sqrt(2 / (std::sqrt(3.0) * kept)), 1e-12);         // 2 r_max, equation 2 of the paper
    EXPECT_NEAR(reach.least / reach.most, (1 - std::pow(0.25, 1.5)) * 0.65, 1e-12); // equation 4
    std::vector<bool> is_there(points, true);
    for (const std::uint32_t removed : SampleElimination(Device::open()).removal_order(set, reach, points)) {
        std::vector<double> weights(points, -1);
        for (std::size_t i = 0; i < points; ++i) {
            if (!is_there[i]) continue;
            weights[i] = 0;
            for (std::size_t j = 0; j < points; ++j) {
                const double distance = std::sqrt(test::squared_distance(set[i], set[j]));
                if (j == i || !is_there[j] || distance >= reach.most) continue;
                weights[i] += std::pow(1 - std::max(distance, reach.least) / reach.most, 8);
            }
        }
        EXPECT_GE(weights[removed], std::ranges::max(weights) - points * 0x1p-40);
        is_there[removed] = false;
    }
}

TEST(SampleElimination, KeepsPointsOfTheSetInAnOrderWhosePrefixesAreSpread)
{
    const PointSet set = uniform_set(10240, 2, 5);
    SampleElimination elimination(Device::open());
    const PointSet kept =
        eliminate(set, 2048, [&](const PointSet& points, const EliminationReach& reach, std::size_t count) {
            return elimination.removal_order(points, reach, count);
        });
    ASSERT_EQ(kept.size(), 2048u);
    EXPECT_EQ(kept, eliminate(set, 2048, reference::removal_order));
    std::set<std::pair<double, double>> all, chosen;
    for (std::size_t i = 0; i < set.size(); ++i) all.emplace(set[i][0], set[i][1]);
    for (std::size_t i = 0; i < kept.size(); ++i) chosen.emplace(kept[i][0], kept[i][1]);
    EXPECT_EQ(chosen.size(), kept.size());
    EXPECT_TRUE(std::ranges::includes(all, chosen));
    // The relative radius of cySampleElim's sets of five times as many points is 0.69; of prefixes, the paper's figure
    // 8 shows the same for powers of two.
    for (const std::size_t prefix : {2048u, 1024u, 512u, 256u}) {
        PointSet part = kept;
        part.coordinates.resize(2 * prefix);
        EXPECT_GT(relative_radius(test::brute_force_min_distance(part), prefix, 2), 0.62) << prefix;
    }
    // Between powers of two points are added in order as well: random ones would have distances near zero.
    PointSet between = kept;
    between.coordinates.resize(2 * 1500);
    EXPECT_GT(relative_radius(test::brute_force_min_distance(between), 1500, 2), 0.45);
}

TEST(SampleEliminationSampler, EnginesGiveTheSameBytes)
{
    const SamplerSpec& spec = *find_sampler("sample-elimination");
    const Parameters parameters(spec.parameters);
    Device device = Device::open();
    for (const int dimension : {2, 3}) {
        const SampleRequest request{500, dimension, 5};
        const auto kernel = spec.create(parameters, request, Engine::opencl, [&]() -> Device& { return device; });
        const auto plain = spec.create(parameters, request, Engine::reference, {});
        for (std::uint32_t k = 0; k < 2; ++k) EXPECT_EQ(kernel->sample(k), plain->sample(k));
        EXPECT_EQ(kernel->sample(0).size(), 500u);
        EXPECT_NE(kernel->sample(0), kernel->sample(1));
    }
}

}
}
