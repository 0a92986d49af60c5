// Runs of constructions: what is stored is what reports read, and how many points of each class there are.
#include "results/pictures/construction_result.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/program.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Small enough for the plain twin.
const std::string plane = "colors = 2\npoints_per_tile = 16\nrelative_radius = 0.6\nlloyd_iterations = 2\n";
const std::string frame =
    "kind = \"template\"\ntiles = 3\npoints_per_tile = 16\nrelative_radius = 0.6\nlloyd_iterations = 2\n";
const std::string space =
    "kind = \"sphere\"\ncolors = 2\npoints_per_tile = 32\nrelative_radius = 0.5\nlloyd_iterations = 1\n";

class ConstructionRun : public testing::Test
{
protected:
    /// results.json of a run.
    json results(const std::string& tables)
    {
        folder_.write("c.toml", "engine = \"reference\"\n" + tables);
        const Outcome outcome = run_program(folder_.path(), {"run", "c.toml", "--out", "out"});
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return json::parse(content_of(out_ / "results.json"));
    }

    static std::string table(const std::string& lines) { return "[[construction]]\n" + lines; }

    Scene scene(const json& root, std::size_t number) const
    {
        return read_scene(out_ / root["constructions"][number]["file"].get<std::string>());
    }

    static std::size_t count(const ScenePanel& panel, PointClass kind)
    {
        return panel.points[static_cast<std::size_t>(kind)].size();
    }

    TemporaryFolder folder_;
    fs::path out_ = folder_.path() / "out";
};

/// Tilings are made as samplers make them, whatever relaxes their tiles together.
TEST_F(ConstructionRun, TilingsShowTilesThatAreRelaxedTogether)
{
    const std::string tiling = plane + "show = \"points\"\nwindow = [0, 0, 3, 2]\n";
    const json root = results(table(tiling + "border = \"chain\"\njoint_iterations = 2\n") +
                              table(tiling + "joint_iterations = 2\n") + table(tiling + "equal_moments = 1\n"));
    for (const std::size_t number : {0, 1, 2}) {
        SCOPED_TRACE(number);
        Scene shown = scene(root, number);
        const auto& points = shown.panels.front().of(PointClass::held);
        ASSERT_EQ(points.size(), 6u * 16u);
        double nearest = 1e9;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                nearest = std::min(nearest, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
        EXPECT_GE(nearest, 2 * shown.radius);
    }
}

TEST_F(ConstructionRun, StagesOfAPieceKeepTheirPoints)
{
    const json root = results(table(plane + "show = \"edge\"\nalong = \"y\"\nvariant = 2\n"));
    const Scene stages = scene(root, 0);
    ASSERT_EQ(stages.panels.size(), 4u);
    EXPECT_EQ(stages.panels[0].pieces.size(), 3u) << "two corners and the edge";
    EXPECT_EQ(count(stages.panels[0], PointClass::inner), 0u);
    for (const std::size_t i : {1, 2}) {
        const ScenePanel& torus = stages.panels[i];
        EXPECT_EQ(count(torus, PointClass::held) + count(torus, PointClass::inner) + count(torus, PointClass::outer),
                  4u * 16)
            << "a torus of four tiles";
        EXPECT_EQ(count(torus, PointClass::held), count(stages.panels[1], PointClass::held));
    }
    const ScenePanel& cut = stages.panels[3];
    EXPECT_EQ(cut.points[static_cast<std::size_t>(PointClass::inner)],
              stages.panels[2].points[static_cast<std::size_t>(PointClass::inner)]);
    EXPECT_EQ(count(cut, PointClass::outer) + count(cut, PointClass::held), 0u);
    for (const TilePosition& point : cut.points[static_cast<std::size_t>(PointClass::inner)])
        EXPECT_LT(std::abs(point[0]), stages.width) << "in the strip";
}

TEST_F(ConstructionRun, StagesOfATileEndWithAllItsPoints)
{
    const json root =
        results(table(plane + "show = \"tile\"\nvariant = 6\n") + table(plane + "show = \"tiles\"\ncount = 4\n"));
    const Scene stages = scene(root, 0);
    ASSERT_EQ(stages.panels.size(), 4u);
    const ScenePanel& cut = stages.panels[3];
    EXPECT_EQ(count(cut, PointClass::held) + count(cut, PointClass::inner), 16u);
    EXPECT_GT(count(stages.panels[1], PointClass::surroundings), 0u);
    EXPECT_EQ(count(stages.panels[1], PointClass::inner), count(cut, PointClass::inner));
    const Scene tiles = scene(root, 1);
    ASSERT_EQ(tiles.panels.size(), 4u);
    for (const ScenePanel& panel : tiles.panels) {
        EXPECT_EQ(count(panel, PointClass::held) + count(panel, PointClass::inner), 16u);
        EXPECT_EQ(panel.caption, "");
    }
    const json& stored = root["constructions"][1]["points"];
    EXPECT_EQ(stored["held"].get<int>() + stored["inner"].get<int>(), 4 * 16);
}

TEST_F(ConstructionRun, TilingsKeepTheDistance)
{
    const json root = results(table(plane + "show = \"tiling\"\nwindow = [-2, 3, 4, 3]\n") +
                              table(plane + "show = \"points\"\nwindow = [-2, 3, 4, 3]\n") +
                              table(frame + "show = \"tiling\"\nwindow = [0, 0, 4, 3]\n"));
    for (const std::size_t i : {0, 2}) {
        const Scene tiling = scene(root, i);
        const auto& points = tiling.panels.at(0).points[static_cast<std::size_t>(PointClass::held)];
        ASSERT_EQ(points.size(), 12u * 16);
        double closest = 1e300;
        for (std::size_t a = 0; a < points.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                closest = std::min(closest, std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1]));
        EXPECT_GE(closest, 2 * tiling.radius);
        EXPECT_EQ(tiling.panels[0].tiles.size(), 12u);
    }
    EXPECT_EQ(scene(root, 1).panels[0].points, scene(root, 0).panels[0].points);
    EXPECT_TRUE(scene(root, 1).panels[0].pieces.empty());
    // 20 corners, 16 + 15 edges: each once.
    EXPECT_EQ(scene(root, 0).panels[0].pieces.size(), 20u + 16 + 15);
}

TEST_F(ConstructionRun, TemplatesAreWhatTilesShare)
{
    const json root = results(table(frame + "show = \"master\"\n") + table(frame + "show = \"template\"\n") +
                              table(frame + "show = \"tile\"\nvariant = 2\n"));
    const Scene master = scene(root, 0), kept = scene(root, 1), tile = scene(root, 2);
    ASSERT_EQ(master.panels.size(), 2u);
    for (const ScenePanel& panel : master.panels) EXPECT_EQ(count(panel, PointClass::inner), 16u);
    ASSERT_EQ(kept.panels.size(), 2u);
    EXPECT_EQ(count(kept.panels[0], PointClass::held) + count(kept.panels[0], PointClass::outer), 16u);
    EXPECT_EQ(count(kept.panels[1], PointClass::outer), 0u);
    ASSERT_EQ(tile.panels.size(), 3u);
    EXPECT_EQ(count(tile.panels[0], PointClass::held), count(kept.panels[1], PointClass::held));
    EXPECT_EQ(count(tile.panels[2], PointClass::held) + count(tile.panels[2], PointClass::inner), 16u);
}

TEST_F(ConstructionRun, ShowsRegionsAndPiecesInSpace)
{
    const json root = results(table(space + "show = \"regions\"\nmodified = false\n") +
                              table(space + "show = \"kinds\"\n") + table(space + "show = \"corner\"\n"));
    const Scene regions = scene(root, 0), kinds = scene(root, 1), corner = scene(root, 2);
    const auto pieces_of = [](const Scene& stored) {
        std::vector<std::size_t> counts;
        for (const ScenePanel& panel : stored.panels) counts.push_back(panel.pieces.size());
        return counts;
    };
    EXPECT_THAT(pieces_of(regions), testing::ElementsAre(8, 12, 6, 1, 27, 20));
    EXPECT_FALSE(regions.panels[0].modified);
    EXPECT_THAT(pieces_of(kinds), testing::ElementsAre(1, 3, 3, 1));
    EXPECT_THAT(pieces_of(corner), testing::ElementsAre(1, 1, 1, 1));
    EXPECT_GT(count(corner.panels[3], PointClass::inner), 0u);
    for (const json& each : root["constructions"]) {
        const fs::path folder = out_ / each["name"].get<std::string>();
        EXPECT_GT(test::decode_png(content_of(folder / "construction.png")).variance(), 50);
        EXPECT_GT(fs::file_size(folder / "construction.svg"), 1000u);
    }
    EXPECT_THAT(content_of(out_ / "index.html"),
                testing::HasSubstr("3 pictures of the construction of Poisson tiles."));
}

TEST_F(ConstructionRun, GivesTheSameBytesAgain)
{
    const std::string tables =
        table(plane + "show = \"corner\"\n") + table(plane + "kind = \"edge\"\nshow = \"edge\"\n");
    results(tables);
    auto first = files_below(out_);
    results(tables);
    auto second = files_below(out_);
    for (const char* with_times : {"index.html", "results.json"}) first.erase(with_times), second.erase(with_times);
    EXPECT_EQ(first, second);
    EXPECT_TRUE(first.contains("construction-edge-edge/construction.json"));
}

TEST_F(ConstructionRun, SaysWhichTableCannotBeMade)
{
    folder_.write("c.toml", "engine = \"reference\"\n[[construction]]\nshow = \"corner\"\npoints_per_tile = 16\n"
                            "relative_radius = 0.97\nlloyd_iterations = 0\nrepulsion = false\n");
    const Outcome outcome = run_program(folder_.path(), {"run", "c.toml", "--out", "out"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error,
                testing::HasSubstr("c.toml:2: [[construction]]: a relative radius of 0.97: one of the corners"));
}

}
}
