// Sentences about series, and which is best for what.
#include "reports/pages/verdicts.hpp"

#include "reports/pages/ranking_order.hpp"
#include "tests/reports/support/made_up_series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A series with the numbers that sentences are about.
ReportSeries& add_series(test::MadeUpReport& report, const char* name, double radius, double noise, double directions,
                         const NamedTexts& parameters = {})
{
    ReportSeries& series = report.add(name, parameters);
    series.full_label = name;
    test::MadeUpReport::set_radii(series, {radius - 0.001, radius + 0.001});
    auto& numbers = test::stored_of(series).measures.numbers;
    numbers["low_frequency_mean"] = {noise, noise / 50};
    numbers["anisotropy_above_chance"] = {directions, {}};
    return series;
}

std::string sentence(double radius, double noise, double directions)
{
    test::MadeUpReport report;
    return sentence_about(add_series(report, "a", radius, noise, directions));
}

TEST(Verdicts, FollowFromTheNumbers)
{
    EXPECT_EQ(sentence(0.75, 0.062, 0),
              "Strengths: all points keep apart (least ρ = 0.749); little noise at low frequencies, "
              "6.2 % of that of random points; no preferred directions.");
    EXPECT_EQ(
        sentence(0.45, 0.002, 12.34),
        "Strengths: little noise at low frequencies, 0.20 % of that of random points. Weaknesses: some points are "
        "near each other (least ρ = 0.449); directions or peaks, 12.3 dB above chance.");
}

TEST(Verdicts, OfNoiseNeverContradictTheNumber)
{
    EXPECT_THAT(sentence(0.7, 0.099, 0), HasSubstr("little noise at low frequencies, 9.9 %"));
    EXPECT_THAT(sentence(0.7, 0.4, 0), HasSubstr("Weaknesses: noise at low frequencies, 40 %"));
    EXPECT_THAT(sentence(0.7, 0.6, 0), HasSubstr("much noise at low frequencies, 60 %"));
    EXPECT_THAT(sentence(0.7, 1.02, 0), HasSubstr("as noisy at low frequencies as random points"));
    EXPECT_THAT(sentence(0.7, 1.6, 0), HasSubstr("more noise at low frequencies than random points have, 160 %"));
}

/// The mean at low frequencies may be small where the lowest ones are not; powers below a thousandth do not show.
TEST(Verdicts, TellOfLongWaves)
{
    const auto of_exponent = [](double noise, double exponent) {
        test::MadeUpReport report;
        ReportSeries& series = add_series(report, "a", 0.75, noise, 0);
        test::stored_of(series).measures.numbers["hyperuniformity_exponent"] = {exponent, 0.1};
        return sentence_about(series);
    };
    EXPECT_THAT(of_exponent(0.016, -1.7), HasSubstr("Weaknesses: long waves, as the power rises towards frequency 0."));
    for (const std::string& said : {of_exponent(0.016, -0.25), of_exponent(0.016, 2), of_exponent(1e-5, -1.8)})
        EXPECT_THAT(said, Not(HasSubstr("long waves")));
}

TEST(Verdicts, SayNothingOfEvennessWhereSetsFollowADensity)
{
    test::MadeUpReport report;
    const std::string of_density =
        sentence_about(add_series(report, "a", 0.1, 0.9, 5, {{"density", "gauss-and-waves"}}));
    EXPECT_THAT(of_density, HasSubstr("follow a density"));
    for (const char* words : {"ρ", "noise", "chance"}) EXPECT_THAT(of_density, Not(HasSubstr(words)));
    EXPECT_FALSE(follows_density(add_series(report, "b", 0.1, 0.9, 5, {{"density", "2.5"}}))) << "the same everywhere";
    ReportSeries& in_region = add_series(report, "c", 0.1, 0.9, 5);
    test::stored_of(in_region).region.emplace().has_density = true;
    EXPECT_TRUE(follows_density(in_region));
}

TEST(Verdicts, JudgeSetsThatAreNotPeriodicWithinTheirSquare)
{
    test::MadeUpReport report;
    ReportSeries& series = add_series(report, "a", 0.146, 0.1, 9);
    test::stored_of(series).border = BorderResult{33, 1e-40, 0.721, 0.8};
    EXPECT_EQ(sentence_about(series),
              border_words(*series.stored) + " Strengths: all points keep apart (mean ρ = 0.721).");
    EXPECT_THAT(border_notice(series), HasSubstr("--periodic no"));
    test::stored_of(series).border->chance = 0.2;
    EXPECT_EQ(border_notice(series), "");
    EXPECT_THAT(sentence_about(series), HasSubstr("points nearly meet (least ρ = 0.145)"));
}

TEST(Verdicts, OfOlderResultsFollowFromTheCurve)
{
    test::MadeUpReport report;
    ReportSeries& series = report.add("a", {});
    EXPECT_FALSE(anisotropy_above_chance(series));
    series.curve.periodograms = 10;
    test::MadeUpReport::set_curve(series, {});
    EXPECT_FALSE(anisotropy_above_chance(series)) << "the spectrum is too short";
    test::stored_of(series).spectrum_size = 8192;
    EXPECT_EQ(anisotropy_above_chance(series), 0);
    series.curve.bins.clear();
    test::MadeUpReport::set_curve(series, {.spike = 20});
    EXPECT_GT(anisotropy_above_chance(series).value(), 18);
}

TEST(RankingOrder, IsByTheRadiusAndThoseThatDoNotCompareComeLast)
{
    test::MadeUpReport report;
    add_series(report, "small", 0.3, 0.1, 0);
    add_series(report, "density", 0.95, 0.1, 0, {{"density", "ramp"}});
    add_series(report, "large", 0.8, 0.1, 0);
    std::vector<std::string> labels;
    for (const ReportSeries* series : ranking_order(report.series())) labels.push_back(series->full_label);
    EXPECT_THAT(labels, ElementsAre("large", "small", "density"));
}

TEST(RankingOrder, MarksTheBestAndWhatIsAsGood)
{
    test::MadeUpReport report;
    add_series(report, "a", 0.800, 0.1, 0);
    const ReportSeries& best = add_series(report, "b", 0.801, 0.1, 0); // errors of the means: 0.001 each
    const ReportSeries& worse = add_series(report, "c", 0.790, 0.1, 0);
    add_series(report, "d", 0.99, 0.1, 0, {{"density", "ramp"}});
    const auto all = report.series();
    const Measure& radius = measure("relative_radius");
    ASSERT_EQ(best_to_mark(radius, all, 2), &best);
    EXPECT_TRUE(is_as_good(radius, *all[0], best));
    EXPECT_FALSE(is_as_good(radius, worse, best));
    EXPECT_EQ(best_to_mark(measure("low_frequency_mean"), all, 2), nullptr) << "all are as good";
    EXPECT_EQ(best_to_mark(radius, all, 3), nullptr);
}

/// Jittered points have an effective Nyquist frequency where best candidate, which levels out just above the limit of
/// the mean power, has none: neither has a wide range almost without noise.
TEST(RankingOrder, NamesNoWideRangeWhereNoneIs)
{
    test::MadeUpReport report;
    const auto add = [&](const char* name, double noise, double nyquist, const char* answer) {
        Series& stored = test::stored_of(add_series(report, name, 0.5, noise, 0));
        stored.measures.numbers["effective_nyquist"] = {nyquist, {}};
        stored.blue_noise = BlueNoiseVerdict{answer, ""};
    };
    add("jittered", 0.1, 0.25, "weakly");
    add("best candidate", 0.13, 0, "weakly");
    const auto is_of_range = [](const BestFor& best) { return std::string(best.what).starts_with("the widest"); };
    EXPECT_TRUE(std::ranges::none_of(best_series(report.series(), 2), is_of_range));
    EXPECT_EQ(blue_noise_words(report.series(), 2), "Blue noise? Weakly: jittered; best candidate.");
    add("darts", 0.06, 0.63, "yes");
    EXPECT_TRUE(std::ranges::any_of(best_series(report.series(), 2), is_of_range));
    EXPECT_EQ(blue_noise_words(report.series(), 2), "Blue noise? Yes: darts. Weakly: jittered; best candidate.");
    EXPECT_EQ(blue_noise_words(report.series(), 3), "");
}

TEST(RankingOrder, NamesTheBestOfThoseWithoutDirections)
{
    test::MadeUpReport report;
    add_series(report, "lattice", 1, 0.0001, 25);
    add_series(report, "even", 0.9, 0.01, 0);
    add_series(report, "quiet", 0.7, 0.001, 0);
    const auto best = best_series(report.series(), 2);
    ASSERT_EQ(best.size(), 2U);
    EXPECT_EQ(best[0].series->full_label, "even");
    EXPECT_EQ(best[1].series->full_label, "quiet");
    EXPECT_EQ(directions_words(report.series(), 2), "Left out here for their preferred directions: lattice.");
    EXPECT_EQ(hidden_best_words(report.series(), 2), "Of all series, the best would be lattice for points far apart; "
                                                     "lattice for little noise at low frequencies.");
    EXPECT_EQ(hidden_best_words(report.series(), 3), "");
    EXPECT_TRUE(best_series(report.series(), 3).empty());
}

}
}
