#include "reports/engine/texture_pages.hpp"

#include "reports/engine/look_up_texts.hpp"
#include "reports/layout/page_template.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/words/base64.hpp"
#include "tiles/texture/engine/engine_map.hpp"
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

std::string render_plane_page(const TextureSet& set, const std::string& name)
{
    PageData page;
    page.set("title", fmt::format("The endless plane of {}", name));
    page.set("facts", fmt::format("{} {} tiles of {} × {} texels.", set.tiles.size(), texture_kinds[set.kind], set.size,
                                  set.size));
    page.set("name", name);
    page.set("colors", fmt::format("{}", set.colors.horizontal));
    page.set("size", fmt::format("{}", set.size));
    page.set("channels", fmt::format("{}", set.exemplar.channels));
    page.set("style", std::string(page_template_file("templates/report.css")));
    page.set("look_up", glsl_look_up(set));
    PageData levels{PageData::type::list};
    EngineMap level = color_map(set);
    for (int left = tile_levels(set.size); left > 0; --left) {
        const RawPicture picture = encoded_level(level);
        levels << PageData(base64_of({reinterpret_cast<const char*>(picture.bytes.data()), picture.bytes.size()}));
        if (left > 1) level = halved(level);
    }
    page.set("levels", levels);
    PageData scripts{PageData::type::list};
    for (const char* script : {"webgl.js", "texture_plane_gl.js", "texture_plane.js"})
        scripts << PageData(std::string(page_template_file("templates/" + std::string(script))));
    page.set("scripts", scripts);
    return render_template("texture_plane", page);
}

}
