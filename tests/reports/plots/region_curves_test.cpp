// Which tile sets make a curve of points in regions.
#include "reports/plots/region_curves.hpp"

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

    std::vector<RegionCurve> curves()
    {
        std::vector<const Series*> series;
        for (const Series& stored : stored_) series.push_back(&stored);
        return region_curves(series);
    }

    std::vector<std::string> labels()
    {
        std::vector<std::string> labels;
        for (const RegionCurve& curve : curves()) labels.push_back(curve.label);
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
    const RegionCurve corners = curves().front();
    ASSERT_EQ(corners.samples.size(), 2);
    EXPECT_EQ(corners.samples[0].points_per_tile, 16);
    EXPECT_EQ(corners.samples[0].points, 2.9);
    EXPECT_EQ(corners.samples[0].expected, 3);
    EXPECT_EQ(corners.samples[1].points_per_tile, 64);
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
