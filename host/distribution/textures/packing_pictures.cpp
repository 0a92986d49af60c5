#include "host/distribution/textures/packing_pictures.hpp"

#include "host/settings/distributions/texture_config.hpp"
#include "tiles/packing/closed_packing.hpp"
#include "tiles/packing/puzzle_piece.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// The colours of corners and edges: first those of Okabe and Ito, which everybody tells apart, then pale ones and dark
/// ones of these. All are light enough for black numbers.
constexpr std::array<const char*, most_drawn_colors> packed_colors{
    "#d55e00", "#f0e442", "#009e73", "#56b4e9", "#3d8fd1", "#cc79a7", "#e69f00", "#9a9a9a",
    "#f2b58c", "#fbf6c0", "#8fd6bf", "#c2e3f7", "#b8862f", "#ecc9dc", "#f7d998", "#dcdcdc"};
constexpr const char* lines = "#303030";
constexpr int packing_pixels = 1024;

/// A group for each colour, then one for lines.
MarkPicture colored_marks(double width, double height, Color colors)
{
    MarkPicture picture{width, height, packing_pixels};
    for (Color color = 0; color < colors; ++color) picture.groups.push_back({packed_colors[color]});
    picture.groups.push_back({lines});
    return picture;
}

void add_square(MarkPicture& picture, double x, double y, double width)
{
    for (const auto& ends : {std::array{x, y, x + 1, y}, std::array{x + 1, y, x + 1, y + 1},
                             std::array{x + 1, y + 1, x, y + 1}, std::array{x, y + 1, x, y}})
        picture.groups.back().strokes.push_back({ends[0], ends[1], ends[2], ends[3], width});
}

/// The number of a colour around a place.
void add_number(MarkPicture& picture, double x, double y, Color color)
{
    constexpr double size = 0.14;
    picture.words.push_back({{x, y - 0.36 * size}, size, std::to_string(color)});
}

/// Colours of edges inside of a tile: strokes beside its sides, which meet those of its neighbours.
void add_wang_tile(MarkPicture& picture, const WangTile& tile, double x, double y)
{
    constexpr double wide = 0.16, inset = 0.08, reach = 0.26;
    picture.groups[tile.south].strokes.push_back({x + reach, y + inset, x + 1 - reach, y + inset, wide});
    picture.groups[tile.north].strokes.push_back({x + reach, y + 1 - inset, x + 1 - reach, y + 1 - inset, wide});
    picture.groups[tile.west].strokes.push_back({x + inset, y + reach, x + inset, y + 1 - reach, wide});
    picture.groups[tile.east].strokes.push_back({x + 1 - inset, y + reach, x + 1 - inset, y + 1 - reach, wide});
    add_number(picture, x + 0.5, y + inset, tile.south);
    add_number(picture, x + 0.5, y + 1 - inset, tile.north);
    add_number(picture, x + inset, y + 0.5, tile.west);
    add_number(picture, x + 1 - inset, y + 0.5, tile.east);
}

/// The four edges that meet at a corner: arms from the middle of a square, which go on in the next one.
void add_corner(MarkPicture& picture, const WangTile& corner, double x, double y)
{
    constexpr double wide = 0.16;
    picture.groups[corner.south].strokes.push_back({x + 0.5, y + 0.08, x + 0.5, y + 0.42, wide});
    picture.groups[corner.north].strokes.push_back({x + 0.5, y + 0.58, x + 0.5, y + 0.92, wide});
    picture.groups[corner.west].strokes.push_back({x + 0.08, y + 0.5, x + 0.42, y + 0.5, wide});
    picture.groups[corner.east].strokes.push_back({x + 0.58, y + 0.5, x + 0.92, y + 0.5, wide});
    add_number(picture, x + 0.5, y + 0.25, corner.south);
    add_number(picture, x + 0.5, y + 0.75, corner.north);
    add_number(picture, x + 0.25, y + 0.5, corner.west);
    add_number(picture, x + 0.75, y + 0.5, corner.east);
}

void add_domino(MarkPicture& picture, Color west, Color east, double x, double y)
{
    constexpr double wide = 0.3;
    picture.groups[west].strokes.push_back({x + wide / 2, y + 0.2, x + wide / 2, y + 0.8, wide});
    picture.groups[east].strokes.push_back({x + 1 - wide / 2, y + 0.2, x + 1 - wide / 2, y + 0.8, wide});
    add_number(picture, x + wide / 2, y + 0.5, west);
    add_number(picture, x + 1 - wide / 2, y + 0.5, east);
    add_square(picture, x, y, 0.02);
}

/// A circle of small strokes.
void add_loop(MarkPicture& picture, double x, double y, double radius, double width)
{
    constexpr int pieces = 48;
    const auto at = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / pieces;
        return std::array{x + radius * std::cos(angle), y + radius * std::sin(angle)};
    };
    for (int i = 0; i < pieces; ++i)
        picture.groups.back().strokes.push_back({at(i)[0], at(i)[1], at(i + 1)[0], at(i + 1)[1], width});
}

/// A stroke from one vertex to another, bent to its right so that the way back lies beside it, with a head.
void add_arrow(MarkPicture& picture, std::array<double, 2> from, std::array<double, 2> to, double vertex)
{
    const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
    const double right = 0.07 / length, east = dx / length, north = dy / length;
    const std::array start{from[0] + dy * right + east * vertex, from[1] - dx * right + north * vertex},
        end{to[0] + dy * right - east * vertex, to[1] - dx * right - north * vertex};
    auto& strokes = picture.groups.back().strokes;
    strokes.push_back({start[0], start[1], end[0], end[1], 0.02});
    for (const double turn : {2.7, -2.7}) {
        const double c = std::cos(turn), s = std::sin(turn);
        strokes.push_back(
            {end[0], end[1], end[0] + 0.14 * (c * east - s * north), end[1] + 0.14 * (s * east + c * north), 0.02});
    }
}

}

MarkPicture drawn_corner_packing(const TilePacking& packing)
{
    constexpr double margin = 0.3;
    const double side = packing.side();
    MarkPicture picture = colored_marks(side + 2 * margin, side + 2 * margin, packing.colors);
    for (Color row = 0; row < packing.side(); ++row)
        for (Color column = 0; column < packing.side(); ++column) {
            add_square(picture, column + margin, row + margin, 0.02);
            add_corner(picture, wang_tile(packing.at({column, row}), {packing.colors, packing.colors}), column + margin,
                       row + margin);
        }
    return picture;
}

MarkPicture drawn_packing(const TilePacking& packing)
{
    const double side = packing.side();
    constexpr double margin = 0.3;
    MarkPicture picture = colored_marks(side + 2 * margin, side + 2 * margin, packing.colors);
    for (Color row = 0; row < packing.side(); ++row)
        for (Color column = 0; column < packing.side(); ++column) {
            const TileIndex index = packing.at({column, row});
            const double x = column + margin, y = row + margin;
            add_square(picture, x, y, 0.02);
            picture.words.push_back({{x + 0.5, y + 0.5}, 0.3, std::to_string(index)});
            if (packing.kind == TileKind::wang)
                add_wang_tile(picture, wang_tile(index, {packing.colors, packing.colors}), x, y);
        }
    if (packing.kind == TileKind::corner) {
        const std::vector<Color> corners = corner_colors_of(packing);
        std::rotate(picture.groups.begin(), picture.groups.end() - 1, picture.groups.end()); // disks lie over lines
        for (Color row = 0; row <= packing.side(); ++row)
            for (Color column = 0; column <= packing.side(); ++column) {
                const Color color = corners[row % packing.side() * packing.side() + column % packing.side()];
                picture.groups[1 + color].disks.push_back({column + margin, row + margin, 0.2});
                add_number(picture, column + margin, row + margin, color);
            }
    }
    return picture;
}

MarkPicture drawn_puzzle(const TilePacking& packing)
{
    const double side = packing.side();
    constexpr double margin = 0.4;
    MarkPicture picture{side + 2 * margin, side + 2 * margin, packing_pixels};
    picture.groups.push_back({lines});
    for (Color row = 0; row < packing.side(); ++row)
        for (Color column = 0; column < packing.side(); ++column) {
            const auto outline = piece_outline(packing.kind, packing.at({column, row}), packing.colors);
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const PiecePoint a = outline[i], b = outline[(i + 1) % outline.size()];
                picture.groups.back().strokes.push_back(
                    {column + margin + a[0], row + margin + a[1], column + margin + b[0], row + margin + b[1], 0.025});
            }
        }
    return picture;
}

MarkPicture drawn_dominoes(Color colors, bool is_packed)
{
    const Color count = colors * colors;
    const double pitch = is_packed ? 1 : 1.3;
    const Color in_row = is_packed ? count : colors;
    const double rows = is_packed ? 1 : colors;
    const double gap = pitch - 1;
    MarkPicture picture = colored_marks(in_row * pitch - gap + 0.4, rows * pitch - gap + 0.4, colors);
    for (Color i = 0; i < count; ++i) {
        const Color west = is_packed ? wei_color(i) : i / colors,
                    east = is_packed ? wei_color((i + 1) % count) : i % colors;
        add_domino(picture, west, east, 0.2 + (i % in_row) * pitch, 0.2 + (rows - 1 - i / in_row) * pitch);
    }
    return picture;
}

MarkPicture drawn_graph(Color colors)
{
    constexpr double middle = 2, around = 1.1, vertex = 0.18, loop = 0.2;
    MarkPicture picture = colored_marks(2 * middle, 2 * middle, colors);
    std::vector<std::array<double, 2>> places;
    for (Color color = 0; color < colors; ++color) {
        const double angle = 2 * std::numbers::pi * (0.25 + static_cast<double>(color) / colors);
        places.push_back({middle + around * std::cos(angle), middle + around * std::sin(angle)});
        picture.groups[color].disks.push_back({places.back()[0], places.back()[1], vertex});
        add_number(picture, places.back()[0], places.back()[1], color);
        const double out = (around + vertex + loop) / around;
        add_loop(picture, middle + (places.back()[0] - middle) * out, middle + (places.back()[1] - middle) * out, loop,
                 0.02);
    }
    for (Color from = 0; from < colors; ++from)
        for (Color to = 0; to < colors; ++to)
            if (from != to) add_arrow(picture, places[from], places[to], vertex);
    return picture;
}

}
