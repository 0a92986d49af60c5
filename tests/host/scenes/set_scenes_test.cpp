// Steps of point sets: they end with the points of the samplers, and what each says of distances is so.
#include "host/scenes/construction_panels.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "base/random/random.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/exhibits.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;

ShownConstruction set_config(const std::string& lines)
{
    const auto exhibits = exhibits_in("seed = 3\n[[construction]]\nkind = \"set\"\n" + lines, "test.toml");
    auto shown = exhibits.at(0).settings.as<ShownConstruction>();
    shown.parameters.seed = 3;
    return shown;
}

/// The positions of a sampler's points, in units and in their order.
std::vector<TilePosition> positions_of(const PointSet& points)
{
    std::vector<TilePosition> positions;
    for (std::size_t i = 0; i < points.size(); ++i)
        positions.push_back({static_cast<std::int32_t>(points[i][0] * tile_units),
                             static_cast<std::int32_t>(points[i][1] * tile_units), 0});
    return positions;
}

std::vector<TilePosition> points_after(ScenePanel panel)
{
    std::vector<TilePosition> all = panel.of(PointClass::held);
    all.insert(all.end(), panel.of(PointClass::inner).begin(), panel.of(PointClass::inner).end());
    return all;
}

/// Distances are rounded by a unit in either coordinate of either place.
constexpr double rounding = 2 * 1.5;

double torus_distance(const TilePosition& a, const TilePosition& b)
{
    double squared = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const double along = std::abs(a[k] - b[k]);
        squared += std::pow(std::min(along, tile_units - along), 2);
    }
    return std::sqrt(squared);
}

TEST(SetScenes, OfRelaxationDartThrowingEndWithTheSamplersPoints)
{
    const Scene scene = set_scene(set_config("show = \"relaxation-dart-throwing\"\npoints = 60\n"));
    RelaxationDartThrowingRequest request;
    request.points = 60;
    request.attempts = 100;
    request.factor = 0.97;
    request.stream = stream_key(3, Purpose::relaxation_dart_throwing, 0);
    const RelaxationDarts darts = reference::throw_relaxation_darts(request);
    EXPECT_EQ(points_after(scene.panels.back()), positions_of(darts.points));
    EXPECT_NEAR(scene.panels.back().radius, darts.radius * tile_units, 1e-9);
    EXPECT_NEAR(scene.panels.front().radius, 0.15 * tile_units, 1e-9);
    EXPECT_THAT(scene.panels.back().caption, HasSubstr("Dart " + std::to_string(darts.darts) + " becomes point 60"));
}

TEST(SetScenes, SayTheTruthOfEveryDart)
{
    for (const char* show : {"dart-throwing", "relaxation-dart-throwing"}) {
        Scene scene = set_scene(set_config(std::string("show = \"") + show + "\"\npoints = 80\n"));
        std::size_t accepted = 0, refused = 0;
        for (ScenePanel& panel : scene.panels) {
            const auto &held = panel.of(PointClass::held), &inner = panel.of(PointClass::inner),
                       &outer = panel.of(PointClass::outer);
            if (outer.size() == 1) {
                ++refused;
                ASSERT_EQ(inner.size(), 1U);
                EXPECT_LT(torus_distance(outer[0], inner[0]), 2 * panel.radius + rounding);
                for (const TilePosition& other : held) // the point that it names is the nearest
                    EXPECT_GE(torus_distance(outer[0], other) + rounding, torus_distance(outer[0], inner[0]));
            } else if (inner.size() == 1) {
                ++accepted;
                EXPECT_EQ(held.size() + 1, accepted);
                for (const TilePosition& other : held)
                    EXPECT_GT(torus_distance(inner[0], other), 2 * panel.radius - rounding);
            }
        }
        EXPECT_EQ(accepted, 80U);
        EXPECT_GT(refused, 40U);
    }
}

TEST(SetScenes, OfDartThrowingEndWhereNothingFits)
{
    const Scene scene = set_scene(set_config("show = \"dart-throwing\"\npoints = 100\nrelative_radius = 0.95\n"));
    EXPECT_THAT(scene.panels.back().caption, HasSubstr("hardly any place left"));
    EXPECT_LT(points_after(scene.panels.back()).size(), 100U);
}

TEST(SetScenes, OfLloydRelaxationAreItsIterates)
{
    Scene scene = set_scene(set_config("show = \"lloyd\"\npoints = 50\niterations = 7\n"));
    ASSERT_EQ(scene.panels.size(), 8U);
    const StreamKey stream = stream_key(3, Purpose::random_points, 0);
    std::vector<TorusPoint<2>> start;
    for (std::uint32_t i = 0; i < 25; ++i) {
        const auto words = philox({i, 0, 0, 0}, stream);
        start.push_back({words[0], words[1]});
        start.push_back({words[2], words[3]});
    }
    const LloydResult relaxed = reference::relax(to_point_set<2>(start), {}, {.iterations = 7});
    EXPECT_EQ(scene.panels.front().of(PointClass::inner), positions_of(to_point_set<2>(start)));
    EXPECT_EQ(scene.panels.back().of(PointClass::inner), positions_of(relaxed.points));
    EXPECT_NEAR(scene.panels.back().radius,
                max_min_distance(50, 2) * relaxed.iterations.back().relative_radius / 2 * tile_units, 1e-6);
}

TEST(SetScenes, RefuseKeysOfOtherMethodsAndLargeSets)
{
    const auto refused = [](const std::string& lines) { return refusal_of([&] { set_config(lines); }); };
    EXPECT_THAT(refused("show = \"lloyd\"\nrelative_radius = 0.5\n"), HasSubstr("test.toml:5: "));
    EXPECT_THAT(refused("show = \"dart-throwing\"\npoints = 501\n"), HasSubstr("test.toml:5: points = 501"));
    EXPECT_THAT(refused("show = \"edge\"\n"), HasSubstr("test.toml:4: show = \"edge\""));
    EXPECT_THAT(refused("colors = 3\n"), HasSubstr("test.toml:4: colors"));
}

}
}
