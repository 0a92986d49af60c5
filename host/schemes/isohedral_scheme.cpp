// kind = "isohedral": a tiling of a type with its parameters, its curves and a colouring.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II, section 7).
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_run.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

MarkPicture tiling_picture(const IsohedralTile& tile, const TileColoring& coloring, double columns, double rows)
{
    constexpr double pixels_a_tile = 48;
    const double side = std::sqrt(area_of(tile.outline()));
    MarkCanvas canvas(columns, rows, pixels_a_tile);
    const double x = columns / 2 * side, y = rows / 2 * side;
    for (const TilePlace& place : tile.tiles_near({-x, -y}, {x, y})) {
        const PlaneMotion motion = tile.motion(place);
        std::vector<MarkPoint> corners;
        for (const PlanePoint& point : tile.outline()) {
            const PlanePoint moved = motion(point);
            corners.push_back({moved[0] / side + columns / 2, moved[1] / side + rows / 2});
        }
        canvas.polygon(tile_color(coloring.of(place)), corners);
        canvas.outline("#000000", corners, 0.04);
    }
    return canvas.picture();
}

}

DistributionResult make_isohedral(const IsohedralSettings& settings, std::uint64_t seed, DistributionFiles& files)
{
    const IsohedralType& type = isohedral_types()[static_cast<std::size_t>(settings.type - 1)];
    const IsohedralTile tile = tile_of(settings, seed);
    const TileColoring coloring = settings.coloring ? *settings.coloring : proper_coloring(tile);
    DistributionResult result;
    result.facts = {fmt::format("IH{}: {}", type.number, type.symbol), fmt::format("topology {}", type.topology),
                    fmt::format("{} aspects, {} parameters, {} curves", type.shape.aspects.size(),
                                type.shape.parameters(), type.shape.curve_shapes.size()),
                    is_proper(tile, coloring) ? "neighbours differ in colour" : "some neighbours have the same colour",
                    is_perfect(tile, coloring) ? "a perfect colouring: symmetries permute colours"
                                               : "not a perfect colouring"};
    if (type.is_marked)
        result.facts.emplace_back("its tiles need markings: without them this is a tiling of another type");
    const auto& t = tile.translations();
    const double unit = std::abs(t[0][0] * t[1][1] - t[0][1] * t[1][0]);
    result.numbers = {{"colors", "Colours", static_cast<double>(coloring.colors), ""},
                      {"unit_over_tiles", "Area of a translational unit over its tiles",
                       unit / (static_cast<double>(tile.aspects().size()) * area_of(tile.outline())),
                       "1: tiles fill the plane once"}};
    files.add_marks("tiling.json", tiling_picture(tile, coloring, settings.columns, settings.rows),
                    fmt::format("{} x {} sides of a square as large as the tile.", settings.columns, settings.rows),
                    result);
    return result;
}

}
