#include "reports/engine/recursive_page.hpp"

#include "reports/layout/page_template.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/words/base64.hpp"
#include "tiles/tilings/even_wang_tiles.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

/// The tiles by the bits of their north, east, south and west colours; those whose sum is odd are none.
std::string tiles_by_colors()
{
    std::string tiles;
    for (Color bits = 0; bits < 16; ++bits) {
        const WangTile colors{bits >> 3, bits >> 2 & 1, bits >> 1 & 1, bits & 1};
        const bool is_even = (colors.north + colors.east + colors.south + colors.west) % 2 == 0;
        tiles += is_even ? static_cast<char>('0' + even_wang_tile(colors)) : '-';
    }
    return tiles;
}

}

std::string render_recursive_page(const RecursiveTileSet& tiles, const RecursivePage& page)
{
    PageData data;
    data.set("title", "Recursive Wang tiles: zoom for ever");
    data.set("style", std::string(page_template_file("templates/report.css")));
    data.set("seed", std::to_string(page.seed));
    data.set("place", page.place);
    data.set("command", page.command);
    data.set("stamp_size", fmt::format("{}", page.stamp_size));
    data.set("turned", page.is_turned ? "1" : "0");
    data.set("colors", tiles_by_colors());
    data.set("tiles", base64_of(recursive_tile_bytes(tiles)));
    PageData stamps{PageData::type::list};
    for (const std::string& stamp : page.stamps) stamps << PageData(base64_of(stamp));
    data.set("stamps", stamps);
    PageData texts{PageData::type::list};
    texts << PageData(std::string(page_template_file("../runtime/poisson_tiles.js")));
    for (const char* script : {"webgl.js", "endless_canvas.js", "endless_density.js", "recursive_tiles.js",
                               "recursive_gl.js", "recursive_page.js", "recursive_hands.js", "plane_hands.js"})
        texts << PageData(std::string(page_template_file("templates/" + std::string(script))));
    data.set("scripts", texts);
    return render_template("recursive", data);
}

}
