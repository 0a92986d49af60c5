// Realizations that are the same set count once: means, errors and numbers of sets are those without the repetitions.
#include "experiment/measuring/series_analysis.hpp"

#include "tests/support/point_patterns.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace poissonlab {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<PointSet> random_sets(std::size_t count)
{
    std::mt19937_64 random(31);
    std::vector<PointSet> sets;
    for (std::size_t i = 0; i < count; ++i) sets.push_back(test::random_points(200, 2, random));
    return sets;
}

PointSet moved(PointSet set)
{
    for (double& c : set.coordinates) c = std::fmod(c + 0.37, 1.0);
    return set;
}

AnalysisOptions small_options()
{
    AnalysisOptions options;
    options.spectrum = PeriodogramMethod::fast;
    options.spectrum_size = 128;
    return options;
}

/// The results of an analysis, with everything that it measures.
struct Measured
{
    Series series;
    std::vector<RadialBin> radial;
    std::vector<PairCorrelationBin> pairs;
};

Measured measured(SeriesAnalysis analysis)
{
    const Spectrum mean = analysis.mean_spectrum();
    analysis.measure_spectrum(mean);
    analysis.measure_first();
    Measured result{analysis.result(), analysis.radial_curve(mean), analysis.pair_correlation()};
    result.series.analysis_seconds = 0;
    return result;
}

Measured measured(const std::vector<PointSet>& sets)
{
    SeriesAnalysis analysis("s", false, small_options());
    for (const PointSet& set : sets) analysis.add(set);
    return measured(std::move(analysis));
}

void expect_equal(const Measured& a, const Measured& b)
{
    EXPECT_EQ(a.series.measures, b.series.measures);
    EXPECT_EQ(a.series.relative_radius, b.series.relative_radius);
    EXPECT_EQ(a.series.realizations, b.series.realizations);
    ASSERT_EQ(a.radial.size(), b.radial.size());
    for (std::size_t i = 0; i < a.radial.size(); ++i) {
        EXPECT_EQ(a.radial[i].power, b.radial[i].power);
        EXPECT_EQ(a.radial[i].power_error, b.radial[i].power_error);
        EXPECT_EQ(a.radial[i].anisotropy_db, b.radial[i].anisotropy_db);
    }
    ASSERT_EQ(a.pairs.size(), b.pairs.size());
    for (std::size_t i = 0; i < a.pairs.size(); ++i) EXPECT_EQ(a.pairs[i].standard_error, b.pairs[i].standard_error);
}

TEST(RepeatedSets, CountOnce)
{
    const auto sets = random_sets(3);
    const Measured all = measured({sets[0], sets[1], sets[0], moved(sets[1]), sets[2], sets[2]});
    EXPECT_EQ(all.series.realizations, 3);
    EXPECT_THAT(all.series.repeated, ElementsAre(2, 3, 5));
    EXPECT_TRUE(all.series.is_repeated(3));
    EXPECT_FALSE(all.series.is_repeated(4));
    expect_equal(all, measured(sets));
    EXPECT_THAT(measured(sets).series.repeated, IsEmpty());
}

/// The error of one set is not known, however often it comes; but for a fit to single frequencies, which has its own.
TEST(RepeatedSets, HaveNoErrorWhereThereIsOne)
{
    const auto sets = random_sets(1);
    const Measured all = measured({sets[0], moved(sets[0]), sets[0]});
    EXPECT_EQ(all.series.realizations, 1);
    for (const auto& [key, number] : all.series.measures.numbers)
        EXPECT_EQ(number.standard_error.has_value(), key == "hyperuniformity_exponent") << key;
    EXPECT_FALSE(all.series.measures.oscillation->standard_error);
    for (const IntegrationError& error : all.series.measures.integration) EXPECT_EQ(error.standard_error, 0);
    for (const RadialBin& bin : all.radial) EXPECT_EQ(bin.power_error, 0);
    expect_equal(all, measured(sets));
}

/// Two of three tile sets remain, or one, which has no error between sets.
TEST(RepeatedSets, AreTakenOutOfTheirTileSets)
{
    const auto sets = random_sets(4);
    AnalysisOptions options = small_options();
    options.tile_sets = 3;
    SeriesAnalysis analysis("s", false, options);
    for (const std::size_t i : {0, 0, 1, 2, 0, 3}) analysis.add(sets[i]); // of tile sets 0, 2, 0 and 2
    const Series result = measured(std::move(analysis)).series;
    EXPECT_EQ(result.realizations, 4);
    const std::vector<double>& each = result.relative_radius->each;
    ASSERT_EQ(each.size(), 4U);
    ASSERT_TRUE(result.measures.numbers.at("mean_nearest_distance").standard_error);

    SeriesAnalysis of_one("s", false, options);
    for (const std::size_t i : {0, 0, 0, 1}) of_one.add(sets[i]); // both of tile set 0
    const Series one = measured(std::move(of_one)).series;
    EXPECT_EQ(one.realizations, 2);
    EXPECT_FALSE(one.measures.numbers.at("mean_nearest_distance").standard_error);
    EXPECT_FALSE(one.measures.numbers.at("effective_nyquist").standard_error);
}

/// One tile that is repeated has no power beside its lattice's: a ratio of its own of 10^18. Among others, which are
/// random, it counts by its powers; of such tiles alone, ratios have no meaning, and no error.
TEST(RepeatedTiles, HaveNoErrorOfLatticePeaksButAmongOthers)
{
    const auto tiles = random_sets(3);
    AnalysisOptions options = small_options();
    options.tiles = 2;
    options.spectrum_size = 256; // as much as 800 points need
    for (const std::size_t repeated : {1, 3}) {
        SeriesAnalysis analysis("s", false, options);
        for (std::size_t set = 0; set < tiles.size(); ++set) {
            PointSet tiled{2, {}};
            for (int place = 0; place < 4; ++place)
                for (std::size_t i = 0; i < tiles[set].coordinates.size(); i += 2) {
                    const double x = tiles[set].coordinates[i], y = tiles[set].coordinates[i + 1];
                    const double turned = set < repeated ? x : std::fmod(x + 0.13 * place, 1.0);
                    tiled.coordinates.insert(tiled.coordinates.end(), {(place % 2 + turned) / 2, (place / 2 + y) / 2});
                }
            EXPECT_TRUE(analysis.add(tiled));
        }
        const Series result = measured(std::move(analysis)).series;
        ASSERT_TRUE(result.measures.lattice_peaks);
        const LatticePeaks& peaks = *result.measures.lattice_peaks;
        if (repeated == 3) {
            EXPECT_GT(peaks.mean_ratio, 1e9);
            EXPECT_FALSE(peaks.mean_ratio_standard_error);
            continue;
        }
        EXPECT_LT(peaks.mean_ratio, 1000);
        ASSERT_TRUE(peaks.mean_ratio_standard_error);
        EXPECT_LT(*peaks.mean_ratio_standard_error, peaks.mean_ratio);
        EXPECT_TRUE(result.measures.numbers.at("effective_nyquist").standard_error);
    }
}

/// A part that repeats sets of earlier ones is analysed without them.
TEST(RepeatedSets, AreFoundAcrossParts)
{
    const auto sets = random_sets(4);
    SeriesAnalysis first("s", false, small_options());
    for (const std::size_t i : {0, 1, 0}) first.add(sets[i]);
    const SeriesAnalysis::Begin begin{3, 200};
    SeriesAnalysis second("s", false, small_options(), begin);
    for (const std::size_t i : {2, 1, 3}) EXPECT_TRUE(second.add(sets[i]));
    EXPECT_TRUE(second.repeats(first));
    EXPECT_THROW(first.append(second), std::invalid_argument);

    SeriesAnalysis again("s", false, small_options(), begin);
    again.leave_out(first);
    EXPECT_TRUE(again.add(sets[2]));
    EXPECT_FALSE(again.add(sets[1]));
    EXPECT_TRUE(again.add(sets[3]));
    EXPECT_FALSE(again.repeats(first));
    first.append(again);
    EXPECT_THAT(first.result().repeated, ElementsAre(2, 4));

    SeriesAnalysis nothing_new("s", false, small_options(), {6, 200});
    nothing_new.leave_out(first);
    EXPECT_FALSE(nothing_new.add(sets[3]));
    first.append(nothing_new);
    EXPECT_THAT(first.result().repeated, ElementsAre(2, 4, 6));
    EXPECT_EQ(first.result().realizations, 4);
}

}
}
