#include "reports/engine/monotile_page.hpp"

#include "base/text/noun.hpp"
#include "reports/layout/page_template.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/words/base64.hpp"
#include "tiles/poisson/monotile_points_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace poissonlab {

std::string render_monotile_page(std::string_view file, const std::string& name,
                                 const std::vector<std::array<std::int64_t, 4>>& outline)
{
    const MonotilePointsFile set(std::string(file), name);
    const std::uint32_t points = set.set().points_per_tile;
    std::vector<std::string> corners;
    for (const auto& corner : outline) corners.push_back(fmt::format("{}", fmt::join(corner, ",")));
    PageData page;
    page.set("title", fmt::format("The endless tiling of {}", name));
    page.set("name", name);
    page.set("facts",
             fmt::format("One tile, the {}, that never repeats, with {} {} in each, ranked. Dark tiles are {}.",
                         set.tiling(), points, noun(points, "point"),
                         set.tiling() == "hat" ? "reflected" : "turned by an odd number of twelfths"));
    page.set("place_words", set.tiling() == "hat" ? "x in edges, y in steps of √3" : "in edges");
    page.set("outline", fmt::format("{}", fmt::join(corners, ";")));
    page.set("tiles", base64_of(set.bytes()));
    page.set("style", std::string(page_template_file("templates/report.css")));
    PageData texts{PageData::type::list};
    texts << PageData(std::string(page_template_file("../runtime/monotile_points.js")));
    for (const char* script : {"webgl.js", "endless_parts.js", "endless_density.js", "endless_canvas.js",
                               "monotile_page.js", "plane_hands.js"})
        texts << PageData(std::string(page_template_file("templates/" + std::string(script))));
    page.set("scripts", texts);
    return render_template("monotile_page", page);
}

}
