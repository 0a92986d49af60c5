#include "results/pictures/construction_scene.hpp"

#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using Json = nlohmann::ordered_json;

/// The first two or three of three numbers.
Json place_json(const std::array<std::int32_t, 3>& place, int dimension)
{
    return dimension == 2 ? Json{place[0], place[1]} : Json{place[0], place[1], place[2]};
}

Json box_json(const SceneBox& box, int dimension)
{
    return {{"low", place_json(box.low, dimension)}, {"size", place_json(box.size, dimension)}};
}

/// All coordinates in one list, point after point.
Json points_json(const std::vector<TilePosition>& points, int dimension)
{
    Json list = Json::array();
    for (const TilePosition& point : points)
        for (int k = 0; k < dimension; ++k) list.push_back(point[static_cast<std::size_t>(k)]);
    return list;
}

Json panel_json(const ScenePanel& panel, int dimension)
{
    Json json = {{"caption", panel.caption},
                 {"modified", panel.modified},
                 {"window", box_json(panel.window, dimension)},
                 {"part", box_json(panel.part, dimension)},
                 {"pieces", Json::array()},
                 {"tiles", points_json(panel.tiles, dimension)},
                 {"points", Json::object()}};
    for (const ScenePiece& piece : panel.pieces)
        json["pieces"].push_back({{"axes", piece.axes},
                                  {"at", place_json(piece.base, dimension)},
                                  {"colors", piece.colors},
                                  {"made", piece.is_made}});
    for (std::size_t i = 0; i < panel.points.size(); ++i)
        if (!panel.points[i].empty()) json["points"][point_class_names[i]] = points_json(panel.points[i], dimension);
    return json;
}

}

bool SceneBox::holds(const TilePosition& position, int dimension) const
{
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
        if (position[k] < low[k] || position[k] >= low[k] + size[k]) return false;
    return true;
}

SceneSummary summary_of(const Scene& scene)
{
    SceneSummary summary;
    summary.panels = scene.panels.size();
    for (const ScenePanel& panel : scene.panels)
        for (std::size_t i = 0; i < summary.points.size(); ++i) summary.points[i] += panel.points[i].size();
    return summary;
}

std::string scene_json(const Scene& scene)
{
    Json json = {{"format", "poissonlab-construction"},
                 {"format_version", 1},
                 {"dimension", scene.dimension},
                 {"tile_units", tile_units},
                 {"width", scene.width},
                 {"radius", scene.radius},
                 {"solid", scene.is_solid},
                 {"columns", scene.columns},
                 {"panels", Json::array()}};
    for (const ScenePanel& panel : scene.panels) json["panels"].push_back(panel_json(panel, scene.dimension));
    return json.dump() + "\n";
}

}
