#include "reports/engine/design_page.hpp"

#include "reports/layout/page_template.hpp"
#include "reports/pages/page_frame.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {
namespace {

nlohmann::ordered_json tile_json(const TextureSet& set, std::size_t number, const AtlasLayout& layout)
{
    const TileIndex index = set.tiles[number].index;
    nlohmann::ordered_json tile{
        {"index", index}, {"column", layout.places[number].first}, {"row", layout.places[number].second}};
    if (set.has_corners()) {
        const CornerTile corners = corner_tile(index, set.colors.horizontal);
        tile.update({{"ne", corners.north_east},
                     {"se", corners.south_east},
                     {"sw", corners.south_west},
                     {"nw", corners.north_west}});
    } else {
        const WangTile edges = wang_tile(index, set.colors);
        tile.update({{"north", edges.north}, {"east", edges.east}, {"south", edges.south}, {"west", edges.west}});
    }
    return tile;
}

std::string set_json(const TextureSet& set)
{
    const AtlasLayout layout = atlas_layout(set);
    nlohmann::ordered_json json{{"kind", texture_kinds[set.kind]},
                                {"colors", set.colors.horizontal},
                                {"size", set.size},
                                {"ring", set.ring},
                                {"columns", layout.columns},
                                {"rows", layout.rows}};
    for (std::size_t i = 0; i < set.tiles.size(); ++i) json["tiles"].push_back(tile_json(set, i, layout));
    return json.dump();
}

}

std::string render_design_page(const TextureSet& set)
{
    PageData page;
    page.set("title", set.has_corners() ? "Corner tiles, drawn by hand" : "Wang tiles, drawn by hand");
    page.set("facts", fmt::format("{} tiles of {} × {} pixels, over {} colours.", set.tiles.size(), set.size, set.size,
                                  set.colors.horizontal));
    page.set("part", set.has_corners() ? "a corner or an edge" : "an edge");
    page.set("its_color", set.has_corners() ? "its colours there" : "its colour there");
    page.set("parts", set.has_corners() ? "corners" : "edges");
    page.set("count", fmt::format("{}", set.tiles.size()));
    page.set("radius", fmt::format("{}", std::max(1, set.size / 16)));
    page.set("set", set_json(set));
    page.set("style", std::string(page_template_file("templates/report.css")));
    PageData scripts{PageData::type::list};
    for (const char* script : {"texture_design_tiles.js", "texture_design_files.js", "texture_design.js"})
        scripts << PageData(std::string(page_template_file("templates/" + std::string(script))));
    page.set("scripts", scripts);
    return render_template("texture_design", page);
}

}
