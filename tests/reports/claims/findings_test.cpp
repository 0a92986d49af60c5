// Values against limits, and what many say together.
#include "reports/claims/findings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

TEST(Findings, AreOpenWithinTwoStandardErrors)
{
    EXPECT_EQ(is_above({1.21, 0.1}, 1), Finding::holds);
    EXPECT_EQ(is_above({1.19, 0.1}, 1), Finding::open);
    EXPECT_EQ(is_above({0.81, 0.1}, 1), Finding::open);
    EXPECT_EQ(is_above({0.79, 0.1}, 1), Finding::fails);
    EXPECT_EQ(is_below({0.79, 0.1}, 1), Finding::holds);
    EXPECT_EQ(is_below({0.81, 0.1}, 1), Finding::open);
    EXPECT_EQ(is_below({1.21, 0.1}, 1), Finding::fails);
    EXPECT_EQ(is_within({1.5, 0.1}, 1, 2), Finding::holds);
    EXPECT_EQ(is_within({1.9, 0.1}, 1, 2), Finding::open);
    EXPECT_EQ(is_within({2.3, 0.1}, 1, 2), Finding::fails);
    EXPECT_EQ(is_above({1, {}}, 1), Finding::fails) << "an exact value is not above itself";
}

TEST(Findings, HaveErrorsOfIndependentValues)
{
    const Estimate difference = difference_of({5, 0.3}, {2, 0.4});
    EXPECT_DOUBLE_EQ(difference.value, 3);
    EXPECT_DOUBLE_EQ(*difference.standard_error, 0.5);
    const Estimate ratio = ratio_of({6, 0.18}, {2, 0.08}); // 3 % and 4 %
    EXPECT_DOUBLE_EQ(ratio.value, 3);
    EXPECT_DOUBLE_EQ(*ratio.standard_error, 0.15);
    EXPECT_FALSE(ratio_of({6, {}}, {2, {}}).standard_error);
}

TEST(Findings, OfRealizationsHaveTheErrorOfTheirMean)
{
    const Estimate mean = mean_of_realizations({1, 2, 3, {1, 2, 3}});
    EXPECT_DOUBLE_EQ(mean.value, 2);
    EXPECT_DOUBLE_EQ(*mean.standard_error, 1 / std::sqrt(3.0));
    EXPECT_FALSE(mean_of_realizations({1, 2, 3, {}}).standard_error);
}

Tally tally_of(int held, int failed, int open)
{
    Tally tally;
    for (int i = 0; i < held; ++i) tally.add(Finding::holds);
    for (int i = 0; i < failed; ++i) tally.add(Finding::fails);
    for (int i = 0; i < open; ++i) tally.add(Finding::open);
    return tally;
}

TEST(Tally, NeedsAQuarterOfItsCases)
{
    EXPECT_EQ(tally_of(4, 0, 0).agreement(), Agreement::agrees);
    EXPECT_EQ(tally_of(2, 2, 0).agreement(), Agreement::partly);
    EXPECT_EQ(tally_of(1, 2, 0).agreement(), Agreement::disagrees);
    EXPECT_EQ(tally_of(1, 0, 3).agreement(), Agreement::agrees);
    EXPECT_EQ(tally_of(1, 0, 4).agreement(), Agreement::open);
    EXPECT_EQ(tally_of(0, 0, 1).agreement(), Agreement::open);
    EXPECT_TRUE(tally_of(0, 0, 0).empty());
}

TEST(Tally, SaysHowManyCasesItHas)
{
    EXPECT_EQ(tally_of(1, 0, 0).words(), "");
    EXPECT_EQ(tally_of(40, 2, 0).words(), "holds in 40 of 42 cases");
    EXPECT_EQ(tally_of(40, 2, 1).words(), "holds in 40 of 42 cases, 1 more is open");
    EXPECT_EQ(tally_of(1, 0, 2).words(), "holds in 1 of 1 cases, 2 more are open");
    EXPECT_EQ(tally_of(0, 0, 1).words(), "not decided");
    EXPECT_EQ(tally_of(0, 0, 7).words(), "none of 7 cases is decided");
}

}
}
