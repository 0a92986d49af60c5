// Each claim about what tiles are for, with distributions that agree and with ones that do not.
#include "reports/claims/paper_claims.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace poissonlab {
namespace {

DistributionResult distribution_with(const std::string& kind, const std::map<std::string, double>& numbers)
{
    DistributionResult result;
    result.kind = kind;
    result.facts = {"16 points"};
    for (const auto& [key, value] : numbers) result.numbers.push_back({key, key, value, ""});
    return result;
}

std::optional<ClaimOutcome> judged_by(const std::string& id, const DistributionResult& distribution)
{
    for (const JudgedClaim& judged : judge_claims({}, {&distribution}))
        if (judged.claim->id == id) return judged.outcome;
    return std::nullopt;
}

struct ApplicationCase
{
    const char* id;
    const char* kind;
    std::map<std::string, double> agrees, disagrees;
    const char* measured; ///< of what agrees
};

class ApplicationClaims : public testing::TestWithParam<ApplicationCase>
{
};

TEST_P(ApplicationClaims, AreJudgedByNumbers)
{
    const ApplicationCase& c = GetParam();
    const auto agreed = judged_by(c.id, distribution_with(c.kind, c.agrees));
    ASSERT_TRUE(agreed);
    EXPECT_EQ(agreed->agreement, Agreement::agrees);
    EXPECT_EQ(agreed->measured, c.measured);
    const auto disagreed = judged_by(c.id, distribution_with(c.kind, c.disagrees));
    ASSERT_TRUE(disagreed);
    EXPECT_EQ(disagreed->agreement, Agreement::disagrees);
    EXPECT_FALSE(judged_by(c.id, distribution_with("other", c.agrees)));
    EXPECT_FALSE(judged_by(c.id, distribution_with(c.kind, {})));
}

INSTANTIATE_TEST_SUITE_P(
    All, ApplicationClaims,
    testing::Values(ApplicationCase{"4.7-radii",
                                    "self-similar-tile",
                                    {{"radius_1", 0.69661}, {"radius_2", 0.6528}},
                                    {{"radius_1", 0.7}, {"radius_2", 0.6}},
                                    "0.6966; 0.6528; holds in 2 of 2 cases"},
                    ApplicationCase{"7.2-clumping",
                                    "warp",
                                    {{"least_spacing", 0.2},
                                     {"least_spacing_before", 0.75},
                                     {"mean_spacing", 0.6},
                                     {"mean_spacing_before", 0.8}},
                                    {{"least_spacing", 0.5},
                                     {"least_spacing_before", 0.75},
                                     {"mean_spacing", 0.6},
                                     {"mean_spacing_before", 0.8}},
                                    "least 0.20, 0.75 before; mean 0.60, 0.80 before"},
                    ApplicationCase{"7.3-zoom",
                                    "ranks",
                                    {{"asked_for", 1000}, {"points", 1020}},
                                    {{"asked_for", 1000}, {"points", 1100}},
                                    "2.0 % more than asked for"},
                    ApplicationCase{"7.5-instances",
                                    "instances",
                                    {{"instances", 1010}, {"expected", 1000}},
                                    {{"instances", 1200}, {"expected", 1000}},
                                    "1.01 of the expected number"},
                    ApplicationCase{"7.6-noise-2d",
                                    "objects",
                                    {{"timed_dimension", 2}, {"noise_calls_anywhere", 4}, {"noise_calls_in_rows", 3}},
                                    {{"timed_dimension", 2}, {"noise_calls_anywhere", 6}, {"noise_calls_in_rows", 3}},
                                    "4.0 calls at random places; 3.0 in rows of pixels"},
                    ApplicationCase{"7.6-noise-3d",
                                    "objects",
                                    {{"timed_dimension", 3}, {"noise_calls_anywhere", 19}, {"noise_calls_in_rows", 25}},
                                    {{"timed_dimension", 3}, {"noise_calls_anywhere", 21}, {"noise_calls_in_rows", 25}},
                                    "19 calls at random places; 25 in rows of pixels"}),
    [](const auto& claim) {
        std::string name = claim.param.id;
        std::erase_if(name, [](char c) { return c == '-' || c == '.'; });
        return name;
    });

TEST(ApplicationClaimList, ComesByChapters)
{
    const auto& claims = papers().front().claims;
    const auto at = [&](const std::string& id) {
        return std::ranges::find(claims, id, &PaperClaim::id) - claims.begin();
    };
    EXPECT_LT(at("4.7-radii"), at("6.8-radius"));
    EXPECT_LT(at("6.8-radius"), at("7.2-clumping"));
    EXPECT_LT(at("7.6-noise-3d"), static_cast<std::ptrdiff_t>(claims.size()));
}

}
}
