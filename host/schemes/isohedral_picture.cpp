#include "host/schemes/isohedral_picture.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {

std::string TilingWindow::caption() const
{
    return fmt::format("{} x {} sides of a square as large as the tile.", columns, rows);
}

TilingWindow window_of(const IsohedralSettings& settings) { return {settings.columns, settings.rows}; }

MarkPoint in_window(const TilingWindow& window, const IsohedralTile& tile, const PlanePoint& place)
{
    const double side = std::sqrt(area_of(tile.outline()));
    const auto& [c, s] = window.right;
    return {(c * place[0] + s * place[1]) / side + window.columns / 2,
            (c * place[1] - s * place[0]) / side + window.rows / 2};
}

MarkPicture tiling_picture(const IsohedralTile& tile, const TilingWindow& window,
                           const std::function<TileParts(const TilePlace& place)>& parts_of)
{
    constexpr double pixels_a_tile = 48;
    MarkCanvas canvas(window.columns, window.rows, pixels_a_tile);
    // The box around the window, which may be turned.
    const double half = std::sqrt(area_of(tile.outline())) / 2, c = std::abs(window.right[0]),
                 s = std::abs(window.right[1]);
    const double x = half * (c * window.columns + s * window.rows), y = half * (s * window.columns + c * window.rows);
    for (const TilePlace& place : tile.tiles_near({-x, -y}, {x, y})) {
        const PlaneMotion motion = tile.motion(place);
        for (const auto& [outline, color] : parts_of(place)) {
            std::vector<MarkPoint> corners;
            for (const PlanePoint& point : outline) corners.push_back(in_window(window, tile, motion(point)));
            canvas.polygon(color, corners);
            canvas.outline("#000000", corners, 0.04);
        }
    }
    return canvas.picture();
}

void describe(const IsohedralType& type, const IsohedralTile& tile, DistributionResult& result)
{
    result.facts = {fmt::format("IH{}: {}", type.number, type.symbol), fmt::format("topology {}", type.topology),
                    fmt::format("{} aspects, {} parameters, {} curves", type.shape.aspects.size(),
                                type.shape.parameters(), type.shape.curve_shapes.size())};
    if (type.is_marked)
        result.facts.emplace_back("its tiles need markings: without them this is a tiling of another type");
    const auto& t = tile.translations();
    const double unit = std::abs(t[0][0] * t[1][1] - t[0][1] * t[1][0]);
    result.numbers = {{"unit_over_tiles", "Area of a translational unit over its tiles",
                       unit / (static_cast<double>(tile.aspects().size()) * area_of(tile.outline())),
                       "1: tiles fill the plane once"}};
}

}
