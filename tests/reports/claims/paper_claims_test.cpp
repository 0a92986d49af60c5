// The list of claims, and what single claims look at.
#include "host/modules/manifest.hpp"
#include "reports/claims/claim_curves.hpp"
#include "reports/claims/paper_claims.hpp"
#include "tests/reports/support/claim_cases.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

namespace poissonlab {
namespace {

using test::darts;
using test::MadeUpReport;
using test::relaxation;
using test::stored_of;
using test::tiles;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(PaperClaimList, ShowsNyquistFrequencyAndOscillationOfEachLaterMethod)
{
    MadeUpReport report;
    for (const char* sampler :
         {"farthest-point", "equal-areas", "target-spectrum", "sample-elimination", "gaussian-blue-noise"}) {
        ReportSeries& series = report.add(sampler, {});
        MadeUpReport::set_curve(series, {});
        test::set_number(series, "effective_nyquist", 0.6789, 0.007);
        test::set_oscillation(series, 1.25, 0.02);
    }
    for (const char* paper : {"schloemer-2011", "degoes-2012", "heck-2013", "yuksel-2015", "ahmed-2022"})
        EXPECT_THAT(report.outcome(paper + std::string("-spectrum"))->measured,
                    HasSubstr("N = 16,384: 0.679 ± 0.007 and 1.250 ± 0.020"))
            << paper;
    EXPECT_FALSE(MadeUpReport().outcome("ahmed-2022-spectrum"));
}

/// Tilings of 22.6 x 22.6 tiles, with power below 9 cycles, beside a set without tiles; alone, those of order 0 say
/// nothing of moments.
TEST(PaperClaimList, TilingsWithEqualMomentsStandBesideSetsWithoutTiles)
{
    MadeUpReport report;
    const auto tiling = [&](const char* moments, double exponent, double low) {
        ReportSeries& series = report.add("corner-tiles", {{"points_per_tile", "32"}, {"equal_moments", moments}});
        test::set_number(series, "hyperuniformity_exponent", exponent, 0.05);
        MadeUpReport::set_curve(series, {.low = low});
    };
    tiling("0", 1.8, 0.02);
    EXPECT_FALSE(report.outcome("gabrielli-2008-exponent"));
    tiling("2", 5.5, 1e-4);
    EXPECT_THAT(report.outcome("gabrielli-2008-exponent")->measured, HasSubstr("m = 2: 5.50 ± 0.05; holds in 2 of 2"));
    MadeUpReport::set_curve(test::lloyd(report, 20), {.low = 0.01});
    EXPECT_THAT(report.outcome("gabrielli-2008-exponent")->measured,
                HasSubstr("those with equal moments have 0.010 times the power of sets without tiles"));
}

/// Two rings of 100 samples, 1 dB and 3 dB above chance, and one that is too small.
TEST(PaperClaimList, AnisotropyHasTheErrorOfItsRings)
{
    MadeUpReport report;
    ReportSeries& series = report.add("farthest-point", {});
    series.curve.background_db = -10;
    series.curve.bins = {{.frequency = 1, .power = 1, .anisotropy_db = 5, .samples = 8},
                         {.frequency = 20, .power = 1, .anisotropy_db = -9, .samples = 100},
                         {.frequency = 21, .power = 1, .anisotropy_db = -7, .samples = 100}};
    const Estimate excess = mean_excess_anisotropy(series);
    EXPECT_DOUBLE_EQ(excess.value, 2);
    EXPECT_DOUBLE_EQ(excess.standard_error.value(), 1);
}

TEST(PaperClaimList, HasEachClaimOnceWithItsSection)
{
    std::set<std::string> ids;
    for (const Paper& paper : papers())
        for (const auto& claim : paper.claims) {
            const bool is_numbered = paper.key == "lagae-2007";
            EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
            EXPECT_TRUE(claim.id.starts_with((is_numbered ? claim.section : paper.key) + "-")) << claim.id;
            EXPECT_FALSE(claim.says.empty() || claim.criterion.empty()) << claim.id;
        }
}

TEST(PaperClaimList, ComesByChapters)
{
    const auto& claims = papers().front().claims;
    const auto at = [&](const std::string& id) {
        return std::ranges::find(claims, id, &PaperClaim::id) - claims.begin();
    };
    EXPECT_EQ(claims.front().section.substr(0, 2), "2.");
    EXPECT_LT(at("4.7-radii"), at("6.8-radius"));
    EXPECT_LT(at("6.8-radius"), at("6.15-lloyd"));
    EXPECT_LT(at("6.15-lloyd"), at("7.2-clumping"));
    EXPECT_EQ(claims.back().section.substr(0, 2), "8.");
}

/// Readers filter and sort claims: each is a sentence that needs none before it.
TEST(PaperClaimList, ClaimsStandAlone)
{
    const auto leans_on_another = [](const std::string& text) {
        constexpr std::array words{"It ",   "Its ",  "They ", "Their ", "Those ",
                                   "This ", "That ", "So ",   "And ",   "the same"};
        return std::ranges::any_of(words, [&](const char* word) { return text.starts_with(word); });
    };
    for (const Paper& paper : papers())
        for (const auto& claim : paper.claims) {
            EXPECT_TRUE(claim.says.ends_with('.')) << claim.id << ": " << claim.says;
            EXPECT_FALSE(std::islower(static_cast<unsigned char>(claim.says[0]))) << claim.id << ": " << claim.says;
            EXPECT_FALSE(leans_on_another(claim.says)) << claim.id << ": " << claim.says;
            EXPECT_FALSE(leans_on_another(claim.criterion)) << claim.id << ": " << claim.criterion;
        }
}

/// A curve that rises steeply at the principal frequency of so many points.
void set_steep_curve(ReportSeries& series)
{
    const double ring = std::sqrt(static_cast<double>(series.stored->points));
    series.curve.bins.clear();
    for (int k = 1; k <= 300; ++k) {
        RadialBin bin{};
        bin.frequency = k;
        bin.power = 4 / (1 + std::exp(-100 * (k / ring - 1)));
        bin.samples = 200;
        series.curve.bins.push_back(bin);
    }
}

TEST(PaperClaimList, CurvesOfSetsOfDifferentSizesAreComparedAtEqualDensity)
{
    MadeUpReport report;
    set_steep_curve(report.add("lloyd", {{"until_relative_radius", "0.75"}, {"repulsion", "true"}}));
    auto& tiling = tiles(report, "corner", 4, 48, 5);
    stored_of(tiling).points = 15552; // 18 x 18 tiles of 48
    set_steep_curve(tiling);
    const auto judged = report.outcome("6.11-radial");
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::agrees);
    EXPECT_THAT(judged->measured, testing::StartsWith("0.00"));
}

TEST(PaperClaimList, SparserTilingsAreNotOfThePapers)
{
    MadeUpReport report;
    tiles(report, "edge", 2, 64, 20);
    auto& sparser = tiles(report, "corner", 4, 64, 10);
    EXPECT_TRUE(report.outcome("6.11-better"));
    stored_of(sparser).parameters.emplace_back("density", "0.5");
    EXPECT_FALSE(report.outcome("6.11-better"));
}

/// The row that the paper calls impossible has what chains do beside it.
TEST(PaperClaimList, PeaksOfChainsStandBesideThoseOfThePaper)
{
    MadeUpReport report;
    tiles(report, "corner", 4, 64, 5);
    auto& chains = tiles(report, "corner", 6, 64, 1.02);
    stored_of(chains).parameters.emplace_back("border", "chain");
    stored_of(chains).measures.numbers["near_lattice_peaks"] = {1.04, {}};
    EXPECT_THAT(report.outcome("6.7-peaks")->measured,
                HasSubstr("tiles with chains, not of the papers: 1.0 up to the first ring"));
}

TEST(PaperClaimList, ChainsAreNotOfThePapers)
{
    MadeUpReport report;
    tiles(report, "edge", 2, 64, 20);
    auto& chains = tiles(report, "corner", 4, 64, 10);
    EXPECT_TRUE(report.outcome("6.11-better"));
    stored_of(chains).parameters.emplace_back("border", "chain");
    EXPECT_FALSE(report.outcome("6.11-better"));
}

/// A program without the module asks for it by this. The vertices of a dodecagonal tiling are a sequence, and claims
/// about tiles say nothing of them.
TEST(PaperClaimList, KnowsWhichMethodsTile)
{
    for (const ManifestEntry& entry : manifest()) {
        if (entry.word != ManifestWord::sampler) continue;
        MadeUpReport report;
        report.add(entry.name, {});
        const bool is_of_tiles =
            entry.module == "tiles" || (entry.module == "other_tiles" && entry.name != "dodecagonal");
        EXPECT_EQ(ClaimSeries(report.series()).has_tiles(), is_of_tiles) << entry.name;
    }
    DistributionResult scheme;
    EXPECT_TRUE(ClaimSeries({}, {&scheme}).has_tiles());
}

TEST(PaperClaimList, LeavesOutWhatTheReportHasNoSeriesFor)
{
    EXPECT_THAT(judge_claims({}), IsEmpty());
    MadeUpReport report;
    report.add("file", {{"path", "points.dat"}});
    EXPECT_THAT(judge_claims(report.series()), IsEmpty());
}

TEST(PaperClaimList, TimesAreShownWithTheirMachineAndNotJudged)
{
    MadeUpReport report;
    stored_of(darts(report, "0.7")).sample_seconds = {0.010, 0.012, 0.020};
    const auto judged = report.outcome("6.3-time");
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::shown);
    EXPECT_EQ(judged->measured, "ρ = 0.70: 12.0 ms; Test device, 2 threads");
}

TEST(PaperClaimList, BuildingTimesAreThoseOfTheLargestSets)
{
    MadeUpReport report;
    EXPECT_FALSE(report.outcome("4.5-time"));
    for (const std::uint32_t set : {4096U, 256U})
        stored_of(tiles(report, "corner", 4, 64, 5)).tile_set =
            TileSetRecord{set, 64, false, TileSetBuild{set / 1024.0, "d", 2}, {}};
    const auto judged = report.outcome("4.5-time");
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::shown);
    EXPECT_EQ(judged->measured, "4,096 corner-tiles of 64 points: 4.00 s");
}

TEST(PaperClaimList, HalfOfTheCasesIsPartly)
{
    MadeUpReport report;
    MadeUpReport::set_radius(relaxation(report, "0.9", "100"), 0.57);
    MadeUpReport::set_radii(relaxation(report, "0.99", "1000"), {0.599, 0.6, 0.601});
    const auto judged = report.outcome("6.4-radius");
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::partly);
    EXPECT_THAT(judged->measured, HasSubstr("holds in 1 of 2 cases"));
}

/// Sets that go on until nothing fits end farther than the paper says, whatever their number of points.
TEST(PaperClaimList, FullSetsAreAmongThoseOfDartThrowing)
{
    MadeUpReport report;
    MadeUpReport::set_radius(darts(report, "0.75"), 0.75);
    EXPECT_EQ(report.outcome("6.3-radius")->agreement, Agreement::agrees);
    MadeUpReport::set_radius(report.add("dart-throwing", {{"stop", "saturation"}}, 20110), 0.7754);
    EXPECT_EQ(report.outcome("6.3-radius")->agreement, Agreement::partly);
    EXPECT_THAT(report.outcome("6.3-radius")->measured, HasSubstr("0.7754 in every realization, which is more"));
}

TEST(PaperClaimList, RadiiByRepulsionHoldInPart)
{
    for (const auto& [id, sampler] : {std::pair("6.9-radius", "edge-tiles"), {"6.11-radius", "corner-tiles"}}) {
        MadeUpReport report;
        MadeUpReport::set_radius(report.add(sampler, {{"relative_radius", "0.85"}, {"repulsion", "true"}}), 0.85);
        EXPECT_EQ(report.outcome(id)->agreement, Agreement::partly);
        EXPECT_THAT(report.outcome(id)->measured, AllOf(HasSubstr("by repulsion"), HasSubstr("no series is without")));
        MadeUpReport::set_radius(report.add(sampler, {{"relative_radius", "0.75"}}), 0.75);
        EXPECT_THAT(report.outcome(id)->measured, HasSubstr("without it 0.7500"));
        MadeUpReport::set_radius(report.add(sampler, {{"relative_radius", "0.85"}}), 0.85);
        EXPECT_EQ(report.outcome(id)->agreement, Agreement::agrees);
    }
}

/// However far two tile sets are apart, one of each leaves it open whether others of their kinds are.
TEST(PaperClaimList, OneTileSetOfEachKindLeavesItOpen)
{
    MadeUpReport report;
    ReportSeries &few = tiles(report, "corner", 2, 64, 40), &many = tiles(report, "corner", 4, 64, 5);
    EXPECT_EQ(report.outcome("6.7-more-tiles")->agreement, Agreement::agrees);
    EXPECT_THAT(report.outcome("6.7-more-tiles")->measured, testing::Not(HasSubstr("one tile set")));
    test::have_one_set(few);
    test::have_one_set(many);
    EXPECT_EQ(report.outcome("6.7-more-tiles")->agreement, Agreement::open);
    EXPECT_THAT(report.outcome("6.7-more-tiles")->measured, HasSubstr("cases of one tile set (sets = 1) are open"));
}

/// The best series of a method does not stand for it.
TEST(PaperClaimList, EverySeriesOfEdgeTilesIsComparedWithEveryOneOfAveragedTiles)
{
    MadeUpReport report;
    for (const char* sampler : {"edge-tiles", "averaged-tiles"})
        for (const double radius : {0.6, 0.8}) {
            ReportSeries& series = report.add(sampler, {{"sets", "3"}});
            MadeUpReport::set_radius(series, radius);
            MadeUpReport::set_curve(series, {.anisotropy = sampler[0] == 'e' ? 1.0 : 3.0, .scatter = 0.1});
        }
    EXPECT_EQ(report.outcome("6.16-averaged")->agreement, Agreement::partly);
    EXPECT_THAT(report.outcome("6.16-averaged")->measured, HasSubstr("holds in 5 of 8 cases"));
}

TEST(PaperClaimList, CountsOfSpectraBeyondLimitsAreCalibration)
{
    MadeUpReport report;
    tiles(report, "template", 8, 64, 200, 3);
    tiles(report, "template", 16, 64, 200, 1);
    EXPECT_THAT(report.outcome("6.10-bad")->measured, HasSubstr("beyond the limits: 1 of 2 series"));
    for (const PaperClaim& claim : papers().front().claims)
        if (claim.id == "6.10-bad" || claim.id == "6.10-good" || claim.id == "6.11-good") {
            EXPECT_THAT(claim.criterion, testing::StartsWith("calibration"));
        }
}

}
}
