#include "results/pictures/stored_constructions.hpp"

#include "base/files/json_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double largest_place = 1e9; // units; far beyond what is drawn
constexpr std::int64_t most_columns = 1000;

ConstructionResult read_construction(const StoredObject& object)
{
    ConstructionResult c;
    c.name = object.folder_name("name");
    c.label = object.text("label");
    c.kind = object.text("kind");
    c.show = object.text("show");
    c.colors = static_cast<std::size_t>(object.integer("colors", 1));
    c.tiles = static_cast<std::size_t>(object.integer("tiles", 1));
    c.points_per_tile = static_cast<std::size_t>(object.integer("points_per_tile", 1));
    c.relative_radius = object.number("relative_radius");
    c.lloyd_iterations = object.small_integer("lloyd_iterations", 0);
    c.repulsion = object.boolean("repulsion");
    c.filling = object.text("filling");
    c.file = object.file_name("file");
    const StoredObject points = object.object("points");
    for (std::size_t i = 0; i < c.points.size(); ++i)
        if (points.has(stored_point_classes[i]))
            c.points[i] = static_cast<std::size_t>(points.integer(stored_point_classes[i], 0));
    return c;
}

/// Places, `dimension` coordinates each.
std::vector<ShapeVector> read_places(const StoredObject& object, const std::string& name, int dimension)
{
    const std::vector<double> numbers = object.numbers(name);
    const auto d = static_cast<std::size_t>(dimension);
    if (numbers.size() % d != 0) throw object.error(name, fmt::format("must have {} coordinates for each place", d));
    if (!std::ranges::all_of(numbers, [](double n) { return std::abs(n) <= largest_place; }))
        throw object.error(name, "has places that are too far away");
    std::vector<ShapeVector> places(numbers.size() / d);
    for (std::size_t i = 0; i < numbers.size(); ++i) places[i / d][i % d] = numbers[i];
    return places;
}

ShapeVector read_place(const StoredObject& object, const std::string& name, int dimension)
{
    const auto places = read_places(object, name, dimension);
    if (places.size() != 1) throw object.error(name, fmt::format("must have {} coordinates", dimension));
    return places.front();
}

StoredBox read_box(const StoredObject& object, int dimension)
{
    StoredBox box{read_place(object, "low", dimension), read_place(object, "size", dimension)};
    for (int k = 0; k < dimension; ++k)
        if (!(box.size[static_cast<std::size_t>(k)] >= 1))
            throw object.error("size", "must be at least 1 unit along each axis");
    return box;
}

StoredPiece read_piece(const StoredObject& object, int dimension)
{
    StoredPiece piece;
    const std::int64_t axes = object.integer("axes", 0);
    if (axes > all_axes(dimension)) throw object.error("axes", "are those of no cell");
    piece.axes = static_cast<std::uint8_t>(axes);
    const ShapeVector place = read_place(object, "at", dimension);
    for (std::size_t k = 0; k < 3; ++k) {
        if (std::abs(place[k]) > largest_place / tile_units) throw object.error("at", "is too far away");
        piece.base[k] = static_cast<std::int32_t>(place[k]);
    }
    for (const double color : object.numbers("colors")) {
        if (!(color >= 0 && color <= largest_place)) throw object.error("colors", "must not be negative");
        piece.colors.push_back(static_cast<std::uint32_t>(color));
    }
    const std::size_t most = dimension == 2 && piece.axes == 0 ? 4 : std::size_t{1} << std::popcount(piece.axes);
    if (piece.colors.size() > 1 && piece.colors.size() != most)
        throw object.error("colors", fmt::format("must be none, one, or {}", most));
    piece.is_made = object.boolean("made");
    return piece;
}

StoredPanel read_panel(const StoredObject& object, int dimension)
{
    StoredPanel panel;
    panel.caption = object.text("caption");
    panel.modified = object.boolean("modified");
    panel.window = read_box(object.object("window"), dimension);
    panel.part = read_box(object.object("part"), dimension);
    for (const StoredObject& piece : object.objects("pieces")) panel.pieces.push_back(read_piece(piece, dimension));
    panel.tiles = read_places(object, "tiles", dimension);
    const StoredObject points = object.object("points");
    for (std::size_t i = 0; i < panel.points.size(); ++i)
        if (points.has(stored_point_classes[i]))
            panel.points[i] = read_places(points, stored_point_classes[i], dimension);
    return panel;
}

}

bool StoredPanel::has_points() const
{
    return std::ranges::any_of(points, [](const auto& list) { return !list.empty(); });
}

std::vector<ConstructionResult> read_constructions(const StoredObject& root)
{
    std::vector<ConstructionResult> constructions;
    if (!root.has("constructions")) return constructions;
    for (const auto& object : root.objects("constructions")) constructions.push_back(read_construction(object));
    return constructions;
}

StoredScene read_scene(const std::filesystem::path& file)
{
    const nlohmann::json json = read_json_file(file);
    const StoredObject root(json, file);
    if (!root.has("format") || root.text("format") != "poissonlab-construction")
        throw root.error("format", "must be \"poissonlab-construction\"; this file is of another kind");
    if (root.integer("format_version", 1) != 1) throw root.error("format_version", "this program reads version 1");
    StoredScene scene;
    scene.dimension = root.small_integer("dimension", 2);
    if (scene.dimension > 3) throw root.error("dimension", "must be 2 or 3");
    const std::int64_t width = root.integer("width", 1);
    if (width > tile_units / 2) throw root.error("width", "must be at most half a tile");
    scene.width = static_cast<std::int32_t>(width);
    scene.radius = root.number("radius");
    if (!(scene.radius > 0 && scene.radius <= tile_units))
        throw root.error("radius", "must be above 0 and at most a tile");
    scene.is_solid = root.boolean("solid");
    const std::int64_t columns = root.integer("columns", 1);
    if (columns > most_columns) throw root.error("columns", fmt::format("must be at most {}", most_columns));
    scene.columns = static_cast<std::size_t>(columns);
    for (const StoredObject& panel : root.objects("panels")) scene.panels.push_back(read_panel(panel, scene.dimension));
    if (scene.panels.empty()) throw root.error("panels", "must hold at least one panel");
    return scene;
}

}
