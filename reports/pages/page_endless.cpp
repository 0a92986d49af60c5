#include "reports/pages/page_endless.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/text/noun.hpp"
#include "reports/layout/page_template.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/words/base64.hpp"
#include "reports/words/number_format.hpp"
#include "results/file_names.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace poissonlab {
namespace {

/// The scripts of the page, in the order in which they need each other; poisson_tiles.js comes before them.
constexpr std::array scripts{"webgl.js",      "endless_parts.js", "endless_density.js", "endless_canvas.js",
                             "endless_gl.js", "endless.js",       "endless_hands.js",   "plane_hands.js"};

std::string facts_of_set(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    return fmt::format("{} {} {} of {} {}{}.", format_count(p.tiles), kind_name(p), noun(p.tiles, "tile"),
                       format_count(p.points_per_tile), noun(p.points_per_tile, "point"), p.ranked ? ", ranked" : "");
}

/// The part of the page that is the same in a report and alone. `bytes`: of a tile set file, whose name is `name`.
PageData endless_view(std::string_view bytes, const std::string& name)
{
    const PoissonTileSet set = decode_tile_set(bytes, name);
    if (set.parameters.dimension != 2)
        throw InputError(fmt::format("{}: tiles in space: must be in the plane", printable(name)));
    PageData page;
    page.set("title", fmt::format("The endless tiling of {}", name));
    page.set("name", name);
    page.set("distance", fmt::format("{}", std::sqrt(static_cast<double>(set.squared_min_distance)) / 65536));
    page.set("facts", facts_of_set(set));
    page.set("tiles", base64_of(encode_tile_set(set))); // binary, also of JSON
    page.set("header", std::string(page_template_file("../runtime/poisson_tiles_gpu.h")));
    page.set("overview", false);
    return page;
}

}

std::string render_endless_page(std::string_view file, const std::string& name)
{
    PageData page = endless_view(file, name);
    page.set("style", std::string(page_template_file("templates/report.css")));
    PageData texts{PageData::type::list};
    texts << PageData(std::string(page_template_file("../runtime/poisson_tiles.js")));
    for (const std::string script : scripts) texts << PageData(std::string(page_template_file("templates/" + script)));
    page.set("scripts", texts);
    return render_template("endless", page);
}

std::string render_endless_page(const Site& site, const ReportSeries& series)
{
    PageData page = endless_view(read_whole_file(tile_set_of(series)), file_names::tile_set);
    page.set("title", "The endless tiling: " + series.label);
    page.set("overview", relative_link(series.pictures, site.out / overview_page));
    page.set("series_link", relative_link(series.pictures, page_of(series)));
    page.set("series_label", series.label);
    std::vector<std::string> names{"poisson_tiles.js"};
    names.insert(names.end(), scripts.begin(), scripts.end());
    return render_in_frame(site, {endless_page_of(series), "The endless tiling · " + series.label, names},
                           "endless_view", page);
}

}
