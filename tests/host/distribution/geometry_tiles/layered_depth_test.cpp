// Layered depth images of tiles are held against rays, and levels against sets of what they cover.
#include "tests/host/distribution/geometry_tiles/plant_rays.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

namespace poissonlab {
namespace {

TEST(GeometryTiles, SeenFromTheirDirectionAreTheirTriangles)
{
    const PlantTileSet& set = some_plants();
    const std::vector<LitPlant> plants = lit_plants(set.plants[5], set.models, set.radius);
    const std::vector<LitTriangle> triangles = triangles_of(plants);
    std::size_t hits = 0, misses = 0;
    for (const double azimuth : {0.0, 2.1, -0.7}) {
        const DepthView view = depth_view(azimuth, 0.3, set.height);
        const LayeredDepthImage image = layered_depth_image(plants, view, {}, 24);
        ASSERT_EQ(image.samples, depth_picture(plants, view, 24).samples);
        for (int row = 0; row < image.rows; ++row)
            for (int column = 0; column < image.columns; ++column) {
                MeshPoint from = view.place({(column + 0.5) / 24, (row + 0.5) / 24, -10});
                from = {from[0] + 0.5, from[1] + 0.5, from[2]};
                const MeshPoint along{-view.back[0], -view.back[1], -view.back[2]};
                const RayHit hit = cast(triangles, from, along, [](const MeshPoint& p) {
                    return p[0] >= 0 && p[0] < 1 && p[1] >= 0 && p[1] < 1;
                });
                if (hit.margin < 1e-9) continue; // rounding decides
                const auto samples = image.at(column, row);
                ASSERT_EQ(samples.size(), std::isfinite(hit.distance) ? 1U : 0U) << row << ", " << column;
                ++(samples.empty() ? misses : hits);
                if (samples.empty()) continue;
                EXPECT_NEAR(static_cast<double>(samples[0].depth), hit.distance - 10, 1e-6); // of floats below 2
                for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(samples[0].color[k], 255 * hit.color[k], 0.5 + 1e-6);
            }
    }
    EXPECT_GT(hits, 200U);
    EXPECT_GT(misses, 200U);
}

TEST(GeometryTiles, SamplesOfOtherViewsLieOnTriangles)
{
    const PlantTileSet& set = some_plants();
    const std::vector<LitPlant> plants = lit_plants(set.plants[7], set.models, set.radius);
    const DepthView view = depth_view(1, 0.3, set.height), other = depth_view(1.4, 0.7, set.height);
    const LayeredDepthImage alone = layered_depth_image(plants, view, {}, 64);
    const LayeredDepthImage both = layered_depth_image(plants, view, {other}, 64);
    EXPECT_GT(both.samples.size(), alone.samples.size());
    EXPECT_LE(both.samples.size(), alone.samples.size() + depth_picture(plants, other, 64).samples.size());
    for (int row = 0; row < both.rows; ++row)
        for (int column = 0; column < both.columns; ++column) {
            const auto samples = both.at(column, row);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                EXPECT_LE(samples[i].depth, samples[i > 0 ? i - 1 : 0].depth) << "from the farthest on";
                const MeshPoint place = both.place(column, row, samples[i]);
                const LitPlant& plant = plants[samples[i].plant];
                // From one of both views, a ray through the place meets the plant there: places are in parts of pixels.
                double nearest = INFINITY;
                for (const DepthView& from : {view, other}) {
                    const MeshPoint eye{place[0] + 0.5 + 10 * from.back[0], place[1] + 0.5 + 10 * from.back[1],
                                        place[2] + 10 * from.back[2]};
                    for (const LitTriangle& t : triangles_of({plant}))
                        if (const auto hit = met(eye, {-from.back[0], -from.back[1], -from.back[2]}, t);
                            hit && std::min({(*hit)[1], (*hit)[2], (*hit)[3]}) > -0.05)
                            nearest = std::min(nearest, std::abs((*hit)[0] - 10));
                }
                EXPECT_LT(nearest, both.pixel / 4) << column << ", " << row;
                EXPECT_LT(std::abs(place[0]), 0.5 + 1e-4) << "above the tile";
                EXPECT_LT(std::abs(place[1]), 0.5 + 1e-4);
            }
        }
}

TEST(GeometryTiles, LevelsKeepWhatIsCovered)
{
    const PlantTileSet& set = some_plants();
    const std::vector<LitPlant> plants = lit_plants(set.plants[11], set.models, set.radius);
    const LayeredDepthImage finest =
        layered_depth_image(plants, depth_view(0.4, 0.3, set.height), {depth_view(0.8, 0.1, set.height)}, 128);
    std::size_t last = finest.samples.size();
    for (int level = 1; level < 7; ++level) {
        const LayeredDepthImage image = coarser(finest, level);
        EXPECT_LT(image.samples.size(), last) << "fewer samples";
        last = image.samples.size();
        std::set<std::array<int, 5>> covered; // pixel, plant, step of depth, pixel of level 0
        std::map<std::array<int, 4>, std::vector<int>> reds;
        for (int row = 0; row < finest.rows; ++row)
            for (int column = 0; column < finest.columns; ++column)
                for (const DepthSample& s : finest.at(column, row)) {
                    const int step =
                        static_cast<int>(std::floor(static_cast<double>(s.depth) * 128 / (1 << level) / 2));
                    covered.insert({column >> level, row >> level, s.plant, step, row * finest.columns + column});
                    reds[{column >> level, row >> level, s.plant, step}].push_back(s.color[0]);
                }
        double alpha = 0, red = 0, expected_red = 0;
        for (int row = 0; row < image.rows; ++row)
            for (int column = 0; column < image.columns; ++column)
                for (const DepthSample& s : image.at(column, row)) {
                    EXPECT_LE(image.alpha(s), 1);
                    alpha += image.alpha(s);
                    red += s.color[0];
                }
        for (const auto& [key, values] : reds)
            expected_red += std::floor(
                std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()) + 0.5);
        EXPECT_EQ(image.samples.size(), reds.size());
        EXPECT_EQ(alpha * (1 << 2 * level), static_cast<double>(covered.size()));
        EXPECT_EQ(red, expected_red);
    }
}

}
}
