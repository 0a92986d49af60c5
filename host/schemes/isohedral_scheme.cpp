// kind = "isohedral": a tiling of a type with its parameters, its curves and a colouring.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II, section 7).
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

using OutlineAndColor = std::pair<std::vector<PlanePoint>, std::string>;

/// The picture of a window; `parts_of(place)` has the parts of the tile at a place.
template <class PartsOf>
MarkPicture tiling_picture(const IsohedralTile& tile, const IsohedralSettings& settings, const PartsOf& parts_of)
{
    constexpr double pixels_a_tile = 48;
    const double side = std::sqrt(area_of(tile.outline()));
    MarkCanvas canvas(settings.columns, settings.rows, pixels_a_tile);
    const double x = settings.columns / 2 * side, y = settings.rows / 2 * side;
    for (const TilePlace& place : tile.tiles_near({-x, -y}, {x, y})) {
        const PlaneMotion motion = tile.motion(place);
        for (const auto& [outline, color] : parts_of(place)) {
            std::vector<MarkPoint> corners;
            for (const PlanePoint& point : outline) {
                const PlanePoint moved = motion(point);
                corners.push_back({moved[0] / side + settings.columns / 2, moved[1] / side + settings.rows / 2});
            }
            canvas.polygon(color, corners);
            canvas.outline("#000000", corners, 0.04);
        }
    }
    return canvas.picture();
}

/// Tiles that a path divides: of light and dark parts.
MarkPicture split_picture(const IsohedralTile& tile, const IsohedralSettings& settings, DistributionResult& result)
{
    const SplitTile split = split_tile(tile, *settings.split);
    const double whole = area_of(tile.outline());
    result.numbers.push_back({"edges_alike", "Edges between tiles of one shape", static_cast<double>(split.alike),
                              "of all aspects, from both sides; 0: a Heaven and Hell pattern"});
    result.numbers.push_back({"light_share", "Share of light tiles", area_of(split.parts[0]) / whole, "of the plane"});
    result.facts.emplace_back(split.alike == 0
                                  ? "a Heaven and Hell pattern: only tiles of different shapes have edges in common"
                                  : "some tiles of one shape have an edge in common");
    const std::vector<OutlineAndColor> parts{{split.parts[0], "#f6efdc"}, {split.parts[1], "#2f4a6d"}};
    return tiling_picture(
        tile, settings, [&](const TilePlace&) -> const auto& { return parts; });
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
                                type.shape.parameters(), type.shape.curve_shapes.size())};
    if (!settings.split) { // parts have colours of their own
        result.facts.emplace_back(is_proper(tile, coloring) ? "neighbours differ in colour"
                                                            : "some neighbours have the same colour");
        result.facts.emplace_back(is_perfect(tile, coloring) ? "a perfect colouring: symmetries permute colours"
                                                             : "not a perfect colouring");
    }
    if (type.is_marked)
        result.facts.emplace_back("its tiles need markings: without them this is a tiling of another type");
    const auto& t = tile.translations();
    const double unit = std::abs(t[0][0] * t[1][1] - t[0][1] * t[1][0]);
    result.numbers = {{"colors", "Colours", settings.split ? 2.0 : coloring.colors, ""},
                      {"unit_over_tiles", "Area of a translational unit over its tiles",
                       unit / (static_cast<double>(tile.aspects().size()) * area_of(tile.outline())),
                       "1: tiles fill the plane once"}};
    const MarkPicture picture =
        settings.split ? split_picture(tile, settings, result)
                       : tiling_picture(tile, settings, [&](const TilePlace& place) {
                             return std::array{OutlineAndColor{tile.outline(), tile_color(coloring.of(place))}};
                         });
    files.add_marks("tiling.json", picture,
                    fmt::format("{} x {} sides of a square as large as the tile.", settings.columns, settings.rows),
                    result);
    return result;
}

}
