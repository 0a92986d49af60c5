// Claims that schemes answer: what they say of made-up numbers.
#include "reports/claims/paper_claims.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace poissonlab {
namespace {

using Numbers = std::vector<std::pair<std::string, double>>;

DistributionResult scheme_of(const std::string& kind, const Numbers& numbers)
{
    DistributionResult scheme;
    scheme.kind = kind;
    for (const auto& [key, value] : numbers) scheme.numbers.push_back({key, key, value, ""});
    return scheme;
}

/// The outcome of a claim; "" where it is not there.
std::string agreement_of(const std::string& id, const DistributionResult& scheme)
{
    const auto claims = judge_claims({}, {&scheme});
    const auto found = std::ranges::find_if(claims, [&](const JudgedClaim& judged) { return judged.claim->id == id; });
    if (found == claims.end()) return "";
    switch (found->outcome.agreement) {
    case Agreement::agrees:
        return "agrees";
    case Agreement::partly:
        return "partly";
    case Agreement::disagrees:
        return "disagrees";
    case Agreement::not_judged:
        break;
    }
    return "not judged";
}

TEST(TilingClaims, JudgeTheCornerProblem)
{
    const auto outcome = [](double wang, double corner) {
        return agreement_of(
            "2.6-corner-problem",
            scheme_of("corner-problem", {{"wang_pairs", wang}, {"compact_wang_pairs", 1}, {"corner_pairs", corner}}));
    };
    EXPECT_EQ(outcome(1, 0.5), "agrees");
    EXPECT_EQ(outcome(0.9, 0.5), "disagrees");
    EXPECT_EQ(outcome(1, 1), "disagrees");
    EXPECT_EQ(agreement_of("2.6-corner-problem", scheme_of("corner-problem", {{"wang_pairs", 1}})), "");
}

TEST(TilingClaims, JudgeCountsOfHashesAndPeriods)
{
    const auto costs = [](double two, double period) {
        return scheme_of("tiling-costs", {{"corner_evaluations", 4},
                                          {"two_hashes_evaluations", two},
                                          {"one_hash_evaluations", 4},
                                          {"edge_hash_evaluations", 4},
                                          {"period", period}});
    };
    EXPECT_EQ(agreement_of("3.3-wang-evaluations", costs(8, 1)), "agrees");
    EXPECT_EQ(agreement_of("3.3-wang-evaluations", costs(7, 1)), "disagrees");
    EXPECT_EQ(agreement_of("3.4-period", costs(8, 5'930'659'848.0)), "agrees");
    EXPECT_EQ(agreement_of("3.4-period", costs(8, 5'930'659'849.0)), "disagrees");
    EXPECT_EQ(agreement_of("3.4-noise-period", scheme_of("noise", {{"long_period", 739'024}})), "agrees");
    EXPECT_EQ(agreement_of("3.4-noise-period", scheme_of("noise", {{"long_period", 739'025}})), "disagrees");
    EXPECT_EQ(agreement_of("3.4-noise-time", scheme_of("noise", {{"hash_time_ratio", 9}, {"noise_time_ratio", 1}})),
              "not judged");
}

TEST(TilingClaims, JudgeTimesByTheirRatios)
{
    const auto outcome = [](double wang, double corner) {
        return agreement_of("3.5-direct", scheme_of("tiling-costs", {{"scanline_wang_ns", 10},
                                                                     {"scanline_corner_ns", 10},
                                                                     {"edge_hash_streamed_ns", wang},
                                                                     {"corner_streamed_ns", corner},
                                                                     {"edge_hash_long_streamed_ns", wang},
                                                                     {"corner_long_streamed_ns", corner}}));
    };
    EXPECT_EQ(outcome(2, 10), "agrees");
    EXPECT_EQ(outcome(12, 10), "partly");
    EXPECT_EQ(outcome(12, 12), "disagrees");
}

TEST(TilingClaims, JudgeCornerTilesAgainstEachAlgorithmForWangTiles)
{
    const auto outcome = [](double corner, double slow_corner) {
        Numbers numbers;
        for (const char* where : {"_streamed_ns", "_anywhere_ns", "_long_streamed_ns", "_long_anywhere_ns"}) {
            for (const char* wang : {"two_hashes", "one_hash", "edge_hash"})
                numbers.emplace_back(std::string(wang) + where, 10);
            numbers.emplace_back(std::string("corner") + where, numbers.size() < 4 ? slow_corner : corner);
        }
        return agreement_of("3.5-corner", scheme_of("tiling-costs", numbers));
    };
    EXPECT_EQ(outcome(10, 10), "agrees");
    EXPECT_EQ(outcome(10, 12), "partly");
    EXPECT_EQ(outcome(12, 12), "disagrees");
}

TEST(TilingClaims, JudgeChoicesOfCompactSetsAlone)
{
    const auto outcome = [](double fewest, const std::string& set) {
        DistributionResult scheme = scheme_of("scanline", {{"tiles", 8}, {"fewest_choices", fewest}});
        scheme.facts = {"8 tiles in the " + set + " set"};
        return agreement_of("3.2-choices", scheme);
    };
    EXPECT_EQ(outcome(2, "compact"), "agrees");
    EXPECT_EQ(outcome(1, "compact"), "disagrees");
    EXPECT_EQ(outcome(4, "complete"), "");
}

TEST(TilingClaims, JudgeNoiseAndPartsOfPeriods)
{
    const auto parts = [](double large, double small) {
        return agreement_of("3.4-parts", scheme_of("noise", {{"parts_of_large", large}, {"parts_of_small", small}}));
    };
    EXPECT_EQ(parts(0.02, 0.9), "agrees");
    EXPECT_EQ(parts(0.2, 0.9), "disagrees");
    EXPECT_EQ(parts(0.02, 0.4), "disagrees");
    const auto look = [](double deviation) {
        return agreement_of("3.4-noise-look", scheme_of("noise", {{"plain_deviation", 0.25},
                                                                  {"long_deviation", deviation},
                                                                  {"plain_repeat", 1},
                                                                  {"long_repeat", 0}}));
    };
    EXPECT_EQ(look(0.26), "agrees");
    EXPECT_EQ(look(0.22), "disagrees");
}

TEST(TilingClaims, JudgeStructureOfAperiodicTilings)
{
    const auto outcome = [](double ammann, double kari) {
        return agreement_of("3.1-structured", scheme_of("diffraction", {{"strongest_ammann", ammann},
                                                                        {"strongest_kari", kari},
                                                                        {"strongest_scanline-compact", 0.0079}}));
    };
    EXPECT_EQ(outcome(0.5, 0.1), "agrees");
    EXPECT_EQ(outcome(0.5, 0.02), "partly");
    EXPECT_EQ(outcome(0.02, 0.02), "disagrees");
}

TEST(TilingClaims, JudgeTheSmallestAperiodicSet)
{
    const auto outcome = [](double width, double height) {
        return agreement_of("8.3-smallest", scheme_of("aperiodic-tables", {{"claimed_tiles", 44},
                                                                           {"claimed_period_width", width},
                                                                           {"claimed_period_height", height},
                                                                           {"smallest_tiles", 49}}));
    };
    EXPECT_EQ(outcome(2, 3), "disagrees");
    EXPECT_EQ(outcome(0, 0), "partly") << "no search proves it";
    const auto tables = [](double same) {
        return agreement_of("8.3-tables",
                            scheme_of("aperiodic-tables", {{"numbers", 10}, {"same", same}, {"unavailable", 3}}));
    };
    EXPECT_EQ(tables(10), "agrees");
    EXPECT_EQ(tables(9), "partly");
    EXPECT_EQ(tables(4), "disagrees");
}

TEST(TilingClaims, StandBeforeThoseOfLaterChapters)
{
    std::vector<std::string> sections;
    for (const PaperClaim& claim : papers().front().claims) sections.push_back(claim.section);
    EXPECT_EQ(sections.front().substr(0, 2), "2.");
    EXPECT_EQ(sections.back().substr(0, 2), "8.");
}

}
}
