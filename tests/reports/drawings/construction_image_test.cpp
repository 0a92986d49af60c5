// Pictures of the construction of Poisson tiles: regions in their colours, points where they are.
#include "reports/drawings/construction_image.hpp"

#include "reports/drawings/panel_label.hpp"
#include "reports/drawings/region_colors.hpp"
#include "reports/drawings/space_view.hpp"
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
    const auto strokes_around = [&](const DrawingPoint& middle) {
        return std::ranges::count_if(drawing.shapes, [&](const Shape& shape) {
            return shape.outline.size() == 2 && std::abs(shape.outline[0][0] - middle[0]) < panel_label_height &&
                   std::abs(shape.outline[0][1] - middle[1]) < panel_label_height;
        });
    };
    for (const PanelPlace& place : places) EXPECT_GT(strokes_around(place.label), 30);
    EXPECT_LT(places[0].label[1] + panel_label_height / 2, drawing.height);
}

TEST(ConstructionImage, LettersDiffer)
{
    std::set<std::vector<DrawingPoint>> seen;
    for (std::size_t panel = 0; panel < most_panel_letters; ++panel) {
        std::vector<Shape> shapes;
        add_panel_label(shapes, panel, {0, 0});
        std::vector<DrawingPoint> points;
        for (const Shape& shape : shapes) {
            for (const DrawingPoint& point : shape.outline) {
                EXPECT_LT(std::abs(point[0]), panel_label_height);
                EXPECT_LE(std::abs(point[1]), 0.6 * panel_label_height);
                points.push_back(point);
            }
        }
        EXPECT_TRUE(seen.insert(points).second) << panel;
    }
    std::vector<Shape> none;
    add_panel_label(none, most_panel_letters, {0, 0});
    EXPECT_TRUE(none.empty());
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
