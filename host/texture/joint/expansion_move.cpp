#include "host/texture/joint/expansion_move.hpp"

#include <maxflow.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace poissonlab {
namespace {

/// Cuts a graph whose capacities are of its kind; returns its flow, and says which pixels are on the sink's side.
template <class Graph, class Edge>
std::int64_t cut(const std::vector<std::int64_t>& gains, const std::vector<Edge>& edges,
                 std::vector<std::uint8_t>& choice)
{
    using Capacity = std::remove_cvref_t<decltype(std::declval<Graph&>().maxflow())>;
    const auto capacity = [](std::int64_t cost) { return static_cast<Capacity>(cost); };
    Graph graph(static_cast<int>(choice.size()) + 1, static_cast<int>(edges.size()) + 1);
    graph.add_node(static_cast<int>(choice.size()));
    for (const Edge& edge : edges)
        graph.add_edge(static_cast<int>(edge.first), static_cast<int>(edge.second), capacity(edge.forward),
                       capacity(edge.backward));
    for (std::size_t i = 0; i < choice.size(); ++i)
        graph.add_tweights(static_cast<int>(i), capacity(std::max<std::int64_t>(0, -gains[i])),
                           capacity(std::max<std::int64_t>(0, gains[i])));
    const auto flow = static_cast<std::int64_t>(graph.maxflow());
    for (std::size_t i = 0; i < choice.size(); ++i)
        choice[i] = graph.what_segment(static_cast<int>(i), Graph::SOURCE) == Graph::SINK;
    return flow;
}

}

void ExpansionMove::add_pair(std::size_t first, std::size_t second, const PairChoice& costs)
{
    const PairChoice& c = costs;
    const std::int64_t alone = c.kept_taken + c.taken_kept - c.kept_kept - c.taken_taken;
    if (alone < 0) throw std::logic_error("costs of a pair that no cut can minimise");
    // Most pairs cost nothing unless one of them takes alone. Their edge has that cost both ways, so that nothing flows
    // between source and sink but what pixels differ by.
    const std::int64_t backward = std::clamp<std::int64_t>(c.taken_kept - c.kept_kept, 0, alone);
    constant_ += c.kept_kept;
    gains_[first] -= c.taken_kept - c.kept_kept - backward;
    gains_[second] -= c.kept_taken - c.kept_kept - (alone - backward);
    if (alone > 0)
        edges_.push_back(
            {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second), alone - backward, backward});
}

std::int64_t ExpansionMove::cost(const std::vector<std::uint8_t>& choice) const
{
    std::int64_t sum = constant_;
    for (std::size_t i = 0; i < choice.size(); ++i)
        if (choice[i] != 0) sum -= gains_[i];
    for (const Edge& edge : edges_)
        if (choice[edge.first] != choice[edge.second]) sum += choice[edge.first] == 0 ? edge.forward : edge.backward;
    return sum;
}

std::int64_t ExpansionMove::largest_flow() const
{
    std::int64_t sum = 0;
    for (const std::int64_t gain : gains_) sum += std::abs(gain);
    for (const Edge& edge : edges_) sum = std::max(sum, edge.forward + edge.backward);
    return sum;
}

ExpansionMove::Choice ExpansionMove::best() const
{
    // Graphs of ints are faster; flows that they could not hold are left to doubles, which hold integers up to 2^53.
    const bool is_small = largest_flow() < std::int64_t{1} << 30;
    Choice choice{std::vector<std::uint8_t>(pixels()), constant_};
    for (const std::int64_t gain : gains_) choice.cost -= std::max<std::int64_t>(0, gain);
    choice.cost += is_small ? cut<maxflow::Graph_III>(gains_, edges_, choice.taken)
                            : cut<maxflow::Graph_DDD>(gains_, edges_, choice.taken);
    if (cost(choice.taken) != choice.cost) throw std::logic_error("a move that does not cost its flow");
    return choice;
}

}
