// Each claim with results that agree and with results that do not.
#include "reports/claims/paper_claims.hpp"

#include "analysis/zone_plate/zone_plate.hpp"
#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "base/images/square_image_file.hpp"
#include "tests/reports/support/claim_cases.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <ostream>
#include <random>
#include <set>

namespace poissonlab {

void PrintTo(Agreement agreement, std::ostream* out)
{
    *out << (agreement == Agreement::agrees      ? "agrees"
             : agreement == Agreement::partly    ? "partly"
             : agreement == Agreement::disagrees ? "disagrees"
                                                 : "not judged");
}

namespace {

using test::ClaimCase;
using test::darts;
using test::MadeUpCurve;
using test::MadeUpReport;
using test::relaxation;
using test::tiles;
using testing::HasSubstr;
using testing::IsEmpty;

/// The outcome of a claim for a report; empty: it is left out.
std::optional<ClaimOutcome> outcome(const MadeUpReport& report, const std::string& id)
{
    for (const auto& judged : judge_claims(report.series()))
        if (judged.claim->id == id) return judged.outcome;
    return std::nullopt;
}

std::vector<ClaimCase> claim_cases()
{
    std::vector<ClaimCase> cases = test::untiled_claim_cases();
    std::ranges::move(test::tile_claim_cases(), std::back_inserter(cases));
    std::ranges::move(test::later_claim_cases(), std::back_inserter(cases));
    return cases;
}

class PaperClaims : public testing::TestWithParam<ClaimCase>
{
};

TEST_P(PaperClaims, AgreesWithResultsOfThePaper)
{
    MadeUpReport report;
    GetParam().results(report, true);
    const auto judged = outcome(report, GetParam().id);
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::agrees) << judged->measured;
    EXPECT_FALSE(judged->measured.empty());
}

TEST_P(PaperClaims, DisagreesWithOthers)
{
    MadeUpReport report;
    GetParam().results(report, false);
    const auto judged = outcome(report, GetParam().id);
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::disagrees) << judged->measured;
}

std::string name_of(const testing::TestParamInfo<ClaimCase>& info)
{
    std::string name = "claim_" + info.param.id;
    for (char& c : name)
        if (c == '.' || c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, PaperClaims, testing::ValuesIn(claim_cases()), name_of);

TEST(PaperClaimList, ShowsNyquistFrequencyAndOscillationOfEachLaterMethod)
{
    MadeUpReport report;
    for (const char* sampler :
         {"farthest-point", "equal-areas", "target-spectrum", "sample-elimination", "gaussian-blue-noise"}) {
        ReportSeries& series = report.add(sampler, {});
        MadeUpReport::set_curve(series, {});
        test::set_number(series, "effective_nyquist", 0.6789);
        test::set_oscillation(series, 1.25);
    }
    for (const char* paper : {"schloemer-2011", "degoes-2012", "heck-2013", "yuksel-2015", "ahmed-2022"}) {
        const auto shown = outcome(report, paper + std::string("-spectrum"));
        ASSERT_TRUE(shown) << paper;
        EXPECT_EQ(shown->agreement, Agreement::not_judged);
        EXPECT_THAT(shown->measured, HasSubstr("N = 16,384: 0.679 ± 0.007 and 1.25")) << paper;
    }
    EXPECT_FALSE(outcome(MadeUpReport(), "ahmed-2022-spectrum"));
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
    const Estimate excess = mean_excess_with_error(series);
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
    for (const auto& claim : claim_cases()) EXPECT_TRUE(ids.contains(claim.id)) << claim.id;
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
    const_cast<Series*>(tiling.stored)->points = 15552; // 18 x 18 tiles of 48
    set_steep_curve(tiling);
    const auto judged = outcome(report, "6.11-radial");
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::agrees);
    EXPECT_THAT(judged->measured, testing::StartsWith("0.00"));
}

TEST(PaperClaimList, SparserTilingsAreNotOfThePapers)
{
    MadeUpReport report;
    tiles(report, "edge", 2, 64, 20);
    auto& sparser = tiles(report, "corner", 4, 64, 10);
    EXPECT_TRUE(outcome(report, "6.11-better"));
    const_cast<Series*>(sparser.stored)->parameters.emplace_back("density", "0.5");
    EXPECT_FALSE(outcome(report, "6.11-better"));
}

/// The row that the paper calls impossible has what chains do beside it.
TEST(PaperClaimList, PeaksOfChainsStandBesideThoseOfThePaper)
{
    MadeUpReport report;
    tiles(report, "corner", 4, 64, 5);
    auto& chains = tiles(report, "corner", 6, 64, 1.02);
    const_cast<Series*>(chains.stored)->parameters.emplace_back("border", "chain");
    const_cast<Series*>(chains.stored)->measures.numbers["near_lattice_peaks"] = {1.04, {}};
    EXPECT_THAT(outcome(report, "6.7-peaks")->measured,
                HasSubstr("tiles with chains, not of the papers: 1.0 up to the first ring"));
}

TEST(PaperClaimList, ChainsAreNotOfThePapers)
{
    MadeUpReport report;
    tiles(report, "edge", 2, 64, 20);
    auto& chains = tiles(report, "corner", 4, 64, 10);
    EXPECT_TRUE(outcome(report, "6.11-better"));
    const_cast<Series*>(chains.stored)->parameters.emplace_back("border", "chain");
    EXPECT_FALSE(outcome(report, "6.11-better"));
}

TEST(PaperClaimList, LeavesOutWhatTheReportHasNoSeriesFor)
{
    EXPECT_THAT(judge_claims({}), IsEmpty());
    MadeUpReport report;
    report.add("file", {{"path", "points.dat"}});
    EXPECT_THAT(judge_claims(report.series()), IsEmpty());
}

TEST(PaperClaimList, ReachesAreAgreedWithOrInPart)
{
    const struct
    {
        const char* id;
        const char* sampler;
        double radius;
        int dimension;
    } reaches[] = {{"6.3-radius", "dart-throwing", 0.75, 2}, {"6.9-radius", "edge-tiles", 0.85, 2},
                   {"6.11-radius", "corner-tiles", 0.85, 2}, {"6.12-radius", "voronoi-darts", 0.75, 2},
                   {"6.15-darts", "dart-throwing", 0.70, 3}, {"6.15-tiles-radius", "sphere-tiles", 0.75, 3}};
    for (const auto& [id, sampler, radius, dimension] : reaches)
        for (const double factor : {1.0, 0.9}) {
            MadeUpReport report;
            MadeUpReport::set_radius(report.add(sampler, {}, 16384, dimension), factor * radius);
            const auto judged = outcome(report, id);
            ASSERT_TRUE(judged) << id;
            EXPECT_EQ(judged->agreement, factor == 1.0 ? Agreement::agrees : Agreement::partly) << id;
        }
}

TEST(PaperClaimList, TimesAreShownWithTheirMachineAndNotJudged)
{
    MadeUpReport report;
    const_cast<Series*>(darts(report, "0.7").stored)->sample_seconds = {0.010, 0.012, 0.020};
    const auto judged = outcome(report, "6.3-time");
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::not_judged);
    EXPECT_EQ(judged->measured, "ρ = 0.70: 12.0 ms; Test device, 2 threads");
}

TEST(PaperClaimList, BuildingTimesAreThoseOfTheLargestSets)
{
    MadeUpReport report;
    EXPECT_FALSE(outcome(report, "4.5-time"));
    for (const std::uint32_t set : {4096U, 256U})
        const_cast<Series*>(tiles(report, "corner", 4, 64, 5).stored)->tile_set =
            TileSetRecord{set, 64, false, TileSetBuild{set / 1024.0, "d", 2}, {}};
    const auto judged = outcome(report, "4.5-time");
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::not_judged);
    EXPECT_EQ(judged->measured, "4,096 corner-tiles of 64 points: 4.00 s");
}

TEST(PaperClaimList, HalfOfTheCasesIsPartly)
{
    MadeUpReport report;
    MadeUpReport::set_radius(relaxation(report, "0.9", "100"), 0.57);
    MadeUpReport::set_radius(relaxation(report, "0.99", "1000"), 0.60);
    const auto judged = outcome(report, "6.4-radius");
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->agreement, Agreement::partly);
    EXPECT_THAT(judged->measured, HasSubstr("holds in 1 of 2 cases"));
}

// Claims about pictures of the zone plate, with noise and false rings of known strength in them.
class ClaimsOnPictures : public testing::Test
{
protected:
    /// Adds a plate of white noise and of false rings of an amplitude.
    void add_plate(MadeUpReport& report, const std::string& sampler, const NamedTexts& parameters, double amplitude)
    {
        SquareImage picture = zone_plate_reference(128);
        std::normal_distribution<double> noise(0, 0.1);
        for (int row = 0; row < 128; ++row)
            for (int column = 0; column < 128; ++column) {
                const double x = (column + 0.5) * plate_side / 128 - 5, y = (row + 0.5) * plate_side / 128 - 7;
                picture.pixels[static_cast<std::size_t>(row * 128 + column)] +=
                    noise(random_) + amplitude * std::sin(x * x + y * y);
            }
        auto& series = report.add(sampler, parameters, 262144);
        const auto name = std::to_string(count_++) + ".exr";
        write_square_image(folder_.path() / name, picture, {});
        const_cast<poissonlab::Run*>(series.run)->folder = folder_.path();
        ZonePlateResult plate;
        plate.size = 128;
        plate.file = name;
        const_cast<Series*>(series.stored)->zone_plate = plate;
    }

    void expect(const std::string& id, const std::function<void(MadeUpReport&, bool)>& results)
    {
        for (const bool agrees : {true, false}) {
            MadeUpReport report;
            results(report, agrees);
            const auto judged = outcome(report, id);
            ASSERT_TRUE(judged) << id;
            EXPECT_EQ(judged->agreement, agrees ? Agreement::agrees : Agreement::disagrees)
                << id << ": " << judged->measured;
        }
    }

    TemporaryFolder folder_;
    std::mt19937_64 random_{1};
    int count_ = 0;
};

TEST_F(ClaimsOnPictures, OfPatternsAndDarts)
{
    expect("6.2.3-aliasing", [&](MadeUpReport& r, bool agrees) {
        add_plate(r, "regular", {}, agrees ? 0.5 : 0.2);
        add_plate(r, "jittered", {}, agrees ? 0.0 : 0.2);
    });
    expect("6.14-aliasing", [&](MadeUpReport& r, bool agrees) {
        add_plate(r, "recursive-wang-tiles", {{"drawing", "once"}}, agrees ? 0.0 : 0.2);
    });
    expect("6.3-noise", [&](MadeUpReport& r, bool agrees) {
        add_plate(r, "dart-throwing", {{"relative_radius", "0.7"}}, agrees ? 0.0 : 0.2);
    });
}

TEST_F(ClaimsOnPictures, OfTiles)
{
    const auto parameters = [](const char* key, const char* set, const char* rho) {
        return NamedTexts{{key, set}, {"points_per_tile", "64"}, {"relative_radius", rho}};
    };
    expect("6.9-aliasing", [&](MadeUpReport& r, bool agrees) {
        add_plate(r, "edge-tiles", parameters("colors", "2", "0.7"), agrees ? 0.1 : 0.3);
        add_plate(r, "edge-tiles", parameters("colors", "2", "0.8"), agrees ? 0.3 : 0.1);
    });
    expect("6.8-plate", [&](MadeUpReport& r, bool agrees) { add_plate(r, "penrose", {}, agrees ? 0.3 : 0.0); });
    expect("6.10-plate", [&](MadeUpReport& r, bool agrees) {
        add_plate(r, "template-tiles", parameters("tiles", "8", "0.75"), agrees ? 0.3 : 0.0);
    });
    expect("6.10-improves", [&](MadeUpReport& r, bool agrees) {
        add_plate(r, "template-tiles", parameters("tiles", "8", "0.75"), agrees ? 0.3 : 0.1);
        add_plate(r, "template-tiles", parameters("tiles", "64", "0.75"), agrees ? 0.1 : 0.3);
    });
    expect("6.11-plate", [&](MadeUpReport& r, bool agrees) {
        add_plate(r, "corner-tiles", parameters("colors", "3", "0.75"), agrees ? 0.1 : 0.3);
        add_plate(r, "template-tiles", parameters("tiles", "8", "0.75"), agrees ? 0.3 : 0.1);
    });
}

}
}
