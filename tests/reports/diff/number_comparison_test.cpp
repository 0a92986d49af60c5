#include "reports/diff/number_comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace poissonlab {
namespace {

using testing::HasSubstr;

const ComparisonTerms other_seed{};
const ComparisonTerms same_seed{true, false, false};
const ComparisonTerms deterministic{false, true, false};
const ComparisonTerms tiles_of_other_seed{false, false, true};
const ComparisonTerms tiles_of_same_seed{true, false, true};

NumberComparison judged(const SampleMean& before, const SampleMean& after, const ComparisonTerms& terms)
{
    NumberComparison number;
    number.before = before;
    number.after = after;
    judge(number, terms);
    return number;
}

TEST(NumberComparison, EqualNumbersAreIdenticalUnderAllTerms)
{
    for (const auto& terms : {other_seed, same_seed, deterministic, tiles_of_other_seed})
        EXPECT_EQ(judged({0.7, 0.1, 10}, {0.7, 0.1, 10}, terms).verdict, Verdict::identical);
}

TEST(NumberComparison, NumbersWithErrorsAreTested)
{
    // t = 1 / sqrt(2) with 18 degrees of freedom: p = 0.4886 by the incomplete beta function, R's 2 * pt(-0.7071068,
    // 18).
    const auto number = judged({0, 1, 10}, {1, 1, 10}, other_seed);
    ASSERT_TRUE(number.p);
    EXPECT_NEAR(*number.p, 0.4886, 0.001);
}

TEST(NumberComparison, AnyDifferenceOfWhatIsNotRandomIsAChange)
{
    EXPECT_EQ(judged({0.7, 0, 1}, {0.7000001, 0, 1}, deterministic).verdict, Verdict::changed);
    EXPECT_EQ(judged({0.7, 0, 1}, {0.7000001, 0, 1}, same_seed).verdict, Verdict::changed);
    // The last bits of another processor.
    EXPECT_EQ(judged({0.7, 0, 1}, {0.7 + 1e-15, 0, 1}, deterministic).verdict, Verdict::within_error);
}

TEST(NumberComparison, OneRealizationOfAnotherSeedTellsNothing)
{
    const auto number = judged({0.7, 0, 1}, {0.5, 0, 1}, other_seed);
    EXPECT_EQ(number.verdict, Verdict::not_judged);
    EXPECT_FALSE(number.p);
    EXPECT_THAT(number.note, HasSubstr("one realization"));
}

TEST(NumberComparison, TheSpreadOfOneTileSetIsNotThatBetweenTileSets)
{
    const auto number = judged({0.7, 0.001, 10}, {0.6, 0.001, 10}, tiles_of_other_seed);
    EXPECT_EQ(number.verdict, Verdict::not_judged);
    EXPECT_THAT(number.note, HasSubstr("tile set"));
    EXPECT_TRUE(judged({0.7, 0.001, 10}, {0.6, 0.001, 10}, tiles_of_same_seed).p);
}

TEST(NumberComparison, NumbersWithoutStoredErrorsAreNotJudged)
{
    EXPECT_EQ(judged({0.7, 0, 10}, {0.6, 0, 10}, other_seed).verdict, Verdict::not_judged);
}

TEST(NumberComparison, RealizationsWithoutSpreadAreWhatTheyAre)
{
    NumberComparison number;
    judge(number, std::array{0.7, 0.7, 0.7}, std::array{0.6, 0.6, 0.6}, other_seed);
    EXPECT_EQ(number.verdict, Verdict::changed);
    number = {};
    judge(number, std::array{0.7, 0.7, 0.7}, std::array{0.6, 0.6, 0.6}, tiles_of_other_seed);
    EXPECT_EQ(number.verdict, Verdict::not_judged);
}

TEST(NumberComparison, EqualMeansOfOtherValuesAreNotIdentical)
{
    NumberComparison number;
    judge(number, std::array{1.0, 2.0, 3.0}, std::array{3.0, 2.0, 1.0}, other_seed);
    EXPECT_NE(number.verdict, Verdict::identical);
}

std::vector<CurvePoint> line(double error)
{
    std::vector<CurvePoint> curve;
    for (int i = 0; i < 50; ++i) curve.push_back({static_cast<double>(i), {1, error, 10}});
    return curve;
}

TEST(CurveComparison, NamesThePlaceOfTheLargestDifference)
{
    const auto before = line(0.01);
    auto after = before;
    after[20].mean.value = 1.02;
    after[31].mean.value = 1.20;
    NumberComparison number;
    judge(number, before, after, "frequency", other_seed);
    ASSERT_TRUE(number.p);
    EXPECT_EQ(number.after->value, 1.20);
    EXPECT_THAT(number.note, HasSubstr("at frequency 31"));
    // 2 of 50 points differ and were tested; the others are equal.
    EXPECT_DOUBLE_EQ(*number.p, 2 * welch_test({1, 0.01, 10}, {1.20, 0.01, 10}).p_value);
}

TEST(CurveComparison, ExactCurvesAllowRoundingBesideTheirPeakOnly)
{
    auto before = line(0);
    before[0].mean.value = 1e-20;
    auto after = before;
    after[0].mean.value = 3e-20; // power of a lattice where there is none
    NumberComparison number;
    judge(number, before, after, "frequency", deterministic);
    EXPECT_EQ(number.verdict, Verdict::within_error);
    after[7].mean.value = 1.001;
    number = {};
    judge(number, before, after, "frequency", deterministic);
    EXPECT_EQ(number.verdict, Verdict::changed);
    EXPECT_THAT(number.note, HasSubstr("at frequency 7"));
    EXPECT_EQ(number.before->value, 1);
}

TEST(CurveComparison, OtherPlacesDoNotCompare)
{
    const auto before = line(0.01);
    auto after = before;
    after.pop_back();
    NumberComparison number;
    judge(number, before, after, "frequency", other_seed);
    EXPECT_EQ(number.verdict, Verdict::not_comparable);
}

TEST(TimeComparison, NeedsAGapAndAFactor)
{
    const auto verdict = [](std::vector<double> before, std::vector<double> after) {
        NumberComparison number;
        number.better = Better::lower;
        judge_times(number, before, after);
        return number.verdict;
    };
    EXPECT_EQ(verdict({1, 1.1, 1.2}, {1, 1.1, 1.2}), Verdict::identical);
    EXPECT_EQ(verdict({1, 1.1, 1.2}, {1.3, 1.4, 1.5}), Verdict::within_error); // apart, but by less than half
    EXPECT_EQ(verdict({1, 1.1, 3}, {2, 2.1, 2.2}), Verdict::within_error);     // far, but not apart
    EXPECT_EQ(verdict({1, 1.1, 1.2}, {2, 2.1, 2.2}), Verdict::changed);
    EXPECT_EQ(verdict({2, 2.1, 2.2}, {1, 1.1, 1.2}), Verdict::changed);
    EXPECT_EQ(verdict({1}, {9}), Verdict::not_judged);
}

TEST(NumberComparison, VerdictsAreSettledTogether)
{
    std::vector<NumberComparison> numbers(3);
    numbers[0].p = 0.004; // times 2 for two tests: 0.008
    numbers[1].p = 0.009; // the second smallest: times 1
    numbers[2].verdict = Verdict::identical;
    std::vector<NumberComparison*> pointers;
    for (auto& number : numbers) pointers.push_back(&number);
    settle_verdicts(pointers);
    EXPECT_EQ(numbers[0].verdict, Verdict::changed);
    EXPECT_EQ(numbers[1].verdict, Verdict::changed);
    EXPECT_EQ(numbers[2].verdict, Verdict::identical);
    numbers[0].p = 0.006;
    settle_verdicts(pointers);
    EXPECT_EQ(numbers[0].verdict, Verdict::within_error);
    EXPECT_EQ(numbers[1].verdict, Verdict::within_error);
}

}
}
