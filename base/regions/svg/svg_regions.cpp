// Drawings and paths of SVG as regions: what their shapes go around, all together.
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/points/point_file.hpp"
#include "base/programs/loaded_module.hpp"
#include "base/regions/region_raster.hpp"
#include "base/regions/region_text.hpp"
#include "base/regions/svg/svg_shapes.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

/// The usual tolerance is this part of the longest side of the box around ends, control points and arcs.
constexpr double usual_path_tolerance = 1e-4;

const DrawingFunctions& drawings()
{
    static const DrawingFunctions* const loaded = reinterpret_cast<DrawingFunctionsFunction>(
        function_of_module("poissonlab_drawings", drawing_functions_function, "drawings of SVG need lib2geom"))();
    return *loaded;
}

/// The number of times that each ring goes round a place just inside it, and just outside. Rings do not cross.
struct RingWinding
{
    int outside = 0, inside = 0;
};

std::vector<RingWinding> windings_of(const std::vector<RegionRing>& rings)
{
    std::vector<RingWinding> windings(rings.size());
    std::vector<RegionBox> boxes; // a drawing may have thousands of rings, most of them far from each other
    for (const RegionRing& ring : rings) boxes.push_back(box_of({{{ring}}}));
    const auto is_in_box = [&](std::size_t j, const std::array<double, 2>& place) {
        return boxes[j].low[0] <= place[0] && place[0] <= boxes[j].high[0] && boxes[j].low[1] <= place[1] &&
               place[1] <= boxes[j].high[1];
    };
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const std::array<double, 2> middle{(rings[i][0][0] + rings[i][1][0]) / 2,
                                           (rings[i][0][1] + rings[i][1][1]) / 2};
        for (std::size_t j = 0; j < rings.size(); ++j)
            if (j != i && is_in_box(j, middle) && encloses(rings[j], middle))
                windings[i].outside += signed_area_of(rings[j]) > 0 ? 1 : -1;
        windings[i].inside = windings[i].outside + (signed_area_of(rings[i]) > 0 ? 1 : -1);
    }
    return windings;
}

/// The rings between what is filled and what is not, outlines to the left and holes to the right.
std::vector<RegionRing> filled_rings(std::vector<RegionRing> rings, bool is_even_odd)
{
    const std::vector<RingWinding> windings = windings_of(rings);
    const auto is_filled = [&](int winding) { return is_even_odd ? winding % 2 != 0 : winding != 0; };
    std::vector<RegionRing> kept;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const bool is_outline = is_filled(windings[i].inside);
        if (is_outline == is_filled(windings[i].outside)) continue;
        if ((signed_area_of(rings[i]) > 0) != is_outline) std::ranges::reverse(rings[i]);
        kept.push_back(std::move(rings[i]));
    }
    return kept;
}

/// The rings that closed lines of a shape go around; open paths are closed.
std::vector<RegionRing> rings_of(const SvgShape& shape, double tolerance)
{
    std::vector<RegionRing> rings = shape.lines(tolerance);
    for (RegionRing& ring : rings)
        while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    std::erase_if(rings, [](const RegionRing& ring) { return ring.size() < 3; });
    return rings;
}

/// The region of rings by a rule of filling. Throws InputError, which begins with the name, where there is none, and
/// where rings cross themselves or each other.
PlaneRegion filled_region(std::vector<RegionRing> rings, bool is_even_odd, const std::string& name)
{
    // Lines that cross, and coordinates that are no numbers, are said as of other regions.
    for (const RegionRing& ring : rings) check_region({{{ring}}}, name);
    check_rings(rings, name);
    return region_of_rings(filled_rings(std::move(rings), is_even_odd));
}

/// The longest side of the box around all shapes.
double longest_side(const std::vector<SvgShape>& shapes)
{
    RegionBox box = shapes.front().box;
    for (const SvgShape& shape : shapes)
        for (std::size_t k = 0; k < 2; ++k) {
            box.low[k] = std::min(box.low[k], shape.box.low[k]);
            box.high[k] = std::max(box.high[k], shape.box.high[k]);
        }
    return box.longest();
}

/// The shapes of a drawing, at least one, and the tolerance for all of them.
std::pair<std::vector<SvgShape>, double> shapes_of(const std::string& content, const std::string& name)
{
    std::vector<SvgShape> shapes = drawings().drawing(content, name);
    if (shapes.empty())
        throw InputError(name + ": has no shape: path, polygon, polyline, line, rect, circle or ellipse");
    const double tolerance = usual_path_tolerance * longest_side(shapes);
    return {std::move(shapes), tolerance};
}

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
SvgShape parsed_path(PathOptions& options, const std::string& name)
{
    SvgShape path = drawings().path(options.data, name);
    if (!(options.tolerance > 0)) options.tolerance = usual_path_tolerance * path.box.longest();
    return path;
}

}

PlaneRegion region_of_svg_drawing(const std::string& content, const std::string& name)
{
    PlaneRegion region;
    const auto [shapes, tolerance] = shapes_of(content, name);
    for (const SvgShape& shape : shapes) {
        std::vector<RegionRing> rings = rings_of(shape, tolerance);
        if (rings.empty()) throw InputError(shape.place + ": goes around nothing");
        for (RegionPolygon& polygon : filled_region(std::move(rings), shape.is_even_odd, shape.place).polygons)
            region.polygons.push_back(std::move(polygon));
    }
    return region;
}

std::vector<RegionRing> lines_of_svg_drawing(const std::string& content, const std::string& name)
{
    std::vector<RegionRing> lines;
    const auto [shapes, tolerance] = shapes_of(content, name);
    for (const SvgShape& shape : shapes)
        for (RegionRing& line : shape.lines(tolerance)) lines.push_back(std::move(line));
    return lines;
}

std::vector<RegionRing> lines_of_svg_path(const std::string& text, const std::string& name)
{
    PathOptions options = path_options(text, name);
    const SvgShape path = parsed_path(options, name);
    return path.lines(options.tolerance);
}

PlaneRegion region_of_svg_path(const std::string& text, const std::string& name)
{
    PathOptions options = path_options(text, name);
    const SvgShape path = parsed_path(options, name);
    std::vector<RegionRing> rings = rings_of(path, options.tolerance);
    if (rings.empty()) throw InputError(name + ": has no closed path: must be path M... of SVG, with an area");
    return filled_region(std::move(rings), options.is_even_odd, name);
}

}
