#include "tiles/packing/euler_packing.hpp"

#include "base/random/random_words.hpp"
#include "tiles/packing/closed_packing.hpp"

#include <algorithm>
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

}
