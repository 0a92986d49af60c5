#include "tiles/packing/packings.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random_words.hpp"
#include "tiles/packing/closed_packing.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace poissonlab {
namespace {

/// Returns the colour to which each colour but 0 leads in a random spanning tree towards 0, by loop-erased random walks
/// (Wilson, Generating random spanning trees more quickly than the cover time, STOC 1996), here of a complete graph.
std::vector<Color> random_last_exits(Color colors, RandomWords& words)
{
    std::vector<Color> exit(colors, 0);
    std::vector<bool> is_in_tree(colors, false);
    is_in_tree[0] = true;
    for (Color start = 1; start < colors; ++start) {
        for (Color at = start; !is_in_tree[at]; at = exit[at]) {
            const Color other = words.below(colors - 1);
            exit[at] = other + (other >= at);
        }
        for (Color at = start; !is_in_tree[at]; at = exit[at]) is_in_tree[at] = true;
    }
    return exit;
}

/// The order in which a walk leaves a colour for all others and itself; `last` comes last.
std::vector<Color> random_exits(Color colors, Color last, RandomWords& words)
{
    std::vector<Color> exits(colors);
    std::iota(exits.begin(), exits.end(), Color{0});
    std::swap(exits[last], exits.back());
    for (Color remaining = colors - 1; remaining > 1; --remaining)
        std::swap(exits[remaining - 1], exits[words.below(remaining)]);
    return exits;
}

// Rows as they are printed, north first.
constexpr std::array<TileIndex, 81> figure_5_10{
    6,  15, 16, 7,  24, 17, 25, 26, 8,  60, 69, 70, 61, 78, 71, 79, 80, 62, 57, 66, 67, 58, 75, 68, 76, 77, 59,
    33, 42, 43, 34, 51, 44, 52, 53, 35, 54, 63, 64, 55, 72, 65, 73, 74, 56, 3,  12, 13, 4,  21, 14, 22, 23, 5,
    30, 39, 40, 31, 48, 41, 49, 50, 32, 27, 36, 37, 28, 45, 38, 46, 47, 29, 0,  9,  10, 1,  18, 11, 19, 20, 2};

constexpr std::array<TileIndex, 256> figure_5_11{
    56,  108, 57,  28,  180, 62,  156, 182, 46,  248, 239, 27,  228, 59,  252, 47,  206, 179, 222, 119, 237, 251,
    95,  245, 143, 242, 159, 118, 157, 246, 223, 183, 43,  232, 123, 221, 151, 214, 103, 249, 15,  240, 79,  241,
    111, 217, 87,  229, 186, 174, 250, 127, 125, 109, 185, 254, 31,  244, 63,  236, 187, 110, 121, 173, 198, 163,
    218, 231, 219, 167, 234, 203, 115, 253, 255, 191, 238, 139, 226, 155, 45,  184, 126, 189, 78,  177, 158, 54,
    220, 247, 207, 243, 175, 58,  172, 122, 131, 210, 199, 195, 35,  200, 99,  233, 75,  209, 55,  204, 147, 230,
    171, 202, 36,  104, 41,  40,  168, 10,  160, 170, 26,  116, 205, 51,  92,  181, 190, 30,  165, 138, 162, 154,
    166, 42,  152, 134, 82,  213, 39,  216, 71,  225, 235, 91,  149, 22,  164, 90,  133, 146, 86,  37,  88,  117,
    141, 114, 61,  140, 178, 94,  89,  101, 153, 102, 25,  100, 73,  161, 106, 201, 3,   208, 215, 7,   224, 107,
    66,  145, 70,  129, 98,  137, 34,  136, 130, 50,  44,  120, 93,  53,  188, 142, 4,   80,  21,  20,  132, 18,
    148, 38,  24,  212, 135, 194, 83,  197, 211, 23,  17,  84,  85,  69,  33,  72,  97,  169, 74,  113, 29,  52,
    76,  49,  124, 77,  64,  65,  81,  5,   128, 2,   144, 150, 6,   192, 67,  193, 19,  196, 227, 11,  0,   16,
    68,  1,   32,  8,   96,  105, 9,   48,  60,  12,  112, 13,  176, 14};

constexpr std::array<TileIndex, 256> figure_5_12{
    61,  123, 47,  46,  174, 190, 171, 62,  63,  191, 223, 253, 255, 251, 239, 222, 204, 156, 233, 238, 234, 250,
    187, 235, 254, 203, 220, 205, 236, 158, 237, 206, 213, 249, 139, 244, 159, 189, 175, 142, 248, 155, 217, 221,
    245, 207, 252, 219, 94,  157, 173, 126, 247, 231, 202, 216, 185, 143, 140, 232, 110, 218, 201, 172, 224, 198,
    228, 214, 125, 127, 151, 181, 167, 230, 246, 183, 215, 141, 188, 199, 30,  77,  92,  93,  197, 208, 117, 79,
    124, 119, 95,  109, 78,  240, 243, 111, 194, 212, 209, 241, 91,  57,  107, 226, 210, 121, 227, 242, 211, 53,
    31,  229, 26,  89,  37,  38,  138, 152, 153, 41,  42,  186, 59,  15,  60,  75,  196, 108, 166, 150, 105, 106,
    154, 137, 136, 164, 170, 182, 179, 195, 192, 184, 87,  225, 70,  88,  149, 165, 134, 132, 168, 86,  169, 118,
    27,  45,  58,  163, 122, 43,  100, 146, 101, 74,  72,  104, 162, 90,  133, 120, 147, 193, 176, 11,  180, 135,
    66,  36,  98,  130, 144, 161, 10,  160, 102, 178, 39,  54,  55,  131, 116, 103, 20,  85,  21,  5,   40,  22,
    145, 25,  73,  56,  99,  114, 115, 7,   112, 71,  81,  69,  68,  84,  129, 96,  6,   128, 148, 177, 35,  50,
    51,  67,  52,  83,  17,  65,  64,  80,  33,  18,  97,  34,  82,  29,  49,  3,   48,  19,  113, 23,  0,   4,
    16,  1,   8,   24,  9,   32,  2,   200, 12,  28,  13,  44,  14,  76};

/// The index over `to` colours of a tile whose colours are below both numbers.
TileIndex recounted(TileKind kind, TileIndex tile, Color from, Color to)
{
    return kind == TileKind::wang ? wang_index(wang_tile(tile, {from, from}), {to, to})
                                  : corner_index(corner_tile(tile, from), to);
}

}

std::vector<Color> random_euler_circle(Color colors, std::uint64_t seed, std::uint32_t number)
{
    RandomWords words(stream_key(seed, Purpose::tile_packing, 0), number);
    const std::vector<Color> last = random_last_exits(colors, words);
    std::vector<std::vector<Color>> exits;
    // A circuit has no beginning: it is taken to begin with the domino 0 0. As the last exit from 0, turned around.
    for (Color color = 0; color < colors; ++color)
        exits.push_back(random_exits(colors, color == 0 ? 0 : last[color], words));
    std::vector<Color> used(colors, 0), circle;
    for (Color at = 0; circle.size() < std::size_t{colors} * colors; at = exits[at][used[at]++]) circle.push_back(at);
    // The walk ends with the domino 0 0, whose western colour is the last one: it becomes the first.
    std::ranges::rotate(circle, circle.end() - 1);
    return circle;
}

TilePacking euler_packing(Color colors, std::uint64_t seed)
{
    TilePacking packing = closed_packing(TileKind::wang, colors);
    const std::vector<Color> east = random_euler_circle(colors, seed, 0), north = random_euler_circle(colors, seed, 1);
    const Color side = packing.side();
    for (Color y = 0; y < side; ++y)
        for (Color x = 0; x < side; ++x)
            packing.tiles[std::size_t{y} * side + x] =
                wang_index({north[(y + 1) % side], east[(x + 1) % side], north[y], east[x]}, {colors, colors});
    return packing;
}

TilePacking printed_packing(TileKind kind, Color colors)
{
    if (colors < 2 || colors > most_printed_colors)
        throw InputError("colors = " + std::to_string(colors) + ": must be an integer from 2 to 4");
    const auto& printed = kind == TileKind::wang ? figure_5_12 : figure_5_11;
    constexpr Color rows = most_printed_colors * most_printed_colors;
    TilePacking packing{kind, colors, {}};
    for (Color y = 0; y < packing.side(); ++y)
        for (Color x = 0; x < packing.side(); ++x)
            packing.tiles.push_back(
                recounted(kind, printed[std::size_t{rows - 1 - y} * rows + x], most_printed_colors, colors));
    return packing;
}

TilePacking printed_product_packing()
{
    constexpr Color rows = 9;
    TilePacking packing{TileKind::wang, 3, {}};
    for (Color y = 0; y < rows; ++y)
        for (Color x = 0; x < rows; ++x) packing.tiles.push_back(figure_5_10[std::size_t{rows - 1 - y} * rows + x]);
    return packing;
}

}
