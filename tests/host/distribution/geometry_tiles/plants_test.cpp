// Plants of tiles are held against windows of tilings.
#include "tests/host/distribution/geometry_tiles/plant_rays.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;

/// The plants of a window of a tiling that reach into one of its tiles are those of the tile alone.
void expect_tiles_to_decide(const PoissonTileSet& tiles, std::uint32_t seed)
{
    const double radius = plant_radius(tiles);
    const ptiles_tiling tiling = runtime_tiling(tiles, {seed, 0});
    std::map<std::pair<std::int64_t, std::int64_t>, Plant> known; // by their place, in units
    for (std::int32_t x = -3; x < 3; ++x)
        for (std::int32_t y = -3; y < 3; ++y) {
            const double low[3] = {x - 0.5, y - 0.5, 0}, high[3] = {x + 1.5, y + 1.5, 0};
            std::vector<ptiles_point> points(ptiles_in_window(&tiling, low, high, nullptr, 0, 1));
            ptiles_in_window(&tiling, low, high, points.data(), points.size(), 1);
            std::set<std::pair<double, double>> expected, found;
            for (const ptiles_point& p : points) {
                const double dx = p.position[0] - std::clamp<double>(p.position[0], x, x + 1);
                const double dy = p.position[1] - std::clamp<double>(p.position[1], y, y + 1);
                if (dx * dx + dy * dy < radius * radius) expected.insert({p.position[0] - x, p.position[1] - y});
            }
            for (Plant plant : plants_of_tile(tiles, ptiles_tile(&tiling, x, y, 0), radius, some_looks)) {
                found.insert({plant.x, plant.y});
                const std::pair place{std::llround((plant.x + x) * 65536), std::llround((plant.y + y) * 65536)};
                plant.x = plant.y = 0;
                const auto [other, is_new] = known.insert({place, plant});
                EXPECT_EQ(other->second, plant) << "a plant looks different in two tiles";
            }
            EXPECT_EQ(found, expected) << x << ", " << y;
        }
}

TEST(GeometryTiles, DecideWhichPlantsReachIntoThem)
{
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        expect_tiles_to_decide(some_plants().tiles, seed);
        expect_tiles_to_decide(built_tiles(PoissonTileKind::corner, 16, 20), seed);
        expect_tiles_to_decide(built_tiles(PoissonTileKind::frame, 3, 20), seed);
        expect_tiles_to_decide(built_tiles(PoissonTileKind::frame, 1, 24), seed);
    }
}

TEST(GeometryTiles, RefuseTilesThatDoNotDecide)
{
    PoissonTileSet tiles = some_plants().tiles;
    check_plant_tiles(tiles);
    tiles.parameters.border = TileBorder::chain;
    EXPECT_THAT(message_of([&] { check_plant_tiles(tiles); }), HasSubstr("must be corner tiles or template tiles"));
    tiles.parameters.border = TileBorder::strip;
    check_plant_tiles(tiles);
    tiles.squared_min_distance = 0;
    EXPECT_THAT(message_of([&] { plant_radius(tiles); }), HasSubstr("must be tiles with a minimum distance"));
    tiles.parameters.kind = PoissonTileKind::edge;
    EXPECT_THAT(message_of([&] { check_plant_tiles(tiles); }), HasSubstr("must be corner tiles or template tiles"));
}

TEST(GeometryTiles, SunflowersStandInTheirDisks)
{
    const std::vector<PlantModel> models = sunflower_models(11);
    ASSERT_EQ(models.size(), 11U);
    EXPECT_EQ(models[2].places, sunflower_models(3)[2].places);
    for (const PlantModel& model : models) {
        double radius = 0, low = 1, high = 0;
        for (const MeshPoint& p : model.places) {
            radius = std::max(radius, std::hypot(p[0], p[1]));
            low = std::min(low, p[2]);
            high = std::max(high, p[2]);
        }
        EXPECT_NEAR(radius, 1, 1e-12);
        EXPECT_EQ(low, 0);
        EXPECT_EQ(high, model.height);
        for (const MeshTriangle& t : model.triangles)
            for (const std::uint32_t corner : t) EXPECT_LT(corner, model.places.size());
    }
    EXPECT_TRUE(sunflower_models(0).empty());
}

TEST(GeometryTiles, MeshesAreMovedAndScaledToFit)
{
    TriangleMesh mesh;
    mesh.vertices = {{10, 20, 5}, {14, 20, 5}, {10, 20, 9}};
    mesh.triangles = {{0, 1, 2}};
    const PlantModel model = plant_of_mesh(mesh);
    EXPECT_EQ(model.places, (std::vector<MeshPoint>{{-1, 0, 0}, {1, 0, 0}, {-1, 0, 2}}));
    EXPECT_EQ(model.height, 2);
    EXPECT_EQ(model.normals[0], (MeshPoint{0, -1, 0}));
    mesh.vertices = {{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}; // without height
    std::vector<LitVertex> lit;
    light_plant(plant_of_mesh(mesh), {}, 0.1, lit);
    ASSERT_EQ(lit.size(), 3U);
    for (const LitVertex& v : lit) EXPECT_TRUE(v.color[0] > 0 && v.color[0] <= 1) << v.color[0];
    mesh.vertices = {{1, 1, 5}, {1, 1, 6}, {1, 1, 7}};
    EXPECT_THAT(message_of([&] { plant_of_mesh(mesh); }), HasSubstr("no extent along x and y"));
}

}
}
