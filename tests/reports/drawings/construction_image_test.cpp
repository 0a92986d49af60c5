// Pictures of the construction of Poisson tiles: regions in their colours, points where they are.
#include "reports/drawings/construction_image.hpp"

#include "reports/drawings/space_view.hpp"
#include "reports/drawings/square_regions.hpp"
#include "tests/reports/support/construction_scene.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace poissonlab {
namespace {

Scene scene_of(const nlohmann::json& json)
{
    const TemporaryFolder folder;
    folder.write("construction.json", json.dump());
    return read_scene(folder.path() / "construction.json");
}

TEST(ConstructionImage, DrawsPointsAndRegionsWhereTheyAre)
{
    const Scene scene = scene_of(test::plane_scene());
    DrawingPoint size{};
    const PanelPlace place = panel_places(scene, size)[0];
    const test::Pixels pixels(draw_construction(scene), 4);
    const auto at = [&](double x, double y) {
        return pixels.at(place.origin[0] + (x + 20000) * place.scale, place.origin[1] + (60000 - y) * place.scale);
    };
    const ScenePanel& panel = scene.panels[0];
    for (std::size_t kind = 0; kind < panel.points.size(); ++kind) {
        const ShapeVector point = shape_vector(panel.points[kind].at(0));
        EXPECT_EQ(at(point[0], point[1]), point_color(kind).fill) << name_of(static_cast<PointClass>(kind));
    }
    const auto corner = colored_parts(panel.pieces[0], 2), edge = colored_parts(panel.pieces[1], 2);
    EXPECT_EQ(at(-12000, 0), corner.at(0).fill);
    EXPECT_EQ(at(9000, 9000), corner.at(0).fill) << "an octagon";
    EXPECT_EQ(at(12000, 12000), "#ffffff");
    EXPECT_EQ(at(25000, -3000), edge.at(0).fill) << "half and half";
    EXPECT_EQ(at(36000, -3000), edge.at(1).fill);
    EXPECT_EQ(at(25000, -9000), "#ffffff");
}

TEST(ConstructionImage, DrawsOnlyPartsOfRegions)
{
    const Scene scene = scene_of(test::plane_scene());
    DrawingPoint size{};
    const PanelPlace place = panel_places(scene, size)[1];
    const test::Pixels pixels(draw_construction(scene), 4);
    const auto at = [&](double x, double y) {
        return pixels.at(place.origin[0] + (x + 20000) * place.scale, place.origin[1] + (60000 - y) * place.scale);
    };
    EXPECT_EQ(at(4000, 4000), "#dcdcdc") << "no colour: grey";
    EXPECT_EQ(at(-4000, 4000), "#ffffff");
    EXPECT_EQ(at(65536, 30000), "#000000") << "the tile's border";
}

TEST(ConstructionImage, HasItsLettersBelowThePanels)
{
    const Scene scene = scene_of(test::plane_scene());
    DrawingPoint size{};
    const auto places = panel_places(scene, size);
    EXPECT_EQ(places[0].label[1], places[1].label[1]);
    EXPECT_GT(places[1].origin[0], places[0].origin[0] + 100000 * places[0].scale) << "panels do not overlap";
    const Drawing drawing = draw_construction(scene);
    EXPECT_EQ(drawing.width, size[0]);
    std::vector<std::string> letters;
    for (const Shape& shape : drawing.shapes)
        if (const auto* text = std::get_if<Text>(&shape.form)) {
            const DrawingPoint& middle = places.at(letters.size()).label;
            EXPECT_EQ(text->start[0], middle[0]);
            EXPECT_NEAR(text->start[1] - 0.27 * text->size, middle[1], 1e-9) << "small letters are about half as high";
            EXPECT_TRUE(text->is_centred);
            EXPECT_LT(text->start[1] + text->size / 2, drawing.height);
            letters.push_back(text->words);
        }
    EXPECT_THAT(letters, testing::ElementsAre("(a)", "(b)"));
}

TEST(ConstructionImage, LettersDiffer)
{
    EXPECT_EQ(panel_letter(0), "(a)");
    EXPECT_EQ(panel_letter(25), "(z)");
    EXPECT_EQ(panel_letter(26), "");
}

TEST(ConstructionImage, CornersOfEdgeBasedTilesHaveWedges)
{
    const ScenePiece piece{0, {1, 1, 0}, {0, 1, 2, 3}, false};
    const auto parts = colored_parts(piece, 2);
    ASSERT_EQ(parts.size(), 4u);
    const auto part_at = [&](double x, double y) {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (std::ranges::all_of(parts[i].bounds, [&](const ShapeHalfSpace& half) {
                    return half.normal[0] * (x + tile_units) + half.normal[1] * (y + tile_units) <= half.limit;
                }))
                found.push_back(i);
        return found;
    };
    EXPECT_THAT(part_at(10, 100), testing::ElementsAre(0)) << "north";
    EXPECT_THAT(part_at(100, -10), testing::ElementsAre(1)) << "east";
    EXPECT_THAT(part_at(10, -100), testing::ElementsAre(2)) << "south";
    EXPECT_THAT(part_at(-100, 10), testing::ElementsAre(3)) << "west";
}

TEST(ConstructionImage, BodiesHideWhatIsInThem)
{
    const auto middle_of = [](const Drawing& drawing) {
        return test::Pixels(drawing, 2).at(drawing.width / 2, drawing.height / 2);
    };
    const std::string wires = middle_of(draw_construction(scene_of(test::space_scene(false))));
    const std::string solid = middle_of(draw_construction(scene_of(test::space_scene(true))));
    const auto red_of = [](const std::string& color) { return color_channels(color)[0]; };
    const auto green_of = [](const std::string& color) { return color_channels(color)[1]; };
    EXPECT_GT(red_of(wires), green_of(wires) + 50) << wires << ": the sphere";
    EXPECT_GT(green_of(solid), red_of(solid) + 50) << solid << ": the great rhombicuboctahedron";
}

TEST(SpaceView, DrawsFarBodiesFirst)
{
    // All regions of a tile, and a large body behind a small one whose middle is farther.
    const TileRegions regions = modified_regions(3, 5000);
    std::vector<RegionShape> bodies;
    for (std::uint8_t axes = 0; axes < 8; ++axes) bodies.push_back(region_shape(regions, axes, {0, 0, 0}));
    const auto order = back_to_front(bodies);
    std::vector<std::size_t> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    EXPECT_LT(place[0], place[1]) << "the edge along x comes towards the viewer";
    EXPECT_GT(place[0], place[2]) << "the one along y goes away";
    EXPECT_LT(place[0], place[4]);
    EXPECT_LT(place[6], place[7]) << "the western face is behind the interior";
    EXPECT_GT(place[5], place[7]) << "the southern one before it";
    EXPECT_LT(place[3], place[7]) << "it stands on the bottom face";

    const RegionShape floor = box_shape(3, {-1e5, -1e5, -10}, {1e5, 1e5, 0});
    const RegionShape far = box_shape(3, {-9e4, 8e4, 0}, {-8e4, 9e4, 10});
    EXPECT_THAT(back_to_front({far, floor}), testing::ElementsAre(1, 0));
}

TEST(SpaceView, LooksFromTheSouthEastAndAbove)
{
    EXPECT_GT(projected({1, 0, 0})[0], 0);
    EXPECT_GT(projected({0, 1, 0})[0], 0);
    EXPECT_LT(projected({0, 0, 1})[1], 0) << "y of drawings is downwards";
    for (const ShapeVector& normal : {ShapeVector{1, 0, 0}, ShapeVector{0, -1, 0}, ShapeVector{0, 0, 1}}) {
        EXPECT_TRUE(is_in_sight(normal));
        EXPECT_FALSE(is_in_sight({-normal[0], -normal[1], -normal[2]}));
    }
    EXPECT_GT(light_on({0, 0, 1}), light_on({0, -1, 0}));
    EXPECT_GT(light_on({0, -1, 0}), light_on({1, 0, 0}));
}

}
}
