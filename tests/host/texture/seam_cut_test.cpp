// Cuts against brute force over all labelings and all paths.
#include "host/texture/seam_cut.hpp"

#include "host/texture/wang_texture.hpp"
#include "tests/host/texture/random_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace poissonlab {
namespace {

/// The cost of labels with plain weights, from the pictures alone: Kwatra's sum of differences, and 1 a pair.
std::int64_t plain_cost(const PngPixels& a, const PngPixels& b, const std::vector<int>& taken)
{
    std::int64_t cost = 0;
    const auto difference = [&](int x, int y) {
        int sum = 0;
        for (int c = 0; c < a.channels; ++c) sum += std::abs(a.values[a.at(x, y, c)] - b.values[b.at(x, y, c)]);
        return sum;
    };
    const auto label = [&](int x, int y) { return taken[static_cast<std::size_t>(y * a.width + x)]; };
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            if (x + 1 < a.width && label(x, y) != label(x + 1, y)) cost += 1 + difference(x, y) + difference(x + 1, y);
            if (y + 1 < a.height && label(x, y) != label(x, y + 1)) cost += 1 + difference(x, y) + difference(x, y + 1);
        }
    return cost;
}

/// A problem of 4 x 3 pixels with few grey levels, so that minimum cuts are often several.
struct SmallProblem
{
    explicit SmallProblem(unsigned seed)
        : below(test::random_picture(4, 3, seed % 2 == 0 ? 1 : 3, seed, 4)),
          above(test::random_picture(4, 3, seed % 2 == 0 ? 1 : 3, seed + 1000, 4))
    {
        std::mt19937 random(seed);
        for (int i = 0; i < 12; ++i) {
            const auto draw = random() % 8;
            roles.push_back(draw == 0 ? PixelRole::kept : draw == 1 ? PixelRole::taken : PixelRole::free);
        }
    }

    /// Calls use(labels) for all labelings that roles allow.
    template <class Use>
    void for_each_labeling(const Use& use) const
    {
        for (unsigned bits = 0; bits < 1u << 12; ++bits) {
            std::vector<int> taken;
            bool is_allowed = true;
            for (unsigned i = 0; i < 12; ++i) {
                taken.push_back(bits >> i & 1);
                is_allowed = is_allowed && (roles[i] == PixelRole::free || (roles[i] == PixelRole::taken) == taken[i]);
            }
            if (is_allowed) use(taken);
        }
    }

    PngPixels below, above;
    std::vector<PixelRole> roles;
};

TEST(MinimumCut, CostsTheLeastOfAllLabelings)
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        const SmallProblem problem(seed);
        std::int64_t least = INT64_MAX;
        problem.for_each_labeling([&](const std::vector<int>& taken) {
            least = std::min(least, plain_cost(problem.below, problem.above, taken));
        });
        const SeamCut cut = minimum_cut(problem.below, problem.above, problem.roles, SeamWeight::plain);
        EXPECT_EQ(cut.cost, least) << seed;
        EXPECT_EQ(plain_cost(problem.below, problem.above, {cut.taken.begin(), cut.taken.end()}), least);
    }
}

/// A pixel that a minimum cut keeps is kept by all of them.
TEST(MinimumCut, KeepsAsLittleAsItCan)
{
    int several = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        const SmallProblem problem(seed);
        const SeamCut cut = minimum_cut(problem.below, problem.above, problem.roles, SeamWeight::plain);
        std::vector<int> taken_by_any(12, 0);
        int cuts = 0;
        problem.for_each_labeling([&](const std::vector<int>& taken) {
            if (plain_cost(problem.below, problem.above, taken) != cut.cost) return;
            ++cuts;
            for (std::size_t i = 0; i < 12; ++i) taken_by_any[i] |= taken[i];
        });
        several += cuts > 1;
        for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(cut.taken[i], taken_by_any[i]) << seed << " " << i;
    }
    EXPECT_GT(several, 10);
}

TEST(MinimumCut, HasCostsThatStayInBounds)
{
    PngPixels black{2, 2, 3, std::vector<std::uint8_t>(12, 0)}, white{2, 2, 3, std::vector<std::uint8_t>(12, 255)};
    // No gradient anywhere: the largest cost, of a node's four pairs together below 2^31 by far.
    EXPECT_EQ(pair_cost(black, white, 0, 0, false, SeamWeight::gradient), 1 + 1530 * 512 / 8);
    EXPECT_EQ(pair_cost(black, white, 0, 0, true, SeamWeight::plain), 1531);
    EXPECT_EQ(pair_cost(black, black, 0, 0, true, SeamWeight::gradient), 1);
}

/// All paths with offsets that change by at most 1 a row.
std::int64_t least_error(int rows, int band, int row, int offset, const std::function<std::int64_t(int, int)>& error)
{
    if (row + 1 == rows) return offset == 0 ? error(row, 0) : INT64_MAX / 4;
    std::int64_t best = INT64_MAX / 4;
    for (int next = std::max(offset - 1, -band); next <= std::min(offset + 1, band); ++next)
        best = std::min(best, least_error(rows, band, row + 1, next, error));
    return error(row, offset) + best;
}

TEST(MinimumErrorPath, HasTheLeastErrorOfAllPaths)
{
    std::mt19937 random(5);
    for (int i = 0; i < 30; ++i) {
        const int rows = 9, band = 3;
        std::vector<std::int64_t> errors(static_cast<std::size_t>(rows * 7));
        for (std::int64_t& error : errors) error = random() % 50;
        const auto error = [&](int row, int offset) { return errors[static_cast<std::size_t>(row * 7 + offset + 3)]; };
        const DiagonalPath path = minimum_error_path(rows, band, 1, error);
        EXPECT_EQ(path.error, least_error(rows, band, 0, 0, error));
        std::int64_t sum = 0;
        for (int row = 0; row < rows; ++row) {
            const int offset = path.offsets[static_cast<std::size_t>(row)];
            sum += error(row, offset);
            EXPECT_LE(std::abs(offset), band);
            EXPECT_LE(std::abs(offset - path.offsets[static_cast<std::size_t>(std::max(row - 1, 0))]), 1);
        }
        EXPECT_EQ(sum, path.error);
        EXPECT_EQ(path.offsets.front(), 0);
        EXPECT_EQ(path.offsets.back(), 0);
    }
}

}
}
