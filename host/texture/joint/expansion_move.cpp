#include "host/texture/joint/expansion_move.hpp"

#include <maxflow.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace poissonlab {
namespace {

/// A minimum cut: what pixels cost kept and taken, and what it adds that the first of two is kept and the second taken.
struct CutProblem
{
    struct Edge
    {
        std::uint32_t first = 0, second = 0;
        std::int64_t cost = 0;
    };

    std::vector<std::int64_t> kept, taken;
    std::vector<Edge> edges;
    std::int64_t constant = 0;

    /// No flow, and no capacity that matters, is larger.
    std::int64_t largest_flow() const
    {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < kept.size(); ++i) sum += std::abs(taken[i] - kept[i]);
        for (const Edge& edge : edges) sum = std::max(sum, edge.cost);
        return sum;
    }
};

template <class Graph>
std::int64_t cut(const CutProblem& problem, std::vector<std::uint8_t>& choice)
{
    using Capacity = std::remove_cvref_t<decltype(std::declval<Graph&>().maxflow())>;
    const auto capacity = [](std::int64_t cost) { return static_cast<Capacity>(cost); };
    Graph graph(static_cast<int>(choice.size()) + 1, static_cast<int>(problem.edges.size()) + 1);
    graph.add_node(static_cast<int>(choice.size()));
    std::int64_t constant = problem.constant;
    for (const CutProblem::Edge& edge : problem.edges)
        graph.add_edge(static_cast<int>(edge.first), static_cast<int>(edge.second), capacity(edge.cost), 0);
    for (std::size_t i = 0; i < choice.size(); ++i) {
        const std::int64_t least = std::min(problem.kept[i], problem.taken[i]);
        constant += least;
        graph.add_tweights(static_cast<int>(i), capacity(problem.taken[i] - least), capacity(problem.kept[i] - least));
    }
    const auto flow = static_cast<std::int64_t>(graph.maxflow());
    for (std::size_t i = 0; i < choice.size(); ++i)
        choice[i] = graph.what_segment(static_cast<int>(i), Graph::SOURCE) == Graph::SINK;
    return flow + constant;
}

}

void ExpansionMove::add_pair(std::size_t first, std::size_t second, const PairChoice& costs)
{
    if (costs.kept_kept + costs.taken_taken > costs.kept_taken + costs.taken_kept)
        throw std::logic_error("costs of a pair that no cut can minimise");
    pairs_.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second), costs});
}

std::int64_t ExpansionMove::cost(const std::vector<std::uint8_t>& choice) const
{
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < choice.size(); ++i) sum += choice[i] == 0 ? kept_[i] : taken_[i];
    for (const Pair& pair : pairs_) {
        const PairChoice& c = pair.costs;
        sum += choice[pair.first] == 0 ? (choice[pair.second] == 0 ? c.kept_kept : c.kept_taken)
                                       : (choice[pair.second] == 0 ? c.taken_kept : c.taken_taken);
    }
    return sum;
}

ExpansionMove::Choice ExpansionMove::best() const
{
    // A pair costs kept_kept, what taking adds to each pixel by itself, and the rest where the first keeps alone.
    CutProblem problem{kept_, taken_, {}, 0};
    for (const Pair& pair : pairs_) {
        const PairChoice& c = pair.costs;
        problem.constant += c.kept_kept;
        problem.taken[pair.first] += c.taken_kept - c.kept_kept;
        problem.taken[pair.second] += c.taken_taken - c.taken_kept;
        const std::int64_t alone = c.kept_taken + c.taken_kept - c.kept_kept - c.taken_taken;
        if (alone > 0) problem.edges.push_back({pair.first, pair.second, alone});
    }
    // Graphs of ints are faster; flows that they could not hold are left to doubles, which hold integers up to 2^53.
    const bool is_small = problem.largest_flow() < std::int64_t{1} << 30;
    Choice choice{std::vector<std::uint8_t>(pixels()), 0};
    choice.cost =
        is_small ? cut<maxflow::Graph_III>(problem, choice.taken) : cut<maxflow::Graph_DDD>(problem, choice.taken);
    if (cost(choice.taken) != choice.cost) throw std::logic_error("a move that does not cost its flow");
    return choice;
}

}
