#include "reports/tile_image.hpp"

#include "errors/errors.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr int tile_size = 32;
constexpr int gap_size = 8;
constexpr int disk_radius = 11;

void check_count(std::uint64_t tiles)
{
    if (tiles > max_drawn_tiles)
        throw InputError(
            fmt::format("a picture of {} tiles: at most {} can be drawn", tiles, max_drawn_tiles));
}

/// One channel of a saturated colour; `turns` around the colour circle.
int channel(double turns)
{
    const double distance = std::abs(turns - std::floor(turns) - 0.5) * 6; // 3 at the channel's own hue
    return static_cast<int>(std::lround(255 * std::min(1.0, std::max(0.0, distance - 1))));
}

/// Four triangles that meet in the middle; (x, y) is the tile's upper left.
void draw_wang_tile(std::string& svg, const WangTile& tile, int x, int y)
{
    constexpr int s = tile_size;
    constexpr int h = tile_size / 2;
    const auto triangle = [&](Color color, int x0, int y0, int dx, int dy) {
        fmt::format_to(std::back_inserter(svg), "<path fill=\"{}\" d=\"M{} {}l{} {}L{} {}z\"/>\n",
                       tile_color(color), x0, y0, dx, dy, x + h, y + h);
    };
    triangle(tile.north, x, y, s, 0);
    triangle(tile.east, x + s, y, 0, s);
    triangle(tile.south, x + s, y + s, -s, 0);
    triangle(tile.west, x, y + s, 0, -s);
}

/// A quarter of a disk around each corner; (x, y) is the tile's upper left.
void draw_corner_tile(std::string& svg, const CornerTile& tile, int x, int y)
{
    constexpr int s = tile_size;
    constexpr int r = disk_radius;
    // From the corner along one side, on a clockwise arc to the other.
    const auto quarter = [&](Color color, int x0, int y0, int dx, int dy) {
        fmt::format_to(std::back_inserter(svg), "<path fill=\"{}\" d=\"M{} {}l{} {}a{} {} 0 0 1 {} {}z\"/>\n",
                       tile_color(color), x0, y0, dx * r, dy * r, r, r, (-dx - dy) * r, (dx - dy) * r);
    };
    quarter(tile.north_east, x + s, y, 0, 1);
    quarter(tile.south_east, x + s, y + s, -1, 0);
    quarter(tile.south_west, x, y + s, 0, -1);
    quarter(tile.north_west, x, y, 1, 0);
}

}

std::string tile_color(Color color)
{
    static const std::array<std::string, 8> known{"#ff0000", "#ffff00", "#00ff00", "#00ffff",
                                                  "#0000ff", "#ff00ff", "#ff8000", "#808080"};
    if (color < known.size()) return known[color];
    const double turns = color * 0.6180339887498949; // golden section: far from those before
    return fmt::format("#{:02x}{:02x}{:02x}", channel(turns), channel(turns - 1.0 / 3),
                       channel(turns - 2.0 / 3));
}

TileGrid tile_set_grid(const TileSet& tiles, std::size_t columns)
{
    check_count(tiles.size());
    const auto nearly_square =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(tiles.size()))));
    TileGrid grid{tiles.kind(), tiles.colors(), columns > 0 ? columns : nearly_square, {}, true};
    for (std::uint64_t position = 0; position < tiles.size(); ++position)
        grid.tiles.push_back(tiles.index(position));
    return grid;
}

TileGrid tiling_grid(const Tiling& tiling, const TileWindow& window)
{
    check_count(std::max(window.width, window.height));
    check_count(window.width * window.height);
    TileGrid grid{tiling.tile_set().kind(), tiling.tile_set().colors(), window.width, {}, false};
    tiling.stream(window, [&](auto, auto, std::span<const TileIndex> tiles) {
        grid.tiles.insert(grid.tiles.end(), tiles.begin(), tiles.end());
    });
    return grid;
}

std::string tiles_svg(const TileGrid& grid)
{
    if (grid.kind != TileKind::wang && grid.kind != TileKind::corner)
        throw std::logic_error("only Wang and corner tiles are drawn");
    const int pitch = tile_size + (grid.has_gaps ? gap_size : 0);
    const auto columns = static_cast<int>(grid.columns);
    const auto count = static_cast<int>(grid.tiles.size());
    const int rows = columns > 0 ? (count + columns - 1) / columns : 0;
    const int margin = gap_size;
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\">\n",
                                  2 * margin + columns * pitch - (pitch - tile_size),
                                  2 * margin + rows * pitch - (pitch - tile_size));
    std::string borders;
    for (int i = 0; i < count; ++i) {
        const int x = margin + i % columns * pitch;
        const int y = margin + i / columns * pitch;
        const TileIndex index = grid.tiles[static_cast<std::size_t>(i)];
        if (grid.kind == TileKind::wang)
            draw_wang_tile(svg, wang_tile(index, grid.colors), x, y);
        else
            draw_corner_tile(svg, corner_tile(index, grid.colors.horizontal), x, y);
        fmt::format_to(std::back_inserter(borders), "M{} {}h{}v{}h-{}z", x, y, tile_size, tile_size,
                       tile_size);
    }
    return svg + "<path fill=\"none\" stroke=\"#000\" d=\"" + borders + "\"/>\n</svg>\n";
}

}
