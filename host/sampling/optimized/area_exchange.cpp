#include "host/sampling/optimized/area_exchange.hpp"

#include "kernels/common/optimized/power_cells.h"

#include <numeric>
#include <utility>

namespace poissonlab {
namespace {

using contract::power_cells::MAX_NEIGHBORS;
using Values = std::vector<double>;

constexpr std::uint32_t no_group = UINT32_MAX;
constexpr std::size_t max_solver_steps = 200;

/// A level's steps are one where that leaves less than this part of the right side.
constexpr double enough_of_one_step = 0.25;

/// Groups are given up where they are more than this part of what they are made of.
constexpr double most_groups = 0.75;

double inner_product(const Values& a, const Values& b)
{
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// a += factor * b
void add(Values& a, double factor, const Values& b)
{
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// Weights matter up to a number that all have in common, and changes sum to zero: rounding adds up, and steps are as
/// long as they are for what is exact.
void take_off_mean(Values& values)
{
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    for (double& value : values) value -= mean;
}

/// The change of a cell's area by weights.
double change_of(const AreaExchange& exchange, const Values& weights, std::size_t i)
{
    double change = 0;
    for (std::size_t k = exchange.starts[i]; k < exchange.starts[i + 1]; ++k)
        change += exchange.exchanges[k] * (weights[i] - weights[exchange.neighbours[k]]);
    return change;
}

Values changes(const AreaExchange& exchange, const Values& weights)
{
    Values changes(weights.size());
    for (std::size_t i = 0; i < changes.size(); ++i) changes[i] = change_of(exchange, weights, i);
    return changes;
}

Values inverse_sums_of(const AreaExchange& exchange)
{
    Values inverse(exchange.size());
    for (std::size_t i = 0; i < inverse.size(); ++i) {
        const double sum = std::accumulate(exchange.exchanges.begin() + exchange.starts[i],
                                           exchange.exchanges.begin() + exchange.starts[i + 1], 0.0);
        inverse[i] = sum > 0 ? 1 / sum : 0;
    }
    return inverse;
}

/// Each cell with the one, of those that are free, with which it exchanges most.
std::vector<std::uint32_t> pairs_of(const AreaExchange& exchange, std::size_t& count)
{
    std::vector<std::uint32_t> pairs(exchange.size(), no_group);
    count = 0;
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i] != no_group) continue;
        std::uint32_t partner = i;
        double most = 0;
        for (std::size_t k = exchange.starts[i]; k < exchange.starts[i + 1]; ++k) {
            const std::uint32_t j = exchange.neighbours[k];
            if (pairs[j] != no_group || exchange.exchanges[k] <= most || j == i) continue;
            partner = j;
            most = exchange.exchanges[k];
        }
        pairs[i] = pairs[partner] = static_cast<std::uint32_t>(count++);
    }
    return pairs;
}

/// The areas that groups exchange with each other.
AreaExchange between_groups(const AreaExchange& exchange, const std::vector<std::uint32_t>& groups, std::size_t count)
{
    std::vector<std::uint32_t> begins(count + 1), members(groups.size());
    for (const std::uint32_t group : groups) ++begins[group + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::uint32_t> next = begins;
    for (std::uint32_t i = 0; i < groups.size(); ++i) members[next[groups[i]]++] = i;

    AreaExchange between;
    between.starts.push_back(0);
    std::vector<std::uint32_t> place(count, 0); // of a neighbour in the row, if it is not before the row's start
    for (std::size_t group = 0; group < count; ++group) {
        const std::uint32_t start = between.starts.back();
        for (std::size_t m = begins[group]; m < begins[group + 1]; ++m)
            for (std::size_t k = exchange.starts[members[m]]; k < exchange.starts[members[m] + 1]; ++k) {
                const std::uint32_t other = groups[exchange.neighbours[k]];
                if (other == group) continue;
                const bool is_new = place[other] < start || place[other] >= between.neighbours.size() ||
                                    between.neighbours[place[other]] != other;
                if (is_new) {
                    place[other] = static_cast<std::uint32_t>(between.neighbours.size());
                    between.neighbours.push_back(other);
                    between.exchanges.push_back(0);
                }
                between.exchanges[place[other]] += exchange.exchanges[k];
            }
        between.starts.push_back(static_cast<std::uint32_t>(between.neighbours.size()));
    }
    return between;
}

/// Moves each weight in turn to where its cell changes as wanted.
void relax(const AreaExchange& exchange, const Values& inverse_sums, const Values& wanted, Values& weights,
           bool is_forward)
{
    const std::size_t n = weights.size();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = is_forward ? k : n - 1 - k;
        weights[i] += inverse_sums[i] * (wanted[i] - change_of(exchange, weights, i));
    }
}

}

AreaExchange area_exchange(const PowerCells& cells)
{
    const std::size_t n = cells.areas.size();
    AreaExchange exchange;
    exchange.starts.reserve(n + 1);
    exchange.neighbours.reserve(6 * n);
    exchange.exchanges.reserve(6 * n);
    exchange.starts.push_back(0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = i * MAX_NEIGHBORS; k < (i + 1) * MAX_NEIGHBORS; ++k) {
            if (cells.neighbours[k] == UINT32_MAX) break;
            exchange.neighbours.push_back(cells.neighbours[k]);
            exchange.exchanges.push_back(cells.exchanges[k]);
        }
        exchange.starts.push_back(static_cast<std::uint32_t>(exchange.neighbours.size()));
    }
    return exchange;
}

ExchangeSolver::ExchangeSolver(AreaExchange exchange)
{
    for (bool is_last = false; !is_last;) {
        Level level;
        level.inverse_sums = inverse_sums_of(exchange);
        std::size_t pair_count = 0, count = 0;
        const auto pairs = pairs_of(exchange, pair_count);
        const AreaExchange of_pairs = between_groups(exchange, pairs, pair_count);
        const auto pairs_of_pairs = pairs_of(of_pairs, count);
        is_last = static_cast<double>(count) > most_groups * static_cast<double>(exchange.size());
        AreaExchange next;
        if (!is_last) {
            for (const std::uint32_t pair : pairs) level.groups.push_back(pairs_of_pairs[pair]);
            next = between_groups(of_pairs, pairs_of_pairs, count);
        }
        level.exchange = std::move(exchange);
        exchange = std::move(next);
        levels_.push_back(std::move(level));
    }
}

/// One cycle through a level and those below it.
std::vector<double> ExchangeSolver::precondition(std::size_t l, const Values& wanted) const
{
    const Level& level = levels_[l];
    Values weights(wanted.size());
    relax(level.exchange, level.inverse_sums, wanted, weights, true);
    if (!level.groups.empty()) {
        Values of_groups(levels_[l + 1].exchange.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
            of_groups[level.groups[i]] += wanted[i] - change_of(level.exchange, weights, i);
        take_off_mean(of_groups);
        const Values correction = solve_nearly(l + 1, of_groups);
        for (std::size_t i = 0; i < wanted.size(); ++i) weights[i] += correction[level.groups[i]];
    }
    relax(level.exchange, level.inverse_sums, wanted, weights, false);
    take_off_mean(weights);
    return weights;
}

/// Up to two steps of conjugate gradients: a second one where the first is not enough. The second direction is made to
/// be conjugate to the first explicitly, as preconditioners vary.
std::vector<double> ExchangeSolver::solve_nearly(std::size_t l, const Values& wanted) const
{
    const AreaExchange& exchange = levels_[l].exchange;
    Values first = precondition(l, wanted);
    const Values image = changes(exchange, first);
    const double curvature = inner_product(first, image);
    if (!(curvature > 0)) return first;
    const double length = inner_product(first, wanted) / curvature;
    Values rest = wanted;
    add(rest, -length, image);
    const double enough = enough_of_one_step * enough_of_one_step * inner_product(wanted, wanted);
    Values second;
    if (inner_product(rest, rest) > enough) {
        second = precondition(l, rest);
        add(second, -inner_product(second, image) / curvature, first);
        const double second_curvature = inner_product(second, changes(exchange, second));
        if (second_curvature > 0) {
            const double second_length = inner_product(second, rest) / second_curvature;
            for (std::size_t i = 0; i < first.size(); ++i) first[i] = length * first[i] + second_length * second[i];
            return first;
        }
    }
    for (double& weight : first) weight *= length;
    return first;
}

std::vector<double> ExchangeSolver::weights_for(const Values& wanted, double tolerance)
{
    const AreaExchange& exchange = levels_.front().exchange;
    Values weights(wanted.size()), rest = wanted, direction, image;
    const double enough = tolerance * tolerance * inner_product(wanted, wanted);
    double curvature = 0;
    for (steps_ = 0; steps_ < max_solver_steps && inner_product(rest, rest) > enough; ++steps_) {
        Values next = precondition(0, rest);
        if (steps_ > 0) add(next, -inner_product(next, image) / curvature, direction);
        direction = std::move(next);
        image = changes(exchange, direction);
        curvature = inner_product(direction, image);
        if (!(curvature > 0)) break;
        const double length = inner_product(direction, rest) / curvature;
        add(weights, length, direction);
        add(rest, -length, image);
    }
    return weights;
}

}
