// Every claim of the catalogue, with results that agree with it, results that disagree, and results that leave it open.
#include "tests/reports/support/claim_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace poissonlab {

void PrintTo(Agreement agreement, std::ostream* out)
{
    *out << (agreement == Agreement::agrees      ? "agrees"
             : agreement == Agreement::partly    ? "partly"
             : agreement == Agreement::disagrees ? "disagrees"
             : agreement == Agreement::open      ? "open"
                                                 : "shown");
}

namespace {

using test::ClaimCase;
using test::MadeUpReport;
using test::Told;
using Kind = ClaimCase::Kind;

class EveryClaim : public testing::TestWithParam<ClaimCase>
{
protected:
    static std::optional<ClaimOutcome> outcome(Told what)
    {
        MadeUpReport report;
        GetParam().results(report, what);
        return report.outcome(GetParam().id);
    }

    static void expect(Told what, Agreement agreement)
    {
        const auto judged = outcome(what);
        ASSERT_TRUE(judged) << "the claim is left out";
        EXPECT_EQ(judged->agreement, agreement) << judged->measured;
        EXPECT_FALSE(judged->measured.empty());
    }

    static bool is(Kind kind) { return GetParam().kind == kind; }
};

TEST_P(EveryClaim, AgreesWithResultsOfThePaper)
{
    expect(Told::agreement, is(Kind::shown)          ? Agreement::shown
                            : is(Kind::only_refuted) ? Agreement::open
                                                     : Agreement::agrees);
}

TEST_P(EveryClaim, DisagreesWithOthers)
{
    expect(Told::disagreement, is(Kind::shown) ? Agreement::shown : Agreement::disagrees);
}

TEST_P(EveryClaim, IsOpenWhereResultsDoNotDecide)
{
    if (is(Kind::exact))
        EXPECT_FALSE(outcome(Told::nothing));
    else
        expect(Told::nothing, is(Kind::shown) ? Agreement::shown : Agreement::open);
}

std::string name_of(const testing::TestParamInfo<ClaimCase>& info)
{
    std::string name = "claim_" + info.param.id;
    for (char& c : name)
        if (c == '.' || c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, EveryClaim, testing::ValuesIn(test::all_claim_cases()), name_of);

/// A claim without cases would be one of which nobody knows whether results can refute it.
TEST(ClaimCases, AreThereForEachClaimOnce)
{
    std::multiset<std::string> with_cases;
    for (const ClaimCase& claim : test::all_claim_cases()) with_cases.insert(claim.id);
    for (const Paper& paper : papers())
        for (const PaperClaim& claim : paper.claims) EXPECT_EQ(with_cases.count(claim.id), 1U) << claim.id;
    std::size_t claims = 0;
    for (const Paper& paper : papers()) claims += paper.claims.size();
    EXPECT_EQ(with_cases.size(), claims) << "some case is of no claim";
}

/// Readers see which rows are not judged, and why.
TEST(ClaimCases, CriteriaOfShownClaimsSayThatTheyAreShown)
{
    std::set<std::string> shown;
    for (const ClaimCase& claim : test::all_claim_cases())
        if (claim.kind == Kind::shown) shown.insert(claim.id);
    for (const Paper& paper : papers())
        for (const PaperClaim& claim : paper.claims)
            EXPECT_EQ(claim.criterion.find("shown") != std::string::npos, shown.contains(claim.id))
                << claim.id << ": " << claim.criterion;
}

}
}
