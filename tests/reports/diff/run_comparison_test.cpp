#include "reports/diff/run_comparison.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "reports/diff/comparison_page.hpp"
#include "reports/diff/comparison_text.hpp"
#include "tests/reports/support/made_up_run.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/temporary_folder.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace poissonlab {
namespace {

using test::MadeUpRun;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class CompareResults : public testing::Test
{
protected:
    RunComparison compare(const MadeUpRun& before, const MadeUpRun& after) const
    {
        test::write_made_up_run(folder_.path() / "old", before);
        test::write_made_up_run(folder_.path() / "new", after);
        return compare_results(folder_.path() / "old", folder_.path() / "new");
    }

    static const NumberComparison& number(const RunComparison& comparison, const std::string& quantity)
    {
        const auto& numbers = comparison.series.at(0).numbers;
        return *std::ranges::find(numbers, quantity, &NumberComparison::quantity);
    }

    TemporaryFolder folder_;
};

TEST_F(CompareResults, FindsNothingBetweenARunAndItself)
{
    const auto comparison = compare({}, {});
    EXPECT_FALSE(comparison.changed());
    EXPECT_GE(comparison.count(Verdict::identical), 7u);
    EXPECT_EQ(comparison.count(Verdict::identical), comparison.series[0].numbers.size());
    EXPECT_THAT(comparison.remarks, IsEmpty());
}

TEST_F(CompareResults, FindsNothingButChanceBetweenSeeds)
{
    MadeUpRun other;
    other.seed = 2;
    const auto comparison = compare({}, other);
    EXPECT_FALSE(comparison.changed()) << comparison_table(comparison, true);
    EXPECT_EQ(number(comparison, "relative radius").verdict, Verdict::within_error);
    EXPECT_EQ(number(comparison, "radially averaged power").verdict, Verdict::within_error);
    EXPECT_EQ(number(comparison, "largest empty circle").verdict, Verdict::not_judged);
    EXPECT_THAT(comparison.remarks, ElementsAre("seed: 1 → 2"));
}

// A relative radius 5 % lower, with a scatter of 1 % over 10 realizations: 11 standard errors.
TEST_F(CompareResults, FindsALowerRadius)
{
    MadeUpRun worse;
    worse.seed = 2;
    worse.series[0].relative_radius = 0.665;
    const auto comparison = compare({}, worse);
    EXPECT_TRUE(comparison.changed());
    const auto& radius = number(comparison, "relative radius");
    EXPECT_EQ(radius.verdict, Verdict::changed);
    EXPECT_EQ(radius.improved(), false);
    EXPECT_EQ(comparison.count(Verdict::changed), 1u);
    EXPECT_THAT(comparison_table(comparison, false), HasSubstr("worse  darts  relative radius  0.7"));
}

TEST_F(CompareResults, FindsAnotherCurve)
{
    MadeUpRun louder;
    louder.seed = 2;
    louder.series[0].power = 1.5;
    const auto comparison = compare({}, louder);
    EXPECT_EQ(number(comparison, "radially averaged power").verdict, Verdict::changed);
    EXPECT_EQ(number(comparison, "pair correlation").verdict, Verdict::within_error);
}

TEST_F(CompareResults, ComparesExactlyWhatIsNotRandom)
{
    MadeUpRun before, after;
    before.series[0].deterministic = after.series[0].deterministic = true;
    before.series[0].realizations = after.series[0].realizations = 1;
    after.series[0].relative_radius = 0.70001;
    const auto comparison = compare(before, after);
    EXPECT_EQ(number(comparison, "relative radius").verdict, Verdict::changed);
    EXPECT_EQ(number(comparison, "effective Nyquist frequency").verdict, Verdict::identical);
}

TEST_F(CompareResults, ListsMissingAndNewSeries)
{
    MadeUpRun before, after;
    before.series = {{.name = "a"}, {.name = "b"}};
    after.series = {{.name = "b"}, {.name = "c"}};
    const auto comparison = compare(before, after);
    EXPECT_THAT(comparison.missing, ElementsAre("a"));
    EXPECT_THAT(comparison.added, ElementsAre("c"));
    EXPECT_TRUE(comparison.changed());
    EXPECT_EQ(comparison.series.size(), 1u);
}

TEST_F(CompareResults, DoesNotCompareTimesOfOtherMachines)
{
    MadeUpRun after;
    after.series[0].seconds = {0.040, 0.041, 0.042};
    EXPECT_EQ(number(compare({}, after), "time to generate").verdict, Verdict::changed);
    after.threads = 4;
    EXPECT_EQ(number(compare({}, after), "time to generate").verdict, Verdict::not_comparable);
    after.threads = 2;
    after.device = "Another device";
    const auto comparison = compare({}, after);
    EXPECT_EQ(number(comparison, "time to generate").verdict, Verdict::not_comparable);
    EXPECT_FALSE(comparison.changed());
    EXPECT_THAT(comparison.remarks, ElementsAre("device: Test device → Another device"));
}

/// A run with a texture whose seams differ so much.
void write_run_with_texture(const std::filesystem::path& folder, double mismatch)
{
    nlohmann::json results = test::write_made_up_run(folder, {});
    const nlohmann::json sets{{"key", "sets"}, {"title", "Sets"}, {"value", 4}, {"meaning", "sets"}};
    const nlohmann::json seams{{"key", "seam_mismatch"},
                               {"title", "Seam mismatch"},
                               {"value", mismatch},
                               {"meaning", "of a natural step"},
                               {"standard_error", 0.01}};
    const nlohmann::json picture{{"file", "texture/a.png"}, {"caption", "A."}};
    results["distributions"] = nlohmann::json::array({{{"name", "texture"},
                                                       {"label", "Texture"},
                                                       {"kind", "texture"},
                                                       {"facts", {"a fact"}},
                                                       {"numbers", nlohmann::json::array({sets, seams})},
                                                       {"pictures", nlohmann::json::array({picture})},
                                                       {"files", nlohmann::json::array()}}});
    std::filesystem::create_directories(folder / "texture");
    write_whole_file(folder / "texture" / "a.png", "no reader looks into it");
    write_whole_file(folder / "results.json", results.dump());
}

TEST_F(CompareResults, ComparesTextures)
{
    write_run_with_texture(folder_.path() / "old", 1.2);
    write_run_with_texture(folder_.path() / "new", 1.5);
    const auto comparison = compare_results(folder_.path() / "old", folder_.path() / "new");
    ASSERT_EQ(comparison.series.size(), 2u);
    const SeriesComparison& texture = comparison.series.back();
    EXPECT_EQ(texture.name(), "texture");
    ASSERT_EQ(texture.numbers.size(), 2u);
    EXPECT_EQ(texture.numbers[0].verdict, Verdict::identical);
    EXPECT_EQ(texture.numbers[1].quantity, "Seam mismatch");
    EXPECT_EQ(texture.numbers[1].verdict, Verdict::changed);
    EXPECT_EQ(texture.numbers[1].improved(), false);
    EXPECT_THAT(comparison_table(comparison, true), HasSubstr("Seam mismatch"));
}

/// A run with a scheme that has these numbers, by their keys.
void write_run_with_scheme(const std::filesystem::path& folder, const std::map<std::string, double>& values)
{
    nlohmann::json results = test::write_made_up_run(folder, {});
    nlohmann::json numbers = nlohmann::json::array();
    for (const auto& [key, value] : values)
        numbers.push_back({{"key", key},
                           {"title", key},
                           {"value", value},
                           {"meaning", ""},
                           {"time", key == "hash" || key == "look-ups"}});
    results["schemes"] = nlohmann::json::array({{{"name", "scheme-noise"},
                                                 {"label", "Noise"},
                                                 {"kind", "noise"},
                                                 {"facts", nlohmann::json::array()},
                                                 {"numbers", numbers},
                                                 {"pictures", nlohmann::json::array()},
                                                 {"files", nlohmann::json::array()}}});
    write_whole_file(folder / "results.json", results.dump());
}

/// Schemes are compared exactly, but for times of the machine.
TEST_F(CompareResults, ComparesSchemes)
{
    const auto old = folder_.path() / "old", other = folder_.path() / "new";
    write_run_with_scheme(old, {{"hash", 5}, {"look-ups", 1e6}, {"period", 739'024}, {"gone", 1}});
    write_run_with_scheme(other, {{"hash", 9}, {"look-ups", 2e6}, {"period", 739'024}, {"here", 1}});
    const auto same = compare_results(old, other);
    EXPECT_FALSE(same.changed());
    std::map<std::string, NumberComparison> numbers;
    for (const NumberComparison& number : same.series.back().numbers) numbers[number.quantity] = number;
    EXPECT_EQ(numbers.size(), 5u);
    EXPECT_EQ(numbers["period"].verdict, Verdict::identical);
    EXPECT_EQ(numbers["hash"].verdict, Verdict::not_judged);
    EXPECT_EQ(numbers["look-ups"].note, "a time of the machine");
    EXPECT_EQ(numbers["gone"].note, "only in the old results");
    EXPECT_EQ(numbers["here"].note, "only in the new results");
    EXPECT_THAT(comparison_table(same, true), HasSubstr("only in the new results"));
    write_run_with_scheme(other, {{"period", 739'025}});
    EXPECT_TRUE(compare_results(old, other).changed());
    write_run_with_scheme(old, {{"offset_ns", 1}}); // how a key is spelled says nothing
    write_run_with_scheme(other, {{"offset_ns", 2}});
    EXPECT_TRUE(compare_results(old, other).changed());
    test::write_made_up_run(other, {});
    EXPECT_THAT(compare_results(old, other).missing, testing::ElementsAre("scheme-noise"));
}

TEST_F(CompareResults, MatchesTheRunsOfCollectionsByFolder)
{
    MadeUpRun worse;
    worse.series[0].relative_radius = 0.6;
    for (const char* collection : {"old", "new"})
        for (const char* name : {"fig-1", "fig-2"})
            test::write_made_up_run(folder_.path() / collection / name,
                                    collection == std::string("new") && name == std::string("fig-2") ? worse
                                                                                                     : MadeUpRun{});
    test::write_made_up_run(folder_.path() / "new/fig-3", {});
    test::write_made_up_collection(folder_.path() / "old", {"fig-1", "fig-2"});
    test::write_made_up_collection(folder_.path() / "new", {"fig-3", "fig-2", "fig-1"});
    const auto comparison = compare_results(folder_.path() / "old", folder_.path() / "new");
    ASSERT_EQ(comparison.series.size(), 2u);
    EXPECT_EQ(comparison.series[0].name(), "fig-1/darts");
    EXPECT_FALSE(comparison.series[0].changed());
    EXPECT_TRUE(comparison.series[1].changed());
    EXPECT_THAT(comparison.added, ElementsAre("fig-3/(all of it)"));
}

TEST_F(CompareResults, SaysWhichCollectionIsWrong)
{
    const auto folder = folder_.path() / "bad";
    folder_.write("bad/collection.json",
                  R"({"format": "poissonlab-collection", "format_version": 1, "runs": ["../x"]})");
    EXPECT_THROW(compare_results(folder, folder), InputError);
    folder_.write("bad/collection.json", R"({"format": "something", "format_version": 1, "runs": ["x"]})");
    EXPECT_THROW(compare_results(folder, folder), InputError);
    folder_.write("bad/collection.json", "[");
    EXPECT_THROW(compare_results(folder, folder), InputError);
}

TEST_F(CompareResults, JsonHoldsEveryNumber)
{
    MadeUpRun worse;
    worse.seed = 2;
    worse.series[0].relative_radius = 0.6;
    const auto comparison = compare({}, worse);
    const auto json = nlohmann::json::parse(comparison_json(comparison));
    EXPECT_EQ(json["changed"], true);
    EXPECT_EQ(json["numbers"].size(), comparison.series[0].numbers.size());
    const auto& first = json["numbers"][0];
    EXPECT_EQ(first["quantity"], "relative radius");
    EXPECT_EQ(first["verdict"], "changed");
    EXPECT_EQ(first["improved"], false);
    EXPECT_EQ(first["old"]["value"], number(comparison, "relative radius").before->value);
    EXPECT_LT(first["p"], comparison_level);
}

TEST_F(CompareResults, NumbersThatDifferLookDifferent)
{
    MadeUpRun before, after;
    before.series[0].deterministic = after.series[0].deterministic = true;
    before.series[0].realizations = after.series[0].realizations = 1;
    after.series[0].relative_radius = 0.700000001;
    const auto texts = number_texts(number(compare(before, after), "relative radius"));
    EXPECT_EQ(texts.before, "0.7");
    EXPECT_EQ(texts.after, "0.700000001");
}

TEST_F(CompareResults, APageShowsTheChanges)
{
    MadeUpRun louder;
    louder.seed = 2;
    louder.version = "0.2.0 (test)";
    louder.series[0].power = 1.5;
    const auto comparison = compare({}, louder);
    const auto out = folder_.path() / "page";
    write_comparison_page(comparison, "old", "new", out);
    const auto page = read_whole_file(out / "diff.html");
    EXPECT_THAT(page, HasSubstr("<h1>What changed</h1>"));
    EXPECT_THAT(page, HasSubstr("version: 0.1.0 (test) → 0.2.0 (test)"));
    EXPECT_THAT(page, HasSubstr("<td>radially averaged power</td>"));
    EXPECT_THAT(page, HasSubstr("src=\"diff-radial-000.svg\""));
    EXPECT_THAT(read_whole_file(out / "diff-radial-000.svg"), testing::AllOf(HasSubstr("old"), HasSubstr("new")));

    test::Browser browser;
    browser.resize(390, 844, true);
    browser.open(out / "diff.html");
    EXPECT_THAT(browser.messages(), IsEmpty());
    EXPECT_THAT(browser.requests(), IsEmpty());
    EXPECT_LE(browser.evaluate("document.documentElement.scrollWidth"), 390);
    EXPECT_GT(browser.evaluate("document.images[0].naturalWidth"), 0);
}

// 200 pairs of runs of one sampler with different seeds: false alarms are binomial with at most the level. The bound is
// passed once in a thousand.
TEST_F(CompareResults, RaisesNoMoreFalseAlarmsThanItsLevel)
{
    constexpr int pairs = 200;
    int alarms = 0;
    for (int pair = 0; pair < pairs; ++pair) {
        MadeUpRun before, after;
        before.series = after.series = {{.name = "a"}, {.name = "b"}};
        before.seed = 1000 + 2 * static_cast<std::uint64_t>(pair);
        after.seed = before.seed + 1;
        alarms += compare(before, after).changed();
    }
    const boost::math::binomial distribution(pairs, comparison_level);
    EXPECT_LE(alarms, quantile(complement(distribution, 1e-3)));
    RecordProperty("alarms", alarms);
}

}
}
