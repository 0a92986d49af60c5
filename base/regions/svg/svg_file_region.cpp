// Drawings of SVG as regions: what their shapes go around, all together.
#include "base/errors/errors.hpp"
#include "base/regions/region_text.hpp"
#include "base/regions/svg/path_rings.hpp"
#include "base/regions/svg/svg_drawing.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

/// The longest side of the box around all shapes.
double longest_side(const std::vector<PathRings>& paths)
{
    RegionBox box = paths.front().box();
    for (const PathRings& path : paths)
        for (std::size_t k = 0; k < 2; ++k) {
            box.low[k] = std::min(box.low[k], path.box().low[k]);
            box.high[k] = std::max(box.high[k], path.box().high[k]);
        }
    return box.longest();
}

/// Calls `take` with each shape, its path and the tolerance for all of them.
template <class Take>
void for_each_path(const std::string& content, const std::string& name, const Take& take)
{
    const std::vector<SvgShape> shapes = read_svg_drawing(content, name);
    if (shapes.empty())
        throw InputError(name + ": has no shape: path, polygon, polyline, line, rect, circle or ellipse");
    std::vector<PathRings> paths(shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) paths[i].feed(shapes[i].outline);
    const double tolerance = usual_path_tolerance * longest_side(paths);
    for (std::size_t i = 0; i < shapes.size(); ++i) take(shapes[i], paths[i], tolerance);
}

}

PlaneRegion region_of_svg_drawing(const std::string& content, const std::string& name)
{
    PlaneRegion region;
    for_each_path(content, name, [&](const SvgShape& shape, const PathRings& path, double tolerance) {
        std::vector<RegionRing> rings = path.rings(tolerance, shape.place);
        if (rings.empty()) throw InputError(shape.place + ": goes around nothing");
        for (RegionPolygon& polygon : filled_region(std::move(rings), shape.is_even_odd, shape.place).polygons)
            region.polygons.push_back(std::move(polygon));
    });
    return region;
}

std::vector<RegionRing> lines_of_svg_drawing(const std::string& content, const std::string& name)
{
    std::vector<RegionRing> lines;
    for_each_path(content, name, [&](const SvgShape& shape, const PathRings& path, double tolerance) {
        for (RegionRing& line : path.lines(tolerance, shape.place)) lines.push_back(std::move(line));
    });
    return lines;
}

}
