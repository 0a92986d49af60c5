#include "tiles/cells/cell_map.hpp"

#include "runtime/texture_tiles.h"
#include "tiles/packing/closed_packing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace poissonlab {
namespace {

/// The heaviest colour at a place, how much more it weighs than the next one, and how fast that grows per cell.
struct Heaviest
{
    std::size_t color = 0;
    double lead = 0, slope = 0;
};

/// Bilinear weights of colours at (x, y), 0 to 1, y going south.
Heaviest heaviest(const std::array<Color, 4>& from_north_west, std::size_t colors, double x, double y)
{
    const std::array<double, 4> weights{(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
    const std::array<double, 4> along_x{-(1 - y), 1 - y, -y, y}, along_y{-(1 - x), -x, 1 - x, x};
    std::array<double, most_cell_colors> sums{}, slopes_x{}, slopes_y{};
    for (std::size_t i = 0; i < 4; ++i) {
        sums[from_north_west[i]] += weights[i];
        slopes_x[from_north_west[i]] += along_x[i];
        slopes_y[from_north_west[i]] += along_y[i];
    }
    Heaviest found;
    for (std::size_t c = 1; c < colors; ++c)
        if (sums[c] > sums[found.color]) found.color = c;
    std::size_t next = found.color == 0 ? 1 : 0;
    for (std::size_t c = 0; c < colors; ++c)
        if (c != found.color && sums[c] > sums[next]) next = c;
    found.lead = sums[found.color] - sums[next];
    found.slope = std::hypot(slopes_x[found.color] - slopes_x[next], slopes_y[found.color] - slopes_y[next]);
    return found;
}

}

std::uint32_t CellAlphabet::weights() const
{
    std::uint32_t sum = 0;
    for (const CellCorner& corner : corners) sum += corner.weight;
    return sum;
}

std::vector<CellColor> ruled_cell(const CellAlphabet& alphabet, const CellRule& rule, const CornerTile& corners)
{
    const std::array<Color, 4> all{corners.north_west, corners.north_east, corners.south_west, corners.south_east};
    std::vector<CellColor> drawing;
    for (int row = 0; row < alphabet.size; ++row)
        for (int column = 0; column < alphabet.size; ++column) {
            const Heaviest there =
                heaviest(all, alphabet.corners.size(), (column + 0.5) / alphabet.size, (row + 0.5) / alphabet.size);
            const bool is_border = there.lead < rule.border_width / 2 * there.slope;
            drawing.push_back(is_border ? rule.border : alphabet.corners[there.color].color);
        }
    return drawing;
}

std::vector<CellColor> turned(const std::vector<CellColor>& drawing, int size)
{
    std::vector<CellColor> result(drawing.size());
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            result[static_cast<std::size_t>(column * size + size - 1 - row)] =
                drawing[static_cast<std::size_t>(row * size + column)];
    return result;
}

CornerTile turned(const CornerTile& corners)
{
    CornerTile result;
    result.north_east = corners.north_west;
    result.south_east = corners.north_east;
    result.south_west = corners.south_east;
    result.north_west = corners.south_west;
    return result;
}

namespace {

std::string hex_color(const CellColor& color)
{
    return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

std::string xml_text(const std::string& text)
{
    std::string result;
    for (const char letter : text) switch (letter) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += letter;
        }
    return result;
}

/// Terrains of Tiled: the colours of corners, and which a tile has, clockwise from the upper right one; edges have
/// none.
std::string corner_terrains(const CellAlphabet& alphabet)
{
    std::string xml =
        fmt::format("  <wangsets>\n   <wangset name=\"{}\" type=\"corner\" tile=\"-1\">\n", xml_text(alphabet.name));
    for (const CellCorner& corner : alphabet.corners)
        fmt::format_to(std::back_inserter(xml),
                       "    <wangcolor name=\"{}\" color=\"{}\" tile=\"-1\" probability=\"{}\"/>\n",
                       xml_text(corner.name), hex_color(corner.color), corner.weight);
    for (const TileIndex cell : packed_cells(alphabet.colors()).cells) {
        const CornerTile t = corner_tile(cell, alphabet.colors());
        fmt::format_to(std::back_inserter(xml), "    <wangtile tileid=\"{}\" wangid=\"0,{},0,{},0,{},0,{}\"/>\n",
                       cell_number(alphabet, cell), t.north_east + 1, t.south_east + 1, t.south_west + 1,
                       t.north_west + 1);
    }
    return xml + "   </wangset>\n  </wangsets>\n";
}

}

Color cell_corner(const CellAlphabet& alphabet, std::uint64_t seed, std::int64_t x, std::int64_t y)
{
    std::uint32_t left = ttiles_color(static_cast<std::uint32_t>(seed), alphabet.weights(),
                                      static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    Color color = 0;
    while (left >= alphabet.corners[color].weight) left -= alphabet.corners[color++].weight;
    return color;
}

CellMap cell_map(const CellAlphabet& alphabet, const TileWindow& window, std::uint64_t seed)
{
    CellMap map{window.width, window.height, {}};
    map.cells.reserve(window.width * window.height);
    for (std::uint64_t row = 0; row < window.height; ++row)
        for (std::uint64_t column = 0; column < window.width; ++column) {
            const auto corner = [&](std::uint64_t east, std::uint64_t north) {
                return cell_corner(alphabet, seed, window.x + static_cast<std::int64_t>(column + east),
                                   window.y + static_cast<std::int64_t>(window.height - 1 - row + north));
            };
            map.cells.push_back(
                corner_index({corner(1, 1), corner(1, 0), corner(0, 0), corner(0, 1)}, alphabet.colors()));
        }
    return map;
}

CellMap packed_cells(Color colors)
{
    const Color side = colors * colors;
    CellMap map{side, side, {}};
    for (Color row = 0; row < side; ++row)
        for (Color column = 0; column < side; ++column)
            map.cells.push_back(packed_tile(TileKind::corner, {column, side - 1 - row}, colors));
    return map;
}

void write_cell_map(const std::filesystem::path& file, const CellAlphabet& alphabet, const CellMap& map)
{
    const auto size = static_cast<std::size_t>(alphabet.size), row_bytes = map.columns * size * 3;
    std::vector<std::uint8_t> pixels(row_bytes * size);
    const auto rows = [&](int first, int) {
        const std::size_t cell_row = static_cast<std::size_t>(first) / size;
        for (std::size_t column = 0; column < map.columns; ++column) {
            const std::vector<CellColor>& cell = alphabet.cells[map.cells[cell_row * map.columns + column]];
            for (std::size_t i = 0; i < cell.size(); ++i)
                std::copy(cell[i].begin(), cell[i].end(),
                          &pixels[i / size * row_bytes + (column * size + i % size) * 3]);
        }
        return pixels.data();
    };
    PngLayout layout{static_cast<int>(map.columns * size), static_cast<int>(map.rows * size), 3};
    layout.rows_at_once = alphabet.size;
    write_png(file, layout, rows);
}

std::uint32_t cell_number(const CellAlphabet& alphabet, TileIndex cell)
{
    const Color side = alphabet.colors() * alphabet.colors();
    const PackingPlace place = place_of_tile(TileKind::corner, cell, alphabet.colors());
    return static_cast<std::uint32_t>((side - 1 - place.y) * side + place.x);
}

std::string cell_numbers(const CellAlphabet& alphabet, const CellMap& map, std::uint32_t first,
                         std::string_view row_end)
{
    std::string text;
    for (std::size_t i = 0; i < map.cells.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{}{}", first + cell_number(alphabet, map.cells[i]),
                       (i + 1) % map.columns == 0 ? row_end : ",");
    return text;
}

std::string tiled_map(const CellAlphabet& alphabet, const CellMap& map, const std::string& picture)
{
    const std::uint32_t side = alphabet.colors() * alphabet.colors();
    const int size = alphabet.size;
    std::string numbers = cell_numbers(alphabet, map, 1, ",\n"); // Tiled separates rows by commas as well
    numbers.erase(numbers.size() - 2, 1);
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<map version=\"1.10\" orientation=\"orthogonal\" "
                       "renderorder=\"right-down\" width=\"{}\" height=\"{}\" tilewidth=\"{}\" tileheight=\"{}\" "
                       "infinite=\"0\" nextlayerid=\"2\" nextobjectid=\"1\">\n",
                       map.columns, map.rows, size, size) +
           fmt::format(" <tileset firstgid=\"1\" name=\"{}\" tilewidth=\"{}\" tileheight=\"{}\" tilecount=\"{}\" "
                       "columns=\"{}\">\n  <image source=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                       xml_text(alphabet.name), size, size, side * side, side, xml_text(picture), side * size,
                       side * size) +
           corner_terrains(alphabet) +
           fmt::format(" </tileset>\n <layer id=\"1\" name=\"cells\" width=\"{}\" height=\"{}\">\n  <data "
                       "encoding=\"csv\">\n{}</data>\n </layer>\n</map>\n",
                       map.columns, map.rows, numbers);
}

}
