// Sets in a region are analysed as such: nothing goes around the torus, lengths are in roots of the area.
#include "analysis/regions/random_in_region.hpp"
#include "base/files/byte_archive.hpp"
#include "base/geometry/relative_radius.hpp"
#include "experiment/measuring/series_analysis.hpp"
#include "results/curve_tables.hpp"
#include "tests/support/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>

namespace poissonlab {
namespace {

/// A strip_region of 400 x 100, and six points in it, in its units.
constexpr const char* strip_region = "rectangle 1000 2000 1400 2100";
const PointSet six{2, {1010, 2050, 1390, 2050, 1100, 2010, 1200, 2090, 1250, 2040, 1300, 2020}};

AnalysisOptions options_in_strip(const std::vector<std::string>& more = {})
{
    std::vector<std::string> overrides{fmt::format("analysis.region=\"{}\"", strip_region), "analysis.envelope=3"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return overridden_analysis(overrides, 2);
}

/// A set of random points, in the region's units.
PointSet random_set(const AnalysisOptions& options, std::uint32_t number)
{
    const FramedRegion& region = *options.region->region;
    PointSet points{2, {}};
    const PointSet framed = RandomInRegion(region, nullptr).points(50, 100 + number);
    for (std::size_t i = 0; i < framed.size(); ++i)
        for (const double c : region.own({framed[i][0], framed[i][1]})) points.coordinates.push_back(c);
    return points;
}

TEST(RegionAnalysis, MeasuresDistancesOfThePlaneInRootsOfTheArea)
{
    const AnalysisOptions options = options_in_strip();
    SeriesAnalysis analysis("s", false, options);
    analysis.add(six);
    analysis.measure_first();
    analysis.measure_spectrum(analysis.mean_spectrum());
    const Series series = analysis.result();
    const double least = std::hypot(50, 20); // of the last two
    EXPECT_NEAR(series.min_distance->mean, least / 200, 1e-9);
    EXPECT_NEAR(series.relative_radius->mean, relative_radius(least / 200, 6, 2), 1e-9);
    ASSERT_TRUE(series.region);
    EXPECT_NEAR(series.region->area, 40'000, 1e-6);
    EXPECT_NEAR(series.region->unit_length, 200, 1e-9);
    EXPECT_EQ(series.region->corners, 4);
    EXPECT_EQ(series.region->envelope, 3);
    EXPECT_EQ(series.region->covariance_error, 0);
    EXPECT_FALSE(series.is_window);
    EXPECT_FALSE(series.measures.voronoi || series.measures.largest_empty || !series.measures.integration.empty());
    EXPECT_EQ(series.measures.numbers.count("hyperuniformity_exponent"), 0);
    EXPECT_EQ(series.measures.numbers.count("effective_nyquist"), 1);
    EXPECT_TRUE(series.number_variance_file.empty());
}

TEST(RegionAnalysis, PartsAreTheWhole)
{
    const AnalysisOptions options = options_in_strip();
    SeriesAnalysis whole("s", false, options), first("s", false, options), next("s", false, options, {2, 50});
    for (std::uint32_t k = 0; k < 3; ++k) {
        whole.add(random_set(options, k));
        (k < 2 ? first : next).add(random_set(options, k));
    }
    SeriesAnalysis stored("s", false, options, {2, 50});
    from_bytes(to_bytes(next), stored);
    first.append(stored);
    EXPECT_EQ(region_curves_csv(first.region_curves()), region_curves_csv(whole.region_curves()));
    EXPECT_EQ(first.mean_spectrum().power.size(), whole.mean_spectrum().power.size());
    for (SeriesAnalysis* analysis : {&whole, &first}) analysis->measure_first();
    EXPECT_EQ(first.region_picture(), whole.region_picture());
    EXPECT_FALSE(whole.region_picture().empty());
}

TEST(RegionAnalysis, SpectraOfBothMethodsAreTheSame)
{
    const AnalysisOptions fast = options_in_strip(), exact = options_in_strip({"analysis.spectrum=exact"});
    SeriesAnalysis a("s", false, fast), b("s", false, exact);
    a.add(random_set(fast, 0));
    b.add(random_set(exact, 0));
    const Spectrum p = a.mean_spectrum(), q = b.mean_spectrum();
    ASSERT_EQ(p.power.size(), q.power.size());
    for (std::size_t i = 0; i < p.power.size(); ++i) EXPECT_NEAR(p.power[i], q.power[i], 1e-5) << i;
}

/// One set has errors of what is linear in its curve, and parts are the whole.
TEST(RegionAnalysis, ByTapersHasErrorsOfOneSet)
{
    const AnalysisOptions plain = options_in_strip(), tapered = options_in_strip({"analysis.tapers=4"});
    EXPECT_NE(plain.region->hash, tapered.region->hash);
    SeriesAnalysis without("s", false, plain), one("s", false, tapered), two("s", false, tapered);
    without.add(random_set(plain, 0));
    for (SeriesAnalysis* analysis : {&one, &two}) analysis->add(random_set(tapered, 0));
    EXPECT_EQ(without.radial_curve(without.mean_spectrum())[1].power_error, 0);
    const Spectrum mean = one.mean_spectrum();
    EXPECT_EQ(mean.realizations, 4);
    EXPECT_GT(one.radial_curve(mean)[1].power_error, 0);
    one.measure_spectrum(mean);
    EXPECT_FALSE(one.result().measures.numbers.at("effective_nyquist").standard_error);
    EXPECT_GT(one.result().measures.numbers.at("low_frequency_mean").standard_error, 0);
    EXPECT_FALSE(one.result().measures.peak_anisotropy && one.result().measures.peak_anisotropy->standard_error_db);
    EXPECT_EQ(one.result().region->tapers, 4);
    EXPECT_EQ(without.result().region->tapers, 0);
    SeriesAnalysis next("s", false, tapered, {1, 50}), stored("s", false, tapered, {1, 50});
    two.add(random_set(tapered, 1));
    next.add(random_set(tapered, 1));
    from_bytes(to_bytes(next), stored);
    one.append(stored);
    EXPECT_EQ(one.mean_spectrum().realizations, 8);
    const Spectrum appended = one.mean_spectrum(), whole = two.mean_spectrum();
    for (std::size_t i = 0; i < whole.power.size(); ++i)
        EXPECT_NEAR(appended.power[i], whole.power[i], 1e-9 * (1 + whole.power[i])) << i;
}

TEST(RegionAnalysis, OfOnePointHasNoCurves)
{
    const AnalysisOptions options = options_in_strip();
    SeriesAnalysis analysis("s", false, options);
    analysis.add({2, {1200, 2050}});
    analysis.measure_first();
    EXPECT_TRUE(analysis.region_curves().empty());
    EXPECT_TRUE(analysis.pair_correlation().empty());
    EXPECT_TRUE(analysis.result().region->file.empty());
}

TEST(RegionAnalysis, OfPointsOutsideIsRefused)
{
    SeriesAnalysis analysis("s", false, options_in_strip());
    EXPECT_EQ(
        message_of([&] {
            analysis.add({2, {1200, 2050, 1200, 1950}});
        }),
        "s: realization 0: 1 of 2 points lies outside the region rectangle 1000 2000 1400 2100: the first is point "
        "2, (1200, 1950)");
}

/// The first halves of a progressive set are sets of the plane.
TEST(RegionAnalysis, MeasuresFirstPartsWithoutATorus)
{
    AnalysisOptions options = options_in_strip();
    options.progressive = true;
    SeriesAnalysis analysis("s", false, options);
    analysis.add(six);
    analysis.measure_first();
    // The first three of six points: 1010 and 1100 are nearest, 400 x 100 is the area.
    const double distance = std::hypot(90, 40) / 200;
    EXPECT_NEAR(analysis.result().measures.numbers.at("prefix_relative_radius").value, relative_radius(distance, 3, 2),
                1e-9);
}

/// Errors are between tile sets, whose sets have a curve for each taper.
TEST(RegionAnalysis, OfSeveralTileSetsHasErrorsByTapersToo)
{
    AnalysisOptions options = options_in_strip({"analysis.tapers=3"});
    options.tile_sets = 2;
    SeriesAnalysis analysis("s", false, options);
    for (std::uint32_t k = 0; k < 4; ++k) analysis.add(random_set(options, k));
    const Spectrum mean = analysis.mean_spectrum();
    EXPECT_EQ(mean.realizations, 12);
    EXPECT_GT(analysis.radial_curve(mean)[1].power_error, 0);
    analysis.measure_spectrum(mean);
    EXPECT_TRUE(analysis.result().measures.numbers.at("effective_nyquist").standard_error);
}

}
}
