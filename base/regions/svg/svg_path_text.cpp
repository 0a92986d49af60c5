// The data of a path of SVG as a region.
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/region_text.hpp"
#include "base/regions/svg/path_rings.hpp"

#include <2geom/svg-path-parser.h>
#include <fmt/format.h>

namespace poissonlab {
namespace {

/// The words before the path's data.
struct PathOptions
{
    bool is_even_odd = false;
    double tolerance = 0; ///< 0: the usual one
    std::string data;
};

PathOptions path_options(const std::string& text, const std::string& name)
{
    PathOptions options;
    WordReader words(text);
    words.next();
    bool has_data = words.next();
    for (; has_data; has_data = words.next()) {
        if (words.word() == "evenodd" || words.word() == "nonzero") {
            options.is_even_odd = words.word() == "evenodd";
        } else if (words.word() == "tolerance") {
            if (!words.next() || !parse_number(words.word(), options.tolerance) || !(options.tolerance > 0))
                throw InputError(name + ": tolerance: must be followed by a number above 0");
        } else {
            break;
        }
    }
    if (has_data) options.data = text.substr(static_cast<std::size_t>(words.word().data() - text.data()));
    return options;
}

/// Parses the data, and chooses a tolerance where there is none.
PathRings parsed_path(PathOptions& options, const std::string& name)
{
    PathRings path;
    try {
        Geom::parse_svg_path(options.data.c_str(), path);
    } catch (const std::exception& error) {
        throw InputError(fmt::format("{}: is not a path of SVG: {}", name, printable(error.what())));
    }
    if (!(options.tolerance > 0)) options.tolerance = usual_path_tolerance * path.box().longest();
    return path;
}

}

std::vector<RegionRing> lines_of_svg_path(const std::string& text, const std::string& name)
{
    PathOptions options = path_options(text, name);
    const PathRings path = parsed_path(options, name);
    return path.lines(options.tolerance, name);
}

PlaneRegion region_of_svg_path(const std::string& text, const std::string& name)
{
    PathOptions options = path_options(text, name);
    const PathRings path = parsed_path(options, name);
    std::vector<RegionRing> rings = path.rings(options.tolerance, name);
    if (rings.empty()) throw InputError(name + ": has no closed path: must be path M... of SVG, with an area");
    return filled_region(std::move(rings), options.is_even_odd, name);
}

}
