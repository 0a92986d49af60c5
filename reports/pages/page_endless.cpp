#include "reports/pages/page_endless.hpp"

#include "base/errors/errors.hpp"
#include "reports/layout/page_template.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/words/number_format.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

std::string base64_of(std::string_view bytes)
{
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::string_view three = bytes.substr(i, 3);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < three.size() ? static_cast<unsigned char>(three[k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= three.size() ? digits[word >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

std::string facts_of_set(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    return fmt::format("{} {} tiles of {} points{}.", format_count(p.tiles), kind_name(p),
                       format_count(p.points_per_tile), p.ranked ? ", ranked" : "");
}

}

std::string render_endless_page(std::string_view file, const std::string& name)
{
    const PoissonTileSet set = decode_tile_set(file, name);
    if (set.parameters.dimension != 2)
        throw InputError(fmt::format("{}: tiles in space: must be in the plane", printable(name)));
    const std::string bytes = encode_tile_set(set); // binary, also of JSON
    const double distance = std::sqrt(static_cast<double>(set.squared_min_distance)) / 65536;
    PageData page;
    page.set("title", fmt::format("The endless tiling of {}", name));
    page.set("name", name);
    page.set("distance", fmt::format("{}", distance));
    page.set("facts", facts_of_set(set));
    page.set("style", std::string(page_template_file("templates/report.css")));
    page.set("tiles", base64_of(bytes));
    page.set("runtime", std::string(page_template_file("../runtime/poisson_tiles.js")));
    page.set("parts", std::string(page_template_file("templates/endless_parts.js")));
    page.set("script", std::string(page_template_file("templates/endless.js")));
    return render_template("endless", page);
}

}
