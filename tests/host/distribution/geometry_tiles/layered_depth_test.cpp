// Layered depth images of tiles are held against rays, and levels against sets of what they cover.
#include "tests/host/distribution/geometry_tiles/plant_rays.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
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

/// Seen along the ground, a triangle with the normal n that fills pixels seen along w looks |n d| / |n w| of them
/// large. Areas are floors of 64ths and up to 3.9, and normals are rounded to 127ths.
TEST(GeometryTiles, SamplesKnowHowLargeTheirSurfaceLooks)
{
    const PlantTileSet& set = some_plants();
    const std::vector<LitPlant> plants = lit_plants(set.plants[3], set.models, set.radius);
    const std::vector<LitTriangle> triangles = triangles_of(plants);
    std::size_t compared = 0, oblique = 0;
    for (const double azimuth : {0.4, 3.0}) {
        const DepthView view = depth_view(azimuth, 0.3, set.height);
        const LayeredDepthImage image = depth_picture(plants, view, 48);
        const MeshPoint along{-view.back[0], -view.back[1], -view.back[2]};
        for (int row = 0; row < image.rows; ++row)
            for (int column = 0; column < image.columns; ++column)
                for (const DepthSample& s : image.at(column, row)) {
                    MeshPoint from = view.place({(column + 0.5) / 48, (row + 0.5) / 48, -10});
                    from = {from[0] + 0.5, from[1] + 0.5, from[2]};
                    MeshPoint normal{};
                    for (const LitTriangle& t : triangles) {
                        const auto hit = met(from, along, t);
                        if (hit && std::min({(*hit)[1], (*hit)[2], (*hit)[3]}) > 1e-9 &&
                            std::abs((*hit)[0] - 10 - static_cast<double>(s.depth)) < 1e-6)
                            normal = unit(
                                cross(difference(t.v[1].place, t.v[0].place), difference(t.v[2].place, t.v[0].place)));
                    }
                    if (dot(normal, normal) == 0) continue; // rounding decides
                    const double area = std::min(3.9, 1 / std::abs(dot(normal, view.back)));
                    for (const double turn : {0.0, 1.0, 2.0}) {
                        const MeshPoint d{std::cos(turn), std::sin(turn), 0};
                        const double side = s.side_from(d);
                        EXPECT_NEAR(side * side, area * std::abs(dot(normal, d)), 1 / 64.0 + 3.9 * 0.72 / 127);
                    }
                    ++compared;
                    oblique += area > 2;
                }
    }
    EXPECT_GT(compared, 300U);
    EXPECT_GT(oblique, 20U);
    DepthSample unknown;
    EXPECT_EQ(unknown.side_from({0, 0, 1}), 1);
}

/// The farther one of two places on a ray from an eye anywhere is drawn first.
TEST(GeometryTiles, SamplesAreDrawnFromTheFarthestOn)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0, 1);
    std::size_t pairs = 0, near_eye = 0;
    for (int number = 0; number < 60; ++number) {
        LayeredDepthImage image;
        image.view = depth_view(2 * std::numbers::pi * part(random), 0.3, 0.4);
        image.pixel = 1.0 / 6;
        image.columns = static_cast<int>(std::ceil(image.view.width / image.pixel));
        image.rows = static_cast<int>(std::ceil(image.view.height / image.pixel));
        const double away = number % 3; // 0: above the tile
        const MeshPoint eye{away * (part(random) - 0.5) * 4, away * (part(random) - 0.5) * 4, part(random)};
        std::map<std::size_t, std::vector<DepthSample>> pixels;
        const auto add = [&](const MeshPoint& place, std::size_t plant) {
            const MeshPoint seen = image.view.seen(place);
            DepthSample sample;
            sample.depth = static_cast<float>(seen[2]);
            sample.plant = static_cast<std::uint16_t>(plant);
            pixels[static_cast<std::size_t>(seen[1] / image.pixel) * static_cast<std::size_t>(image.columns) +
                   static_cast<std::size_t>(seen[0] / image.pixel)]
                .push_back(sample);
            return seen;
        };
        const std::size_t rays = 200;
        for (std::size_t i = 0; i < rays; ++i) {
            const MeshPoint to{part(random) - 0.5, part(random) - 0.5, 0.4 * part(random)};
            MeshPoint between{}; // nearer on the ray, above the tile as well
            const double nearer = part(random);
            for (std::size_t k = 0; k < 3; ++k) between[k] = to[k] + nearer * (eye[k] - to[k]);
            if (std::max(std::abs(between[0]), std::abs(between[1])) > 0.5 || between[2] > 0.4) between = to;
            near_eye += add(to, 2 * i)[2] < image.view.seen(eye)[2];
            add(between, 2 * i + 1);
            pairs += between != to;
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
             ++i) {
            image.first.push_back(static_cast<std::uint32_t>(image.samples.size()));
            std::ranges::stable_sort(pixels[i], {}, [](const DepthSample& s) { return -s.depth; });
            image.samples.insert(image.samples.end(), pixels[i].begin(), pixels[i].end());
        }
        image.first.push_back(static_cast<std::uint32_t>(image.samples.size()));
        std::vector<std::size_t> turn(2 * rays);
        std::size_t drawn = 0;
        draw_from_farthest(image, image.view.seen(eye),
                           [&](int, int, const DepthSample& s) { turn[s.plant] = drawn++; });
        ASSERT_EQ(drawn, 2 * rays);
        for (std::size_t i = 0; i < rays; ++i) {
            const auto is_same = [&](const DepthSample& a) { return a.plant == 2 * i || a.plant == 2 * i + 1; };
            const auto first = std::ranges::find_if(image.samples, is_same);
            const auto second = std::find_if(first + 1, image.samples.end(), is_same);
            if (first->depth == second->depth) continue; // one place
            EXPECT_LT(turn[2 * i], turn[2 * i + 1]) << number << ", " << i;
        }
    }
    EXPECT_GT(pairs, 2000U);
    EXPECT_GT(near_eye, 100U);
}

}
}
