#include "host/texture/seam_cut.hpp"

#include <maxflow.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace poissonlab {
namespace {

/// The sum over channels of differences between a pixel of one picture and a pixel of another.
int pixel_distance(const PngPixels& a, int ax, int ay, const PngPixels& b, int bx, int by)
{
    const std::uint8_t* const p = &a.values[a.at(ax, ay, 0)];
    const std::uint8_t* const q = &b.values[b.at(bx, by, 0)];
    int sum = 0;
    for (int c = 0; c < a.channels; ++c) sum += std::abs(p[c] - q[c]);
    return sum;
}

/// Twice the gradient along a row or a column; at the rim, towards the inside only.
int doubled_gradient(const PngPixels& picture, int x, int y, bool is_vertical)
{
    const int length = is_vertical ? picture.height : picture.width;
    const int place = is_vertical ? y : x;
    const int before = std::max(place - 1, 0), after = std::min(place + 1, length - 1);
    const int difference = is_vertical ? pixel_distance(picture, x, before, picture, x, after)
                                       : pixel_distance(picture, before, y, picture, after, y);
    return difference * 2 / (after - before);
}

/// Calls use(first pixel, second pixel, x, y, is_vertical) for all pairs of neighbours.
template <class Use>
void for_each_pair(int width, int height, const Use& use)
{
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto here = static_cast<std::size_t>(y * width + x);
            if (x + 1 < width) use(here, here + 1, x, y, false);
            if (y + 1 < height) use(here, here + static_cast<std::size_t>(width), x, y, true);
        }
}

}

std::int64_t pair_cost(const PngPixels& below, const PngPixels& above, int x, int y, bool is_vertical,
                       SeamWeight weight)
{
    const int other_x = is_vertical ? x : x + 1, other_y = is_vertical ? y + 1 : y;
    const std::int64_t difference =
        pixel_distance(below, x, y, above, x, y) + pixel_distance(below, other_x, other_y, above, other_x, other_y);
    if (weight == SeamWeight::plain) return 1 + difference;
    std::int64_t gradients = 0;
    for (const PngPixels* picture : {&below, &above})
        gradients +=
            doubled_gradient(*picture, x, y, is_vertical) + doubled_gradient(*picture, other_x, other_y, is_vertical);
    return 1 + difference * 512 / (gradients + 8);
}

SeamCut minimum_cut(const PngPixels& below, const PngPixels& above, const std::vector<PixelRole>& roles,
                    SeamWeight weight)
{
    using Graph = maxflow::Graph_III;
    const int width = below.width, height = below.height;
    std::vector<int> node(roles.size(), -1);
    int nodes = 0;
    for (std::size_t i = 0; i < roles.size(); ++i)
        if (roles[i] == PixelRole::free) node[i] = nodes++;
    Graph graph(std::max(nodes, 1), 2 * nodes + 1);
    graph.add_node(nodes);

    std::int64_t fixed = 0; // of pairs without a choice
    std::vector<std::int64_t> costs;
    for_each_pair(width, height, [&](std::size_t a, std::size_t b, int x, int y, bool is_vertical) {
        const bool a_is_free = node[a] >= 0, b_is_free = node[b] >= 0;
        if (!a_is_free && !b_is_free && roles[a] == roles[b]) {
            costs.push_back(0);
            return;
        }
        const std::int64_t cost = pair_cost(below, above, x, y, is_vertical, weight);
        costs.push_back(cost);
        const int capacity = static_cast<int>(cost);
        const auto tie = [&](int free, PixelRole role) {
            graph.add_tweights(free, role == PixelRole::kept ? capacity : 0, role == PixelRole::taken ? capacity : 0);
        };
        if (a_is_free && b_is_free)
            graph.add_edge(node[a], node[b], capacity, capacity);
        else if (a_is_free)
            tie(node[a], roles[b]);
        else if (b_is_free)
            tie(node[b], roles[a]);
        else
            fixed += cost;
    });
    const std::int64_t flow = graph.maxflow();

    SeamCut cut;
    for (std::size_t i = 0; i < roles.size(); ++i)
        cut.taken.push_back(node[i] < 0 ? roles[i] == PixelRole::taken
                                        : graph.what_segment(node[i], Graph::SINK) != Graph::SOURCE);
    std::size_t pair = 0;
    for_each_pair(width, height, [&](std::size_t a, std::size_t b, int, int, bool) {
        cut.cost += cut.taken[a] != cut.taken[b] ? costs[pair] : 0;
        ++pair;
    });
    if (cut.cost != flow + fixed) throw std::logic_error("a minimum cut that does not cost its flow");
    return cut;
}

}
