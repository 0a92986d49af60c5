// Dart throwing block by block: each block is that of the reference, and together they are the set of the whole torus,
// which marks prove; where halos are too thin, they say so.
#include "host/sampling/darts/darts_in_blocks.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/dart_throwing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace poissonlab {
namespace {

DartThrowingRequest saturated(int dimension, std::size_t points)
{
    DartThrowingRequest request;
    request.dimension = dimension;
    request.min_distance = min_distance_for(saturation_relative_radius(dimension), points, dimension);
    request.stream = stream_key(7, Purpose::dart_throwing, 0);
    return request;
}

struct Together
{
    bool agree = false;
    std::uint32_t blocks = 0;
    std::size_t points = 0;
    bool is_whole = false; ///< the set of the whole torus, in its order
};

template <int D>
Together throw_in_blocks(const DartThrowingRequest& whole, std::uint32_t side, std::uint32_t halo)
{
    DartThrower thrower(Device::open());
    const DartBlocks blocks(cell_hierarchy(whole.min_distance, D), D, side, halo);
    std::vector<OrderedDart<D>> all;
    std::vector<std::uint64_t> marks;
    for (std::uint32_t block = 0; block < blocks.count(); ++block) {
        DartThrowingRequest request = whole;
        request.block = blocks.with_halo(block);
        std::vector<OrderedDart<D>> darts = thrower.ordered_darts<D>(request);
        std::ranges::copy(blocks.keep_own<D>(block, darts), std::back_inserter(marks));
        all.insert(all.end(), darts.begin(), darts.end());
    }
    std::ranges::sort(all);
    const ThrowBlock<D> throw_block = [&](const DartThrowingRequest& request) {
        return thrower.ordered_darts<D>(request);
    };
    EXPECT_EQ(throw_in_blocks<D>(throw_block, whole, side, halo), thrower.ordered_darts<D>(whole)); // however thin
    return {blocks.marks_agree(marks), blocks.count(), all.size(), all == thrower.ordered_darts<D>(whole)};
}

TEST(DartBlocks, AreTheWholeTorusTogether)
{
    const Together plane = throw_in_blocks<2>(saturated(2, 20'000), 130, usual_halo(2));
    EXPECT_EQ(plane.blocks, 9u);
    EXPECT_TRUE(plane.agree);
    EXPECT_TRUE(plane.is_whole) << plane.points;
    const Together space = throw_in_blocks<3>(saturated(3, 30'000), 58, 14);
    EXPECT_EQ(space.blocks, 8u);
    EXPECT_TRUE(space.agree);
    EXPECT_TRUE(space.is_whole) << space.points;
}

/// The halo is what makes blocks right, and marks know when it does not.
TEST(DartBlocks, DisagreeWhereHalosAreTooThin)
{
    const Together thin = throw_in_blocks<2>(saturated(2, 20'000), 102, 2);
    EXPECT_FALSE(thin.agree);
    EXPECT_FALSE(thin.is_whole);
}

/// One block is the whole torus where a halo leaves no room.
TEST(DartBlocks, AreOneWhereTheTorusIsSmall)
{
    const CellHierarchy small = cell_hierarchy(0.05, 2);
    EXPECT_EQ(DartBlocks(small, 2, 1024, 16).count(), 1u);
    EXPECT_EQ(DartBlocks(small, 2, 33, 16).count(), 1u);
    EXPECT_TRUE(DartBlocks(small, 2, 1024, 16).marks_agree({}));
}

template <int D>
void expect_kernels_like_reference(DartThrowingRequest request, const DartBlock& block)
{
    request.block = block;
    const auto expected = reference::ordered_darts<D>(request);
    EXPECT_TRUE(std::ranges::is_sorted(expected));
    for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds})
        EXPECT_EQ(DartThrower(Device::open(), 0, settling).ordered_darts<D>(request), expected);
}

/// Around the border of the torus, too.
TEST(DartBlocks, KernelsThrowTheReferencesDarts)
{
    const std::uint32_t plane = cell_hierarchy(saturated(2, 5000).min_distance, 2).size;
    expect_kernels_like_reference<2>(saturated(2, 5000), {{plane - 20, 7, 0}, 60});
    const std::uint32_t space = cell_hierarchy(saturated(3, 1000).min_distance, 3).size;
    expect_kernels_like_reference<3>(saturated(3, 1000), {{3, space - 5, space - 9}, 13});
}

/// So many points are there, and batches beyond those that hold them are not thrown.
TEST(DartBlocks, StopWhereThereArePointsEnough)
{
    DartThrowingRequest request = saturated(2, 20'000);
    const auto all = reference::ordered_darts<2>(request);
    request.points = 9000;
    const auto some = throw_in_blocks<2>(ThrowBlock<2>(reference::ordered_darts<2>), request, 130);
    EXPECT_GE(some.size(), 9000u);
    EXPECT_LT(some.size(), all.size());
    EXPECT_TRUE(std::ranges::equal(some, std::span(all).first(some.size())));
}

/// Batches that are left out change nothing in those before.
TEST(DartBlocks, StopAfterABatch)
{
    DartThrowingRequest request = saturated(2, 2000);
    const auto all = reference::ordered_darts<2>(request);
    request.most_batches = 2;
    const auto some = reference::ordered_darts<2>(request);
    ASSERT_LT(some.size(), all.size());
    EXPECT_TRUE(std::ranges::equal(some, std::span(all).first(some.size())));
    EXPECT_EQ(some.back()[0], 1u);
    EXPECT_EQ(all[some.size()][0], 2u);
    EXPECT_EQ(DartThrower(Device::open()).ordered_darts<2>(request), some);
}

TEST(CellHierarchy, KnowsTheCellOfACoordinate)
{
    std::mt19937 random(1);
    for (const std::uint32_t size : {2u, 3u, 1717u, 65'537u, 4'000'001u}) {
        CellHierarchy hierarchy = cell_hierarchy(std::sqrt(2.0) / size * (1 + 1e-9), 2);
        for (int i = 0; i < 1000; ++i) {
            const auto cell = random() % hierarchy.size;
            const auto low = static_cast<std::uint32_t>(hierarchy.lower_bound(cell, 0));
            const auto high = static_cast<std::uint32_t>(hierarchy.lower_bound(cell + 1, 0) - 1);
            EXPECT_EQ(hierarchy.cell_of(low), cell);
            EXPECT_EQ(hierarchy.cell_of(high), cell);
        }
    }
}

}
}
