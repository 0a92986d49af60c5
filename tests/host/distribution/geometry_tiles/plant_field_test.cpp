// Fields of plants are held against rays, and fields by layered depth images against whole ones.
#include "host/distribution/geometry_tiles/plant_canvas.hpp"
#include "tests/host/distribution/geometry_tiles/plant_rays.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <numbers>
#include <set>

namespace poissonlab {
namespace {

FieldSettings small_field()
{
    FieldSettings settings;
    settings.field = {5, 6};
    settings.eye = {2.4, -0.6, 0.7};
    settings.heading = 84;
    settings.pixels = 128;
    settings.resolution = 128;
    settings.haze = 1e6;
    return settings;
}

Terrain a_slope(const FieldSettings& field)
{
    InstanceSettings settings;
    settings.terrain = "0.3 * x + 0.2 * y * y";
    settings.terrain_area = {0, 0, static_cast<double>(field.field[0]), static_cast<double>(field.field[1])};
    return Terrain(settings);
}

double mean_difference(const PngPixels& a, const PngPixels& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) sum += std::abs(a.values[i] - b.values[i]);
    return sum / static_cast<double>(a.values.size());
}

/// Rays from the camera through the samples of some pixels meet the triangles of all plants that stand in the field.
TEST(GeometryTiles, WholeFieldsAreWhatRaysMeet)
{
    const PlantTileSet& set = some_plants();
    const FieldSettings settings = small_field();
    const Terrain terrain = a_slope(settings);
    const PngPixels picture = PlantField(set, {3, 0}, settings, terrain).whole();
    const ptiles_tiling tiling = runtime_tiling(set.tiles, {3, 0});
    std::vector<LitTriangle> triangles;
    for (std::int32_t x = 0; x < 5; ++x)
        for (std::int32_t y = 0; y < 6; ++y)
            for (const Plant& plant : set.plants[ptiles_tile(&tiling, x, y, 0)]) {
                if (!plant.is_in_tile()) continue;
                for (LitTriangle t : triangles_of(lit_plants({plant}, set.models, set.radius))) {
                    t.lift = {static_cast<double>(x), static_cast<double>(y), terrain.at(x + plant.x, y + plant.y)};
                    triangles.push_back(t);
                }
            }
    const double heading = 84 * std::numbers::pi / 180, pitch = 10 * std::numbers::pi / 180;
    const MeshPoint eye{2.4, -0.6, 0.7 + terrain.at(2.4, -0.6)};
    const MeshPoint ahead{std::cos(heading) * std::cos(pitch), std::sin(heading) * std::cos(pitch), -std::sin(pitch)};
    const MeshPoint right{std::sin(heading), -std::cos(heading), 0}, up = cross(right, ahead);
    int compared = 0;
    for (int number = 0; number < 110; ++number) {
        const int column = number * 37 % 128, row = 20 + number * 11 % 50;
        std::array<double, 3> sum{};
        bool is_sure = true;
        for (int i = 0; i < 4; ++i) {
            const double side = std::tan(27.5 * std::numbers::pi / 180) / 64; // of a pixel at distance 1
            const double dx = (column + 0.25 + 0.5 * (i % 2) - 64) * side,
                         dy = (row + 0.25 + 0.5 * (i / 2) - 36) * side;
            MeshPoint along{};
            for (std::size_t k = 0; k < 3; ++k) along[k] = ahead[k] + dx * right[k] - dy * up[k];
            const RayHit hit = cast(triangles, eye, along, [](const MeshPoint&) { return true; });
            // The ground may hide what is met behind it, and rounding decides at borders.
            const MeshPoint at{eye[0] + hit.distance * along[0], eye[1] + hit.distance * along[1],
                               eye[2] + hit.distance * along[2]};
            is_sure =
                is_sure && std::isfinite(hit.distance) && hit.margin > 1e-9 && at[2] > terrain.at(at[0], at[1]) + 0.03;
            for (std::size_t k = 0; k < 3; ++k) sum[k] += hit.color[k] / 4;
        }
        if (!is_sure) continue;
        ++compared;
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(picture.values[picture.at(column, row, k)], 255 * sum[static_cast<std::size_t>(k)], 0.5 + 0.01)
                << column << ", " << row;
    }
    EXPECT_GT(compared, 25);
}

TEST(GeometryTiles, FieldsOfImagesAreLikeWholeFields)
{
    const PlantTileSet& set = some_plants();
    for (const std::uint32_t seed : {1U, 2U}) {
        FieldSettings settings = small_field();
        settings.pixels = 256;
        const PlantField field(set, {seed, 0}, settings, a_slope(settings));
        LayeredTiles images(set, settings);
        images.make(field.needed());
        const PngPixels whole = field.whole();
        const double difference = mean_difference(field.layered(images), whole);
        EXPECT_GT(mean_difference(PlantField(set, {seed + 7, 0}, settings, a_slope(settings)).whole(), whole),
                  2 * difference);
        std::uint64_t samples = 0, tiles = 0;
        for (const FieldCost& cost : field.costs(images)) {
            samples += cost.samples;
            tiles += cost.tiles;
        }
        EXPECT_EQ(tiles, field.seen().size());
        std::uint64_t expected = 0;
        for (const FieldTile& t : field.seen()) expected += images.at({t.tile, t.direction, t.level}).samples.size();
        EXPECT_EQ(samples, expected);
    }
}

/// The camera stands among the plants and looks down at them, on surfaces that tiles are sampled across. Petals are not
/// much wider than samples, which are squares.
TEST(GeometryTiles, FieldsLeaveFewGapsNearTheCamera)
{
    const PlantTileSet& set = some_plants();
    for (const double pitch : {40.0, 80.0}) {
        FieldSettings settings = small_field();
        settings.eye = {2.4, 2.2, 1};
        settings.pitch = pitch;
        const PlantField field(set, {1, 0}, settings, std::nullopt);
        LayeredTiles images(set, settings);
        images.make(field.needed());
        const PngPixels drawn = field.layered(images, FieldColors::cover), whole = field.whole(0, FieldColors::cover);
        double covered = 0, gaps = 0, spill = 0;
        for (std::size_t i = 0; i < whole.values.size(); ++i) {
            const int more = whole.values[i] - drawn.values[i];
            covered += whole.values[i];
            (more > 0 ? gaps : spill) += std::abs(more);
        }
        RecordProperty("gaps", std::to_string(gaps / covered));
        EXPECT_GT(covered, 0.2 * 255 * static_cast<double>(whole.values.size()));
        EXPECT_LT(gaps, 0.03 * covered) << pitch;
        EXPECT_LT(spill, 0.25 * covered) << pitch;
    }
}

/// In the colours of levels, a pixel is a mean of four colours: those of the near tile, the far one, the ground and the
/// haze. Its red, green and blue tell the four weights. What is drawn last has the weight that it has without the far
/// tile; drawn first, it would lose what the far tile covers.
TEST(GeometryTiles, NearOnesLieOverFarOnes)
{
    std::vector<PlantModel> models = sunflower_models(3);
    for (PlantModel& model : models)
        for (ScreenColor& color : model.colors) color = {9, 9, 9}; // white in any light
    const PlantTileSet set(some_plants().tiles, some_plants().radius, some_looks, models);
    FieldSettings settings = small_field();
    settings.eye = {0.5, -1.1, 1};
    settings.heading = 90;
    settings.pitch = 30; // the sky is not seen
    settings.sample_size = 4;
    std::array<PngPixels, 2> pictures; // without the far tile, and with it
    PngPixels whole;
    for (const std::uint32_t length : {1U, 2U}) {
        settings.field = {1, length};
        const PlantField field(set, {1, 0}, settings, std::nullopt);
        ASSERT_EQ(field.seen().size(), length);
        for (const FieldTile& tile : field.seen()) ASSERT_EQ(tile.level, 2 + tile.y);
        LayeredTiles images(set, settings);
        images.make(field.needed());
        pictures[length - 1] = field.layered(images, FieldColors::levels);
        whole = field.whole();
    }
    const auto color_of = [](const PngPixels& picture, int column, int row) {
        MeshPoint color{};
        for (int k = 0; k < 3; ++k) color[static_cast<std::size_t>(k)] = picture.values[picture.at(column, row, k)];
        return color;
    };
    MeshPoint ground{255, 255, 255}, near{}, far{};
    for (int i = 0; i < 128 * 72; ++i)
        if (const MeshPoint color = color_of(whole, i % 128, i / 128); color[2] < ground[2]) ground = color;
    const MeshPoint haze = color_of(whole, 0, 0);
    for (std::size_t k = 0; k < 3; ++k) {
        near[k] = 255 * static_cast<double>(plant_level_colors[2][k]);
        far[k] = 255 * static_cast<double>(plant_level_colors[3][k]);
    }
    // The weight of one colour is 0 on the plane through the three others.
    const auto weight = [&](const MeshPoint& one, const MeshPoint& other, const MeshPoint& color) {
        const MeshPoint normal = cross(difference(ground, other), difference(haze, other));
        return dot(normal, difference(color, other)) / dot(normal, difference(one, other));
    };
    double rounding = 0; // of both pictures by 0.5, and of the ground and the haze
    for (std::size_t k = 0; k < 3; ++k) {
        MeshPoint moved = near;
        moved[k] += 2;
        rounding += std::abs(weight(near, far, moved) - 1);
    }
    EXPECT_LT(rounding, 0.05);
    int over_far = 0;
    for (int i = 0; i < 128 * 72; ++i) {
        const MeshPoint alone = color_of(pictures[0], i % 128, i / 128), both = color_of(pictures[1], i % 128, i / 128);
        const double expected = weight(near, far, alone);
        EXPECT_NEAR(weight(near, far, both), expected, rounding) << i % 128 << ", " << i / 128;
        over_far += expected > 0.3 && weight(far, near, both) > 0.2;
    }
    EXPECT_GT(over_far, 20);
}

/// All tiles whose ground is in the picture are drawn, however steep it is.
TEST(GeometryTiles, AreSeenOnSteepGround)
{
    std::size_t sum = 0;
    for (const double pitch : {-50.0, 0.0, 50.0}) {
        FieldSettings settings = small_field();
        settings.field = {6, 6};
        settings.eye = {3.1, 2.9, 0.7};
        settings.pitch = pitch;
        InstanceSettings instances;
        instances.terrain = "sin(9 * x) * cos(8 * y)";
        instances.terrain_area = {0, 0, 6, 6};
        instances.height = 20;
        const Terrain terrain(instances);
        const PlantField field(some_plants(), {1, 0}, settings, terrain);
        std::set<std::pair<std::int32_t, std::int32_t>> seen, expected;
        for (const FieldTile& tile : field.seen()) seen.insert({tile.x, tile.y});
        const double h = settings.heading * std::numbers::pi / 180, p = pitch * std::numbers::pi / 180;
        const MeshPoint ahead{std::cos(h) * std::cos(p), std::sin(h) * std::cos(p), -std::sin(p)};
        const MeshPoint right{std::sin(h), -std::cos(h), 0}, up = cross(right, ahead);
        const double half = std::tan(27.5 * std::numbers::pi / 180);
        for (int i = 0; i < 25 * 25; ++i) { // the corners of cells of the ground
            const double x = i % 25 / 4.0, y = i / 25 / 4.0;
            const MeshPoint d = difference({x, y, terrain.at(x, y)}, {3.1, 2.9, 0.7 + terrain.at(3.1, 2.9)});
            const double depth = dot(d, ahead);
            if (depth > 0.05 && std::abs(dot(d, right)) < half * depth && std::abs(dot(d, up)) < half * 9 / 16 * depth)
                expected.insert({std::min(5, static_cast<int>(x)), std::min(5, static_cast<int>(y))});
        }
        EXPECT_TRUE(std::ranges::includes(seen, expected)) << pitch;
        sum += expected.size();
    }
    EXPECT_GT(sum, 5U);
}

TEST(GeometryTiles, AreTheSameOnAnyNumberOfThreads)
{
    const PlantTileSet& set = some_plants();
    const FieldSettings settings = small_field();
    std::vector<PngPixels> pictures;
    for (const std::size_t threads : {1U, 3U}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        const PlantField field(set, {1, 0}, settings, std::nullopt);
        LayeredTiles images(set, settings);
        images.make(field.needed());
        pictures.push_back(field.layered(images));
    }
    EXPECT_EQ(pictures[0].values, pictures[1].values);
}

/// No tile hides one that is drawn later: with the camera as origin, tiles come from the farthest along both axes.
TEST(GeometryTiles, AreDrawnFromTheFarthestOn)
{
    FieldSettings settings = small_field();
    settings.eye = {2.4, 2.2, 0.7};
    settings.angle_of_view = 120;
    const PlantField field(some_plants(), {1, 0}, settings, std::nullopt);
    const std::vector<FieldTile>& seen = field.seen();
    ASSERT_GT(seen.size(), 10U);
    const auto away = [](std::int32_t first, double eye) { // the range of distances along an axis
        const double near = std::max({first - eye, eye - first - 1, 0.0});
        return std::pair{near, first + 0.5 > eye ? 1 : -1};
    };
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (std::size_t k = i + 1; k < seen.size(); ++k) {
            // The earlier tile hides the later one only if it is between it and the eye along both axes.
            const auto [ex, esx] = away(seen[i].x, 2.4);
            const auto [ey, esy] = away(seen[i].y, 2.2);
            const auto [lx, lsx] = away(seen[k].x, 2.4);
            const auto [ly, lsy] = away(seen[k].y, 2.2);
            const bool is_between = (ex == 0 || (esx == lsx && ex <= lx)) && (ey == 0 || (esy == lsy && ey <= ly));
            EXPECT_FALSE(is_between) << i << " hides " << k;
        }
}

}
}
