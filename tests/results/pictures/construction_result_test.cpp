// The member "constructions" of results.json and the files construction.json, whole and damaged.
#include "results/pictures/construction_result.hpp"

#include "base/files/json_members.hpp"
#include "tests/reports/support/construction_scene.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Constructions : public testing::Test
{
protected:
    Scene read(const json& scene) const
    {
        folder_.write("construction.json", scene.dump());
        return read_scene(folder_.path() / "construction.json");
    }

    template <class Damage>
    std::string error_after(const Damage& damage) const
    {
        json scene = test::plane_scene();
        damage(scene);
        return message_of([&] { read(scene); });
    }

    TemporaryFolder folder_;
};

TEST_F(Constructions, ScenesAreRead)
{
    const Scene scene = read(test::plane_scene());
    EXPECT_EQ(scene.dimension, 2);
    EXPECT_EQ(scene.width, 6000);
    EXPECT_EQ(scene.radius, 5999.5);
    EXPECT_EQ(scene.columns, 2u);
    ASSERT_EQ(scene.panels.size(), 2u);
    const ScenePanel& panel = scene.panels[0];
    EXPECT_EQ(panel.caption, "First.");
    EXPECT_EQ(panel.window.high_corner(), (ShapeVector{80000, 60000, 0}));
    ASSERT_EQ(panel.pieces.size(), 2u);
    EXPECT_EQ(panel.pieces[1].axes, 1);
    EXPECT_EQ(panel.pieces[1].colors, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(panel.pieces[1].is_made);
    EXPECT_EQ(panel.points[static_cast<std::size_t>(PointClass::inner)], (std::vector<TilePosition>{{40000, 500, 0}}));
    EXPECT_TRUE(panel.has_points());
    EXPECT_FALSE(scene.panels[1].has_points());
    EXPECT_EQ(scene.panels[1].tiles.size(), 1u);
    EXPECT_EQ(read(test::space_scene(true)).panels[0].window.size[2], 50000);
}

TEST_F(Constructions, DamagedScenesNameTheMember)
{
    EXPECT_THAT(error_after([](json& j) { j["format"] = "x"; }), HasSubstr("construction.json: format = \"x\": "));
    EXPECT_THAT(error_after([](json& j) { j["format_version"] = 2; }), HasSubstr("reads version 1"));
    EXPECT_THAT(error_after([](json& j) { j["dimension"] = 4; }), HasSubstr("dimension = 4: must be 2 or 3"));
    EXPECT_THAT(error_after([](json& j) { j["width"] = 40000; }), HasSubstr("width = 40000: "));
    EXPECT_THAT(error_after([](json& j) { j["radius"] = 0; }), HasSubstr("radius = 0: "));
    EXPECT_THAT(error_after([](json& j) { j["columns"] = 0; }), HasSubstr("columns = 0: "));
    EXPECT_THAT(error_after([](json& j) { j["panels"] = json::array(); }), HasSubstr("panels: must hold at least one"));
    EXPECT_THAT(error_after([](json& j) {
                    j["panels"][1]["window"]["size"] = {0, 1};
                }),
                HasSubstr("panels[1].window.size: "));
    EXPECT_THAT(error_after([](json& j) { j["panels"][0]["pieces"][0]["axes"] = 4; }),
                HasSubstr("panels[0].pieces[0].axes = 4: "));
    EXPECT_THAT(error_after([](json& j) {
                    j["panels"][0]["pieces"][1]["colors"] = {0, 1, 2};
                }),
                HasSubstr("colors: must be none, one, or 2"));
    EXPECT_THAT(error_after([](json& j) { j["panels"][0]["pieces"][1]["colors"] = {-1}; }),
                HasSubstr("must not be negative"));
    EXPECT_THAT(error_after([](json& j) { j["panels"][0]["pieces"][1]["at"] = {1e9, 0}; }), HasSubstr("too far away"));
    EXPECT_THAT(error_after([](json& j) {
                    j["panels"][0]["points"]["held"] = {1, 2, 3};
                }),
                HasSubstr("points.held: must have 2 coordinates"));
    EXPECT_THAT(error_after([](json& j) { j["panels"][0]["points"]["held"] = {1e300, 0}; }), HasSubstr("too far away"));
    folder_.write("construction.json", "{");
    EXPECT_THROW(read_scene(folder_.path() / "construction.json"), InputError);
}

TEST_F(Constructions, MembersOfResultsAreRead)
{
    folder_.write("construction.json", "{}");
    const json good = json::parse(R"({"name": "n", "label": "L", "kind": "edge", "show": "tile", "colors": 2,
        "tiles": 4096, "points_per_tile": 32, "relative_radius": 0.7, "filling": "dart-throwing", "lloyd_iterations": 3,
        "repulsion": true, "seed": 1, "file": "construction.json", "panels": 4, "points": {"held": 12, "inner": 20}})");
    const auto read_member = [&](const json& member) {
        const json root = {{"constructions", {member}}};
        std::vector<ConstructionResult> constructions;
        JsonMembers(StoredObject(root, folder_.path() / "results.json")).objects("constructions", constructions);
        return constructions;
    };
    const auto stored = read_member(good);
    ASSERT_EQ(stored.size(), 1u);
    EXPECT_EQ(stored[0].tiles, 4096u);
    EXPECT_EQ(stored[0].scene.points[static_cast<std::size_t>(PointClass::held)], 12u);
    EXPECT_EQ(stored[0].scene.points[static_cast<std::size_t>(PointClass::outer)], 0u);
    for (const char* name : {"name", "label", "kind", "show", "tiles", "file", "points"}) {
        json damaged = good;
        damaged[name] = -1;
        EXPECT_THAT(message_of([&] { read_member(damaged); }), HasSubstr(std::string("constructions[0].") + name));
    }
}

}
}
