// The nearest known patches, against sums over all patches: the same bits.
#include "tiles/texture/known_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace poissonlab {
namespace {

float slow_distance(std::span<const float> a, std::span<const float> b)
{
    float head = 0, tail = 0;
    for (std::size_t k = 0; k < a.size(); ++k) (k < 8 ? head : tail) += (a[k] - b[k]) * (a[k] - b[k]);
    return head + tail;
}

/// Blocks have 64 patches; numbers beside each other differ in size, as coefficients do.
TEST(KnownPatches, HaveTheBitsOfAllDistances)
{
    for (const std::size_t count : {1, 2, 3, 63, 64, 65, 128, 129, 1000})
        for (const std::size_t numbers : {8, 9, 16, 40})
            for (const int levels : {1, 2, 5, 100000}) {
                std::mt19937 random(static_cast<unsigned>(count + numbers) + static_cast<unsigned>(levels));
                const auto patch = [&, levels = levels, numbers = numbers](float shift) {
                    std::vector<float> values;
                    for (std::size_t k = 0; k < numbers; ++k)
                        values.push_back(shift + static_cast<float>(random() % static_cast<unsigned>(levels)) *
                                                     std::exp(-0.3F * static_cast<float>(k)));
                    return values;
                };
                std::vector<std::vector<float>> known;
                for (std::size_t i = 0; i < count; ++i) known.push_back(patch(0));
                const KnownPatches patches({known.begin(), known.end()});
                for (int i = 0; i < 60; ++i) {
                    const std::vector<float> asked = i == 0 ? known.back() : patch(i < 30 ? 0.0F : 1.5F);
                    float least = std::numeric_limits<float>::infinity();
                    for (const auto& one : known) least = std::min(least, slow_distance(asked, one));
                    ASSERT_EQ(patches.nearest_distance(asked), least) << count << " " << numbers << " " << levels;
                    EXPECT_TRUE(patches.has_near(asked, least));
                    EXPECT_TRUE(patches.has_near(asked, 2 * least));
                    if (least == 0) continue;
                    EXPECT_FALSE(patches.has_near(asked, std::nextafter(least, 0.0F)));
                    EXPECT_FALSE(patches.has_near(asked, 0));
                }
            }
}

}
}
