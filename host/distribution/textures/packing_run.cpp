// A table [[packing]]: all tiles of a set on a torus with their numbers, puzzles of them, and the graph of a row
// (Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.5 and figures 5.7 to 5.13).
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/textures/chosen_packing.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/distributions/texture_config.hpp"
#include "tiles/packing/closed_packing.hpp"
#include "tiles/packing/packings.hpp"
#include "tiles/packing/puzzle_piece.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
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

/// Pieces with lines between them, each tile's number where a picture would be.
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

void add_domino(MarkPicture& picture, Color west, Color east, double x, double y)
{
    constexpr double wide = 0.3;
    picture.groups[west].strokes.push_back({x + wide / 2, y + 0.2, x + wide / 2, y + 0.8, wide});
    picture.groups[east].strokes.push_back({x + 1 - wide / 2, y + 0.2, x + 1 - wide / 2, y + 0.8, wide});
    add_number(picture, x + wide / 2, y + 0.5, west);
    add_number(picture, x + 1 - wide / 2, y + 0.5, east);
    add_square(picture, x, y, 0.02);
}

/// All dominoes, apart from each other, or in the order of Wei's circle.
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

/// A vertex a colour and an edge a domino: an Eulerian circuit is a packing (D. figure 5.8).
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

void add_indices(const TilePacking& packing, DistributionFiles& files, DistributionResult& result)
{
    std::string text;
    for (Color row = packing.side(); row-- > 0;)
        for (Color column = 0; column < packing.side(); ++column)
            text += fmt::format("{}{}", packing.at({column, row}), column + 1 == packing.side() ? "\n" : " ");
    write_whole_file(files.add("tiles.txt"), text);
    result.files.emplace_back("tiles.txt");
}

/// Names the method, and says which kinds and numbers of colours it has: the same for tables and the command.
void packing_method_keys(Keys& keys, PackingSettings& s)
{
    static const std::vector<std::string> methods{"closed", "printed", "product", "eulerian", "search", "grown"};
    keys.word("method", s.method, methods, "how the packing is made");
    if (!keys.is_given("method")) return;
    const auto refuse = [&](const char* allowed) { throw keys.invalid("method", allowed); };
    const bool is_corner = s.kind == TileKind::corner;
    if (s.method == "printed" && s.colors > 4) refuse("has at most 4 colours");
    if (s.method == "product" && (is_corner || s.colors != 3)) refuse("is for wang tiles of 3 colours");
    if (s.method == "eulerian" && is_corner) refuse("is for wang tiles");
    if (s.method == "search" && s.colors > 3) refuse("takes years for more than 3 colours");
    if (s.method == "grown" && (!is_corner || s.colors != 3)) refuse("is for corner tiles of 3 colours");
}

void packing_keys(Keys& keys, PackingSettings& s)
{
    static constexpr WordTable<TileKind, 2> kinds{{{{TileKind::corner, "corner"}, {TileKind::wang, "wang"}}}};
    keys.word("kind", s.kind, kinds, "the kind of tiles");
    Keys::Said colors =
        keys.integer("colors", s.colors, 2, max_colors, "the number of colours, at most 16 in a picture");
    if (s.is_printed) colors.required();
    if (!s.is_printed && s.colors > most_drawn_colors) throw keys.invalid("colors", most_drawn_words);
    packing_method_keys(keys, s);
    if (!s.is_printed) keys.word("show", s.show, {"tiles", "puzzle", "dominoes", "graph", "row"}, "what is drawn");
}

std::string packing_label(const PackingSettings& settings)
{
    const char* const kind = settings.kind == TileKind::corner ? "corner tiles" : "Wang tiles";
    if (settings.show == "puzzle") return fmt::format("Puzzle of {}, {} colours", kind, settings.colors);
    if (settings.show == "dominoes") return fmt::format("Dominoes of {} colours", settings.colors);
    if (settings.show == "graph") return fmt::format("Graph of the dominoes of {} colours", settings.colors);
    if (settings.show == "row") return fmt::format("Packing of the dominoes of {} colours", settings.colors);
    std::string label = fmt::format("{} packing of {}, {} colours", settings.method, kind, settings.colors);
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

DistributionResult make_packing(const PackingSettings& settings, std::uint64_t seed, const DistributionPlace&,
                                DistributionFiles& files)
{
    DistributionResult result;
    if (settings.show == "dominoes" || settings.show == "row") {
        const bool is_packed = settings.show == "row";
        result.facts = {fmt::format("{} tiles", settings.colors * settings.colors)};
        files.add_marks("dominoes.json", drawn_dominoes(settings.colors, is_packed),
                        is_packed ? "Each once on a circle, neighbours having the same colour where they meet."
                                  : "The complete set: all pairs of colours.",
                        result);
        return result;
    }
    if (settings.show == "graph") {
        files.add_marks("graph.json", drawn_graph(settings.colors),
                        "A vertex a colour, an edge a tile: every Eulerian circuit is a packing.", result);
        return result;
    }
    const TilePacking packing = chosen_packing(settings, seed);
    if (const auto fault = packing_fault(packing)) throw std::logic_error("a packing that is not one: " + *fault);
    result.facts = {fmt::format("{} x {} places", packing.side(), packing.side()),
                    fmt::format("{} tiles, each once", packing.tiles.size())};
    add_indices(packing, files, result);
    if (settings.show == "puzzle")
        files.add_marks("puzzle.json", drawn_puzzle(packing),
                        "Pieces that fit where their colours do, and nowhere else.", result);
    else
        files.add_marks("packing.json", drawn_packing(packing),
                        "All tiles with their numbers; opposite sides fit as well. The first row is the lowest.",
                        result);
    return result;
}

}

TilePacking chosen_packing(const PackingSettings& settings, std::uint64_t seed)
{
    if (settings.method == "printed") return printed_packing(settings.kind, settings.colors);
    if (settings.method == "product") return printed_product_packing();
    if (settings.method == "eulerian") return euler_packing(settings.colors, seed);
    if (settings.method == "search") return random_packing(settings.kind, settings.colors, seed);
    if (settings.method == "grown") return grown_packing(printed_packing(settings.kind, 2), seed);
    return closed_packing(settings.kind, settings.colors);
}

Kind packing_kind()
{
    return make_kind<PackingSettings>(
        {"packing", "", "", "Packing", "Draw all tiles of a set on a torus, each once", false}, packing_keys,
        packing_label, make_packing);
}

Kind printed_packing_kind()
{
    PackingSettings printed;
    printed.is_printed = true;
    return make_kind({"", "packing", "packing", "Tile packing",
                      "Print, draw or verify a tile packing, or make a puzzle of it", false},
                     packing_keys, packing_label, make_packing, printed);
}

}
