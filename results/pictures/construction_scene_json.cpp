// construction.json, written and read: every complaint names the file and the member.
#include "base/files/json_file.hpp"
#include "base/files/json_members.hpp"
#include "results/pictures/construction_scene.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

constexpr const char* scene_format = "poissonlab-construction";
constexpr int scene_format_version = 1;
constexpr double largest_place = 1e9; // units; far beyond what is drawn
constexpr std::int64_t most_columns = 1000;

/// All coordinates in one list, place after place.
void places(JsonMembers& m, const std::string& name, const std::vector<TilePosition>& places, int dimension)
{
    std::vector<std::int64_t> numbers;
    for (const TilePosition& place : places) numbers.insert(numbers.end(), place.begin(), place.begin() + dimension);
    m.member(name, std::as_const(numbers));
}

void places(JsonMembers& m, const std::string& name, std::vector<TilePosition>& places, int dimension)
{
    const std::vector<double> numbers = m.stored().numbers(name);
    const auto d = static_cast<std::size_t>(dimension);
    if (numbers.size() % d != 0)
        throw m.stored().error(name, fmt::format("must have {} coordinates for each place", d));
    if (!std::ranges::all_of(numbers, [](double n) { return std::abs(n) <= largest_place; }))
        throw m.stored().error(name, "has places that are too far away");
    places.resize(numbers.size() / d);
    for (std::size_t i = 0; i < numbers.size(); ++i) places[i / d][i % d] = static_cast<std::int32_t>(numbers[i]);
}

void place(JsonMembers& m, const std::string& name, const TilePosition& place, int dimension)
{
    places(m, name, {place}, dimension);
}

void place(JsonMembers& m, const std::string& name, TilePosition& place, int dimension)
{
    std::vector<TilePosition> all;
    places(m, name, all, dimension);
    if (all.size() != 1) throw m.stored().error(name, fmt::format("must have {} coordinates", dimension));
    place = all.front();
}

void box(JsonMembers& m, Stored<SceneBox> auto& box, int dimension)
{
    place(m, "low", box.low, dimension);
    place(m, "size", box.size, dimension);
    m.check([&](const StoredObject& object) {
        if (std::any_of(box.size.begin(), box.size.begin() + dimension, [](std::int32_t size) { return size < 1; }))
            throw object.error("size", "must be at least 1 unit along each axis");
    });
}

void colors(JsonMembers& m, const ScenePiece& piece, int)
{
    const std::vector<std::int64_t> colors(piece.colors.begin(), piece.colors.end());
    m.member("colors", colors);
}

void colors(JsonMembers& m, ScenePiece& piece, int dimension)
{
    for (const double color : m.stored().numbers("colors")) {
        if (!(color >= 0 && color <= largest_place)) throw m.stored().error("colors", "must not be negative");
        piece.colors.push_back(static_cast<std::uint32_t>(color));
    }
    const std::size_t most = dimension == 2 && piece.axes == 0 ? 4 : std::size_t{1} << std::popcount(piece.axes);
    if (piece.colors.size() > 1 && piece.colors.size() != most)
        throw m.stored().error("colors", fmt::format("must be none, one, or {}", most));
}

void check(const StoredObject& object, const ScenePiece& piece, int dimension)
{
    if (piece.axes > all_axes(dimension)) throw object.error("axes", "are those of no cell");
    if (std::ranges::any_of(piece.base, [](std::int32_t k) { return std::abs(k) > largest_place / tile_units; }))
        throw object.error("at", "is too far away");
}

void piece(JsonMembers& m, Stored<ScenePiece> auto& piece, int dimension)
{
    m.member("axes", piece.axes);
    place(m, "at", piece.base, dimension);
    m.check([&](const StoredObject& object) { check(object, piece, dimension); });
    colors(m, piece, dimension);
    m.member("made", piece.is_made);
}

void panel(JsonMembers& m, Stored<ScenePanel> auto& panel, int dimension)
{
    m.member("caption", panel.caption);
    m.member("modified", panel.modified);
    m.if_any("radius", panel.radius);
    m.check([&](const StoredObject& object) {
        if (!(panel.radius >= 0 && panel.radius <= tile_units))
            throw object.error("radius", "must not be negative, and at most a tile");
    });
    m.group("window", [&](JsonMembers& group) { box(group, panel.window, dimension); });
    m.group("part", [&](JsonMembers& group) { box(group, panel.part, dimension); });
    m.objects("pieces", panel.pieces, [&](JsonMembers& member, auto& value) { piece(member, value, dimension); });
    places(m, "tiles", panel.tiles, dimension);
    m.group("points", [&](JsonMembers& points) {
        for (const PointClass kind : stored_point_classes) {
            auto& list = panel.points[static_cast<std::size_t>(kind)];
            if (points.is_there(name_of(kind), !list.empty())) places(points, name_of(kind), list, dimension);
        }
    });
}

void describe(JsonMembers& m, Stored<Scene> auto& scene)
{
    m.format(scene_format, scene_format_version);
    m.member("dimension", scene.dimension, 2);
    m.check([&](const StoredObject& root) {
        if (scene.dimension > 3) throw root.error("dimension", "must be 2 or 3");
    });
    m.constant("tile_units", tile_units);
    m.member("width", scene.width, 1);
    m.member("radius", scene.radius);
    m.member("solid", scene.is_solid);
    m.member("columns", scene.columns, 1);
    m.objects("panels", scene.panels, [&](JsonMembers& member, auto& value) { panel(member, value, scene.dimension); });
}

void check(const StoredObject& root, const Scene& scene)
{
    if (scene.width > tile_units / 2) throw root.error("width", "must be at most half a tile");
    if (!(scene.radius > 0 && scene.radius <= tile_units))
        throw root.error("radius", "must be above 0 and at most a tile");
    if (scene.columns > most_columns) throw root.error("columns", fmt::format("must be at most {}", most_columns));
    if (scene.panels.empty()) throw root.error("panels", "must hold at least one panel");
}

}

std::string scene_json(const Scene& scene)
{
    return json_text([&](JsonMembers& root) { describe(root, scene); }) + "\n";
}

Scene read_scene(const std::filesystem::path& file)
{
    const nlohmann::json json = read_json_file(file);
    JsonMembers root(StoredObject(json, file));
    Scene scene;
    describe(root, scene);
    check(root.stored(), scene);
    return scene;
}

}
