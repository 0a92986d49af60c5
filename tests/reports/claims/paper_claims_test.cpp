// Each claim with results that agree and with results that do not.
#include "reports/claims/paper_claims.hpp"

#include "analysis/zone_plate/zone_plate.hpp"
#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "base/images/square_image_file.hpp"
#include "tests/reports/support/made_up_series.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
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

using test::MadeUpCurve;
using test::MadeUpReport;
using testing::HasSubstr;
using testing::IsEmpty;

/// What a claim says of a report; empty: it is left out.
std::optional<ClaimOutcome> outcome(const MadeUpReport& report, const std::string& id)
{
    for (const auto& judged : judge_claims(report.series()))
        if (judged.claim->id == id) return judged.outcome;
    return std::nullopt;
}

/// Results for a claim, as the paper has them or not.
struct ClaimCase
{
    std::string id;
    std::function<void(MadeUpReport&, bool agrees)> results;
};

void PrintTo(const ClaimCase& claim, std::ostream* out) { *out << claim.id; }

ReportSeries& darts(MadeUpReport& report, const std::string& rho, std::size_t points = 16384, int dimension = 2)
{
    return report.add("dart-throwing", {{"relative_radius", rho}}, points, dimension);
}

ReportSeries& jones(MadeUpReport& report, std::size_t points = 16384)
{
    return report.add("voronoi-darts", {{"relative_radius", "0.75"}}, points);
}

ReportSeries& relaxation(MadeUpReport& report, const std::string& factor, const std::string& attempts,
                         std::size_t points = 16384, int dimension = 2)
{
    return report.add("relaxation-dart-throwing",
                      {{"initial_radius", "0.15"}, {"factor", factor}, {"attempts", attempts}}, points, dimension);
}

ReportSeries& lloyd(MadeUpReport& report, int iterations, std::size_t points = 16384, int dimension = 2)
{
    return report.add("lloyd",
                      {{"iterations", std::to_string(iterations)}, {"start", "dart-throwing (relative_radius = 0.7)"}},
                      points, dimension);
}

/// `speckle`: anisotropy between the peaks, in dB above chance.
ReportSeries& tiles(MadeUpReport& report, const std::string& kind, int set, int points_per_tile, double mean_peak,
                    double speckle = 1)
{
    auto& series = report.add(kind + "-tiles", {{kind == "template" ? "tiles" : "colors", std::to_string(set)},
                                                {"points_per_tile", std::to_string(points_per_tile)}});
    MadeUpReport::set_curve(series, {});
    MadeUpReport::set_peaks(series, static_cast<int>(std::lround(std::sqrt(16384.0 / points_per_tile))), mean_peak);
    const_cast<Series*>(series.stored)->measures.numbers["off_lattice_anisotropy"] = {speckle, {}};
    return series;
}

void set_seconds(ReportSeries& series, double seconds)
{
    const_cast<Series*>(series.stored)->sample_seconds = {seconds};
}

/// A method beside three others: more anisotropic than they are, or not.
void among_others(MadeUpReport& report, const std::string& sampler, bool is_worse)
{
    for (const char* other : {"lloyd", "edge-tiles", "corner-tiles"})
        MadeUpReport::set_curve(report.add(other, {}), {.anisotropy = 1});
    MadeUpReport::set_curve(report.add(sampler, {}), {.anisotropy = is_worse ? 5.0 : 0.2});
}

/// From `start` to `end`, there after so many of 128 iterations.
std::vector<double> relaxed(double start, double end, int settled)
{
    std::vector<double> radii;
    for (int i = 0; i <= 128; ++i)
        radii.push_back(start + (end - start) * std::min(1.0, static_cast<double>(i) / settled));
    return radii;
}

const std::vector<ClaimCase>& claim_cases()
{
    static const std::vector<ClaimCase> cases = {
        {"6.2.2-flat",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("random", {}), {.low = 1, .peak = agrees ? 1.0 : 3.0});
         }},
        {"6.2.2-poisson-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("random", {}), {.low = 1, .peak = 1, .anisotropy = agrees ? 0.1 : 3});
         }},
        {"6.2.2-disk-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(darts(r, "0.75"), {.anisotropy = agrees ? 0.1 : 3});
         }},
        {"6.2.2-blue-noise",
         [](MadeUpReport& r, bool agrees) { MadeUpReport::set_curve(darts(r, "0.75"), {.low = agrees ? 0.05 : 0.5}); }},
        {"6.3-spectrum",
         [](MadeUpReport& r, bool agrees) { MadeUpReport::set_curve(darts(r, "0.7"), {.beyond = agrees ? 1 : 1.3}); }},
        {"6.3-plate",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_plate_error(darts(r, "0.7", 262144), 0.01, agrees ? 0.05 : 0.2);
             MadeUpReport::set_plate_error(r.add("jittered", {}, 262144), 0.02, 0.1);
         }},
        {"6.4-radius",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(relaxation(r, "0.9", "100"), agrees ? 0.573 : 0.6);
         }},
        {"6.4-steeper",
         [](MadeUpReport& r, bool agrees) {
             // At its radius dart throwing has a width of 0.25.
             for (const auto& [rho, width] : {std::pair("0.6", 0.3), {"0.7", 0.2}}) {
                 ReportSeries& series = darts(r, rho);
                 MadeUpReport::set_curve(series, {.width = width});
                 MadeUpReport::set_radius(series, std::stod(rho));
             }
             ReportSeries& relaxed_darts = relaxation(r, "0.99", "1000");
             MadeUpReport::set_curve(relaxed_darts, {.width = agrees ? 0.23 : 0.27});
             MadeUpReport::set_radius(relaxed_darts, 0.65);
         }},
        {"6.4-plate",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_plate_error(darts(r, "0.7", 262144), 0.01, 0.1);
             MadeUpReport::set_plate_error(relaxation(r, "0.99", "1000", 262144), 0.01, agrees ? 0.05 : 0.2);
         }},
        {"6.5-converges",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_iterations(lloyd(r, 128), relaxed(0.6, 0.8, agrees ? 20 : 400));
         }},
        {"6.5-increases",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_iterations(lloyd(r, 128), relaxed(0.7, agrees ? 0.8 : 0.65, 20));
         }},
        {"6.5-fewer-points",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_iterations(lloyd(r, 128, 256), relaxed(0.7, agrees ? 0.82 : 0.76, 20));
             MadeUpReport::set_iterations(lloyd(r, 128, 4096), relaxed(0.7, 0.79, 20));
         }},
        {"6.5-settles",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_iterations(lloyd(r, 128), relaxed(0.6, agrees ? 0.8 : 0.7, 20));
         }},
        {"6.5-peaks",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(lloyd(r, 1), {.peak = 1.5, .width = 0.2});
             MadeUpReport::set_curve(lloyd(r, 4), {.peak = agrees ? 2.5 : 1.2, .width = agrees ? 0.1 : 0.3});
         }},
        {"6.5-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(lloyd(r, 0), {});
             MadeUpReport::set_curve(lloyd(r, 16), {.anisotropy = agrees ? 0.1 : 2});
         }},
        {"6.5-grid",
         [](MadeUpReport& r, bool agrees) {
             auto& series = lloyd(r, 128);
             MadeUpReport::set_iterations(series, relaxed(0.6, 0.8, 20));
             const double six = agrees ? 0.7 : 0.99;
             const_cast<Series*>(series.stored)->measures.voronoi =
                 VoronoiStatistics{0.01, {0, 0.5 - six / 2, six, 0.5 - six / 2, 0}};
         }},
        {"6.6-flawed",
         [](MadeUpReport& r, bool agrees) {
             auto& series = r.add("shade-tiles", {{"points_per_tile", "32"}});
             const_cast<Series*>(series.stored)->measures.numbers["seam_density"] = {agrees ? 0.5 : 0.05, {}};
         }},
        {"6.7-across",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(r.add("averaged-tiles", {{"iterations", "29"}}), agrees ? 0.4 : 0.6);
         }},
        {"6.7-converges",
         [](MadeUpReport& r, bool agrees) {
             auto& series = r.add("averaged-tiles", {{"iterations", "128"}});
             MadeUpReport::set_radius(series, 0.6);
             MadeUpReport::set_iterations(series, relaxed(0.1, 0.6, agrees ? 200 : 20));
         }},
        {"6.7-peaks", [](MadeUpReport& r, bool agrees) { tiles(r, "corner", 4, 64, agrees ? 5 : 1); }},
        {"6.7-more-tiles",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "corner", 2, 64, 40);
             tiles(r, "corner", 4, 64, agrees ? 8 : 80);
         }},
        {"6.7-less-common",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "template", 16, 32, 40);
             tiles(r, "template", 16, 64, agrees ? 8 : 80);
         }},
        {"6.9-low",
         [](MadeUpReport& r, bool agrees) {
             for (const char* rho : {"0.7", "0.8"})
                 MadeUpReport::set_plate_error(
                     r.add("edge-tiles", {{"colors", "2"}, {"points_per_tile", "32"}, {"relative_radius", rho}},
                           262144),
                     (rho == std::string("0.8")) == agrees ? 0.01 : 0.02, 0.1);
         }},
        {"6.9-fast",
         [](MadeUpReport& r, bool agrees) {
             const_cast<Series*>(darts(r, "0.7").stored)->sample_seconds = {0.1};
             const_cast<Series*>(tiles(r, "edge", 2, 64, 10).stored)->sample_seconds = {agrees ? 0.01 : 1.0};
         }},
        {"6.10-bad", [](MadeUpReport& r, bool agrees) { tiles(r, "template", 8, 64, 200, agrees ? 4 : 1); }},
        {"6.10-good", [](MadeUpReport& r, bool agrees) { tiles(r, "template", 32, 64, agrees ? 200 : 400); }},
        {"6.10-alike",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "template", 128, 64, 10);
             tiles(r, "template", 256, 64, agrees ? 9.8 : 5);
         }},
        {"6.10-pronounced",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "template", 256, 64, 10);
             tiles(r, "corner", 4, 64, agrees ? 2 : 20);
         }},
        {"6.10-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             auto& series = tiles(r, "template", 8, 64, 10);
             series.curve.bins.clear();
             MadeUpReport::set_curve(series, {.spike = agrees ? 20.0 : 0.0});
         }},
        {"6.11-tiles",
         [](MadeUpReport& r, bool agrees) {
             TileSetRecord set;
             set.tiles = agrees ? 81 : 80;
             set.points_per_tile = 64;
             const_cast<Series*>(tiles(r, "corner", 3, 64, 10).stored)->tile_set = set;
         }},
        {"6.11-good", [](MadeUpReport& r, bool agrees) { tiles(r, "corner", 3, 64, 5, agrees ? 1.5 : 2.5); }},
        {"6.11-better",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "edge", 2, 64, 20);
             tiles(r, "corner", 4, 64, agrees ? 10 : 30);
         }},
        {"6.11-peaks",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "edge", 2, 64, 20);
             tiles(r, "corner", 8, 64, agrees ? 3 : 15);
         }},
        {"6.11-radial",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("lloyd", {{"until_relative_radius", "0.75"}, {"repulsion", "true"}}), {});
             auto& series = tiles(r, "corner", 4, 64, 5);
             series.curve.bins.clear();
             MadeUpReport::set_curve(series, {.beyond = agrees ? 1.01 : 1.5});
         }},
        {"6.11-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             for (const char* kind : {"corner", "edge"}) {
                 auto& series = tiles(r, kind, kind == std::string("corner") ? 4 : 2, 64, 5);
                 series.curve.bins.clear();
                 MadeUpReport::set_curve(series, {.spike = (kind == std::string("edge")) == agrees ? 20.0 : 5.0});
             }
         }},
        {"6.12-spectrum",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(darts(r, "0.75"), {});
             MadeUpReport::set_curve(jones(r), {.beyond = agrees ? 1.01 : 1.2});
         }},
        {"6.12-plate",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_plate_error(darts(r, "0.75", 262144), 0.1, 0.2);
             MadeUpReport::set_plate_error(jones(r, 262144), 0.1, agrees ? 0.2005 : 0.25);
         }},
        {"6.12-fast",
         [](MadeUpReport& r, bool agrees) {
             const_cast<Series*>(darts(r, "0.75").stored)->sample_seconds = {0.02};
             const_cast<Series*>(jones(r).stored)->sample_seconds = {agrees ? 0.01 : 0.05};
         }},
        {"6.13-logarithmic",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("dart-throwing", {{"stop", "saturation"}}), {});
             MadeUpReport::set_curve(r.add("sector-darts", {{"variant", "logarithmic"}}),
                                     {.beyond = agrees ? 1.01 : 1.5});
         }},
        {"6.13-linear",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("dart-throwing", {{"stop", "saturation"}}), {});
             MadeUpReport::set_curve(r.add("sector-darts", {{"variant", "linear"}}), {.beyond = agrees ? 1.1 : 0.9});
         }},
        {"6.13-skew",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("sector-darts", {{"variant", "linear"}}),
                                     {.anisotropy = agrees ? 2.0 : 0.1});
         }},
        {"6.13-boundary",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("dart-throwing", {{"stop", "saturation"}}), {});
             MadeUpReport::set_curve(r.add("sector-darts", {{"variant", "boundary"}}), {.beyond = agrees ? 1.5 : 1.1});
         }},
        {"6.14-radius",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(r.add("recursive-wang-tiles", {{"drawing", "once"}}), agrees ? 0.0005 : 0.5);
             MadeUpReport::set_radius(r.add("recursive-wang-tiles", {{"drawing", "twice"}}), agrees ? 0.5 : 0.0);
             MadeUpReport::set_radius(
                 r.add("recursive-wang-tiles", {{"drawing", "once"}, {"density", "gauss-and-waves"}}), 0.2);
         }},
        {"6.14-spectrum",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("recursive-wang-tiles", {{"drawing", "once"}}),
                                     {.low = agrees ? 0.5 : 0.05});
         }},
        {"6.14-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("recursive-wang-tiles", {{"drawing", "once"}}),
                                     {.anisotropy = agrees ? 4.0 : 0.1});
         }},
        {"6.13-fast",
         [](MadeUpReport& r, bool agrees) {
             const auto add = [&](const char* variant, double seconds) {
                 const_cast<Series*>(r.add("sector-darts", {{"variant", variant}}).stored)->sample_seconds = {seconds};
             };
             add("logarithmic", 1);
             add("linear", agrees ? 0.9 : 0.2);
             add("boundary", agrees ? 0.02 : 0.5);
         }},
        {"6.8-radius",
         [](MadeUpReport& r, bool agrees) { MadeUpReport::set_radius(r.add("penrose", {}), agrees ? 0.7 : 0.8); }},
        {"6.8-star",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("penrose", {}), {.spike = agrees ? 20.0 : 3.0});
         }},
        {"6.8-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("penrose", {}), {.anisotropy = agrees ? 6.0 : 0.5});
             tiles(r, "corner", 4, 64, 2);
         }},
        {"6.16-not-interactive",
         [](MadeUpReport& r, bool agrees) { set_seconds(darts(r, "0.7"), agrees ? 0.2 : 0.01); }},
        {"6.16-interactive",
         [](MadeUpReport& r, bool agrees) { set_seconds(r.add("sector-darts", {}), agrees ? 0.05 : 0.5); }},
        {"6.16-real-time",
         [](MadeUpReport& r, bool agrees) { set_seconds(tiles(r, "corner", 4, 64, 2), agrees ? 0.001 : 0.05); }},
        {"6.16-only-option", [](MadeUpReport& r, bool agrees) { set_seconds(darts(r, "0.7"), agrees ? 0.02 : 0.01); }},
        {"6.16-shade",
         [](MadeUpReport& r, bool agrees) {
             const_cast<Series*>(r.add("shade-tiles", {}).stored)->measures.numbers["seam_density"] = {
                 agrees ? 0.4 : 0.1, {}};
         }},
        {"6.16-averaged",
         [](MadeUpReport& r, bool agrees) {
             auto &averaged = r.add("averaged-tiles", {}), &edges = r.add("edge-tiles", {});
             MadeUpReport::set_radius(averaged, agrees ? 0.6 : 0.8);
             MadeUpReport::set_radius(edges, 0.75);
             MadeUpReport::set_curve(averaged, {.anisotropy = agrees ? 3.0 : 0.1});
             MadeUpReport::set_curve(edges, {.anisotropy = 1});
         }},
        {"6.16-template",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("template-tiles", {}), {.anisotropy = agrees ? 3.0 : 0.1});
             MadeUpReport::set_curve(r.add("corner-tiles", {}), {.anisotropy = 1});
         }},
        {"6.16-corner",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(tiles(r, "edge", 2, 64, 2), {.anisotropy = 2});
             MadeUpReport::set_curve(tiles(r, "corner", 4, 64, 2), {.anisotropy = agrees ? 1.0 : 3.0});
         }},
        {"6.16-penrose", [](MadeUpReport& r, bool agrees) { among_others(r, "penrose", agrees); }},
        {"6.16-recursive", [](MadeUpReport& r, bool agrees) { among_others(r, "recursive-wang-tiles", agrees); }},
        {"6.16-recursive-radius",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(r.add("recursive-wang-tiles", {}), agrees ? 0.3 : 0.6);
         }},
        {"6.15-relaxation",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_radius(relaxation(r, "0.99", "1000", 65536, 3), agrees ? 0.702 : 0.6);
         }},
        {"6.9-wavelike",
         [](MadeUpReport& r, bool agrees) {
             tiles(r, "edge", 2, 32, 10, agrees ? 0.9 : 0.1);
             tiles(r, "corner", 4, 32, 10, 0.7);
             tiles(r, "corner", 8, 32, 10, 0.2); // the largest is what counts
         }},
        {"6.10-radial",
         [](MadeUpReport& r, bool agrees) {
             ReportSeries& series = tiles(r, "template", 64, 32, 100);
             for (RadialBin& bin : series.curve.bins)
                 if (bin.frequency == series.stored->measures.lattice_peaks->tiles) bin.power *= agrees ? 3 : 1.5;
         }},
        {"6.11-corner-points",
         [](MadeUpReport& r, bool agrees) {
             for (const int points : {32, 64}) {
                 ReportSeries& series =
                     r.add("corner-tiles",
                           {{"colors", "4"}, {"points_per_tile", std::to_string(points)}, {"relative_radius", "0.75"}});
                 const double corners = agrees ? 3.1 : points / 5.0;
                 const_cast<Series*>(series.stored)->tile_set =
                     TileSetRecord{256, 64, true, {}, {{"corners", corners, 3.1}, {"edges", 7, 7}}};
             }
         }},
        {"6.15-lloyd",
         [](MadeUpReport& r, bool agrees) {
             auto stuck = relaxed(0.6, 0.78, 100);
             for (std::size_t i = 20; i < 100; i += 5) stuck[i] -= 0.01;
             MadeUpReport::set_iterations(lloyd(r, 128, 4096, 2), agrees ? relaxed(0.6, 0.79, 20) : stuck);
             MadeUpReport::set_iterations(lloyd(r, 128, 4096, 3), agrees ? stuck : relaxed(0.6, 0.79, 20));
         }},
        {"6.15-spectrum",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(darts(r, "0.7", 65536, 3), {.low = agrees ? 0.05 : 0.5});
         }},
        {"6.15-symmetry",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(darts(r, "0.7", 65536, 3), {.anisotropy = agrees ? 0.0 : 2.0});
         }},
        {"6.15-tiles-radial",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("sphere-tiles", {{"colors", "2"}}, 65536, 3), {.low = agrees ? 0.05 : 0.5});
         }},
        {"6.15-tiles-anisotropy",
         [](MadeUpReport& r, bool agrees) {
             MadeUpReport::set_curve(r.add("sphere-tiles", {{"colors", "2"}}, 65536, 3),
                                     {.anisotropy = agrees ? 2.0 : 0.0});
         }},
    };
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

TEST(PaperClaimList, HasEachClaimOnceWithItsSection)
{
    std::set<std::string> ids;
    for (const auto& claim : paper_claims()) {
        EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
        EXPECT_TRUE(claim.id.starts_with(claim.section + "-")) << claim.id;
        EXPECT_FALSE(claim.says.empty() || claim.criterion.empty()) << claim.id;
    }
    for (const auto& claim : claim_cases()) EXPECT_TRUE(ids.contains(claim.id)) << claim.id;
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

/// What the paper calls impossible is said beside what chains do.
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
