// poissonlab texture design: a page on which texture tiles are drawn by hand.
#include "app/commands/command.hpp"
#include "app/commands/output_file.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "reports/engine/texture_pages.hpp"
#include "results/own_files.hpp"
#include "tiles/tilings/tile_set.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto texture_design_notes =
    R"(The page opens from the disk in any browser, and draws with a mouse, a pen or fingers, on a tile or on a window of
the endless tiling (Cohen and others 2003, section 3.1). A mark that comes near an edge is in every tile with the edge's
colour, and on the other side of the edge; of corner tiles one near a corner is at every corner of its colour, of Wang tiles
at every corner. So all tiles fit, whatever is drawn. The page saves a texture set, which the other commands take.
  poissonlab texture design corner --colors 2 --size 64 --out design.html
  unzip drawn.zip
  poissonlab texture verify drawn
  poissonlab texture tile drawn --window 0 0 16 9 --out plain.png)";

constexpr std::uint32_t least_drawn = 32, most_drawn = 128, most_drawn_colors = 4;

struct TextureDesignOptions
{
    std::string kind;
    std::uint32_t colors = 2;
    std::uint32_t size = 64;
    std::filesystem::path out;
};

void design_texture(const TextureDesignOptions& o)
{
    constexpr WordTable<TextureKind, 2> drawn_kinds{{{{TextureKind::corner, "corner"}, {TextureKind::wang, "wang"}}}};
    const std::filesystem::path out = checked_output("texture design", "--out", o.out, {{".html"}});
    check_own_page(out);
    if (o.colors < 2 || o.colors > most_drawn_colors)
        throw InputError(
            fmt::format("texture design: --colors {}: must be an integer from 2 to {}", o.colors, most_drawn_colors));
    if (o.size % 2 != 0 || o.size < least_drawn || o.size > most_drawn)
        throw InputError(fmt::format("texture design: --size {}: must be an even number from {} to {}", o.size,
                                     least_drawn, most_drawn));
    TextureSet set;
    set.kind = value_of_word("texture design", "KIND", o.kind, drawn_kinds);
    set.colors = {o.colors, o.colors};
    set.size = static_cast<int>(o.size);
    set.ring = std::max(2, set.size / 16);
    const TileSet tiles = TileSet::complete(set.has_corners() ? TileKind::corner : TileKind::wang, set.colors);
    for (TileIndex index = 0; index < tiles.size(); ++index) set.tiles.push_back({index, 0});
    write_whole_file(out, render_design_page(set));
    fmt::print("{}\n", out.string());
}

}

Command texture_design_command()
{
    const auto o = std::make_shared<TextureDesignOptions>();
    return {"design",
            "Write a page on which texture tiles are drawn by hand",
            {{"KIND", &o->kind, "corner or wang: tiles by the colours of their corners, or of their edges"},
             {"--colors", &o->colors, "The number of colours, C, from 2 to 4: there are C^4 tiles; default: 2", "C"},
             {"--size", &o->size, "The side of a tile, an even number from 32 to 128; default: 64", "PIXELS"},
             {"--out", &o->out, "The page (.html)", "PAGE", required}},
            texture_design_notes,
            action_on(o, design_texture)};
}

}
