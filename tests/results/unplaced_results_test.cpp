// Results that have no name yet and whose files are elsewhere, as the store has them: JSON that keeps every bit.
#include "base/errors/errors.hpp"
#include "base/files/json_members.hpp"
#include "results/pictures/construction_result.hpp"
#include "results/pictures/distribution_result.hpp"
#include "results/pictures/tiling_result.hpp"
#include "results/series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace poissonlab {
namespace {

template <class Result>
std::string text_of(const Result& result)
{
    return json_text([&](JsonMembers& m) { members(m, result); });
}

template <class Result>
Result read_back(const std::string& text)
{
    Result result;
    read_unplaced(text, "stored result", [&](JsonMembers& m) { members(m, result); });
    return result;
}

/// The part of a series that its analysis knows.
Series analysed()
{
    Series series;
    series.set_sizes({1, 2});
    series.repeated = {2};
    series.min_distance = statistic_of({0.1, 0x1.23456789abcdep-7});
    series.relative_radius = Statistic{5e-324, 0x1.fffffffffffffp+1023, 0.30000000000000004, {}};
    series.measures.numbers["effective_nyquist"] = {0x1.23456789abcdep-1, 1e-300};
    series.measures.oscillation = Oscillation{1.5, -0.0, 3};
    series.measures.integration = {{"disk", 1, 2, 3, 4}};
    series.spectrum_file = "spectrum.exr";
    series.spectrum_size = 1024;
    series.pair_correlation_file = "pairs.csv";
    series.number_variance_file = "variance.csv";
    series.folded_density = FoldedDensityFile{64, "folded.exr"};
    series.zone_plate = ZonePlateResult{3, "file", "errors", *statistic_of({0.1}), {}};
    series.is_window = true;
    series.analysis_seconds = 0x1.5555555555555p-3;
    return series;
}

TEST(UnplacedResults, SeriesKeepEveryBit)
{
    const Series series = analysed(), back = read_back<Series>(text_of(series));
    EXPECT_EQ(back, series);
    EXPECT_TRUE(std::signbit(back.measures.oscillation->begin));
    EXPECT_EQ(text_of(back), text_of(series));
}

TEST(UnplacedResults, TextsThatAreCutAreRefused)
{
    const std::string text = text_of(analysed());
    EXPECT_THROW(read_back<Series>(text.substr(0, text.size() - 1)), InputError);
    EXPECT_THROW(read_back<Series>("{}"), InputError);
    EXPECT_THROW(read_back<Series>(""), InputError);
}

TEST(UnplacedResults, DistributionsKeepTheirOrderAndBits)
{
    DistributionResult made;
    made.facts = {"b", "a"};
    made.parameters = {{"z", "1"}, {"a", "2"}};
    made.numbers = {{"n", "N", 0.1 + 0.2, "of all", 1e-300, true, true}, {"m", "M", -0.0, "", {}, false, false}};
    made.pictures = {{"picture.png", "marks \"as they are\""}};
    made.files = {"points.txt"};
    made.tables = {{"title", {"x", "y"}, {{"1", "2"}, {"3", "4"}}}};
    const DistributionResult back = read_back<DistributionResult>(text_of(made));
    EXPECT_EQ(back, made);
    EXPECT_TRUE(std::signbit(back.numbers[1].value));
}

TEST(UnplacedResults, TilingsAndConstructionsAreAsTheyWere)
{
    TilingResult tiling;
    tiling.kind = TileKind::wang;
    tiling.colors = 3;
    tiling.vertical_colors = 2;
    tiling.tiles = 36;
    tiling.file = "tiles.txt";
    tiling.algorithm = "edge-hash";
    tiling.origin = {-3, 1LL << 40, 0};
    tiling.size = {7, 5, 1};
    tiling.hash = "long-period";
    tiling.hash_period = {0, 64};
    tiling.period = {7, 0};
    ColorStatistics colors{"corners", {3, 4}, {0.1, 1e-12}, "corners-autocorrelation.exr", {}};
    colors.autocorrelation.lags = 12;
    colors.autocorrelation.largest = -0x1.23456789abcdep-9;
    tiling.statistics = TilingStatistics{8, 16, FrequencyTest{1.5, 0.25}, {colors}};
    EXPECT_EQ(read_back<TilingResult>(text_of(tiling)), tiling);

    ConstructionResult construction;
    construction.kind = "corner";
    construction.show = "corner";
    construction.colors = 2;
    construction.tiles = 16;
    construction.points_per_tile = 16;
    construction.relative_radius = 0.7000000000000001;
    construction.seed = "18446744073709551615";
    construction.file = "construction.json";
    construction.scene.panels = 3;
    construction.scene.points[1] = 17;
    EXPECT_EQ(read_back<ConstructionResult>(text_of(construction)), construction);
}

}
}
