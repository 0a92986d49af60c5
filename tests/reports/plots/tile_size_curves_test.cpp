// Which tile sets make a curve of points in regions, or of radii within tiles.
#include "reports/plots/tile_size_curves.hpp"

#include <gmock/gmock.h>

#include <list>

namespace poissonlab {
namespace {

using testing::ElementsAre;

class RegionCurves : public testing::Test
{
protected:
    void add(const std::string& sampler, const std::string& radius, std::int64_t points_per_tile, double corners)
    {
        Series series;
        series.sampler = sampler;
        series.parameters = {
            {"colors", "3"}, {"points_per_tile", std::to_string(points_per_tile)}, {"relative_radius", radius}};
        series.tile_set.emplace();
        series.tile_set->points_per_tile = points_per_tile;
        series.tile_set->regions = {{"corners", corners, 3}, {"edges", 2 * corners, 6}, {"interior", 10, 10}};
        stored_.push_back(series);
    }

    std::vector<TileSizeCurve> curves()
    {
        std::vector<const Series*> series;
        for (const Series& stored : stored_) series.push_back(&stored);
        return region_curves(series);
    }

    std::vector<std::string> labels()
    {
        std::vector<std::string> labels;
        for (const TileSizeCurve& curve : curves()) labels.push_back(curve.label);
        return labels;
    }

    std::list<Series> stored_;
};

TEST_F(RegionCurves, JoinTileSetsThatDifferOnlyInTheirPoints)
{
    add("corner-tiles", "0.7", 64, 3.1);
    add("corner-tiles", "0.8", 16, 4);
    add("corner-tiles", "0.7", 16, 2.9);
    add("corner-tiles", "0.8", 64, 4.1);
    EXPECT_THAT(labels(), ElementsAre("corners, relative_radius = 0.7", "edges, relative_radius = 0.7",
                                      "corners, relative_radius = 0.8", "edges, relative_radius = 0.8"));
    const TileSizeCurve corners = curves().front();
    ASSERT_EQ(corners.samples.size(), 2);
    EXPECT_EQ(corners.samples[0].points_per_tile, 16);
    EXPECT_EQ(corners.samples[0].dot, 2.9);
    EXPECT_EQ(corners.samples[0].line, 3);
    EXPECT_EQ(corners.samples[1].points_per_tile, 64);
}

/// Radii within tiles are dots, those of tilings lines; where both are the same everywhere there is nothing to show.
TEST_F(RegionCurves, ShowRadiiWithinTilesWhereTilingsHaveSmallerOnes)
{
    for (const std::int64_t points : {40, 20}) {
        add("averaged-tiles", "0.7", points, 0);
        Series& series = stored_.back();
        series.relative_radius = Statistic{0.3, 0.4, 0.5, {}};
        series.measures.numbers["relative_radius_within_tiles"] = {points == 20 ? 0.9 : 0.8, {}};
    }
    std::vector<const Series*> series;
    for (const Series& stored : stored_) series.push_back(&stored);
    const auto radii = tile_radius_curves(series);
    ASSERT_EQ(radii.size(), 1U);
    EXPECT_EQ(radii[0].label, "averaged-tiles");
    ASSERT_EQ(radii[0].samples.size(), 2U);
    EXPECT_EQ(radii[0].samples[0].points_per_tile, 20);
    EXPECT_EQ(radii[0].samples[0].dot, 0.9);
    EXPECT_EQ(radii[0].samples[0].line, 0.4);
    const Plot plot = tile_radius_plot(radii);
    EXPECT_EQ(plot.curves.front().dots, (std::vector<double>{0.9, 0.8}));
    EXPECT_DOUBLE_EQ(plot.y.high, 0.9);
    for (Series& stored : stored_) stored.measures.numbers["relative_radius_within_tiles"].value = 0.4;
    EXPECT_TRUE(tile_radius_curves(series).empty());
}

TEST_F(RegionCurves, NeedTwoNumbersOfPoints)
{
    add("corner-tiles", "0.7", 64, 3.1);
    add("corner-tiles", "0.8", 16, 3.1);
    EXPECT_TRUE(curves().empty());
}

TEST_F(RegionCurves, NeedNoWordsForWhatAllHaveInCommon)
{
    add("edge-tiles", "0.7", 16, 3.1);
    add("edge-tiles", "0.7", 64, 3.1);
    EXPECT_THAT(labels(), ElementsAre("corners", "edges"));
    stored_.front().tile_set.reset();
    EXPECT_TRUE(curves().empty());
}

}
}
