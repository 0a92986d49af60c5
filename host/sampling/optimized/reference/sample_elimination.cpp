// Sample elimination, plain and sequential: what the kernels must reproduce.
#include "host/sampling/optimized/sample_elimination.hpp"

#include "base/geometry/torus.hpp"
#include "host/sampling/classics/torus_grid.hpp"
#include "kernels/common/optimized/sample_elimination.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace poissonlab::reference {
namespace {

/// More cells than so many for each point are folded: points lie in a small part of the torus.
constexpr double most_cells_a_point = 16;

/// Cells are as wide as the reach, nearly.
TorusGrid grid_within(const PointSet& points, double reach)
{
    const double cells = std::pow(reach, -points.dimension);
    if (cells <= most_cells_a_point * static_cast<double>(points.size())) return {points.size(), points.dimension};
    return {points.size(), points.dimension, static_cast<std::uint64_t>(std::ceil(reach * 0x1p32))};
}

std::vector<std::vector<Partner>> partners_within(const PointSet& points, const EliminationReach& reach)
{
    TorusGrid grid = grid_within(points, reach.most);
    for (std::size_t i = 0; i < points.size(); ++i) {
        TorusPosition position{};
        for (std::size_t k = 0; k < points[i].size(); ++k)
            position[k] = static_cast<std::uint32_t>(points[i][k] * 0x1p32);
        grid.add(position);
    }
    const double most = reach.most * 0x1p32, least = reach.least * 0x1p32;
    const std::uint64_t squared_reach = squared_threshold(std::min(reach.most, 1.0));
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < points.size(); ++i) all.push_back(i);
    std::vector<std::vector<Partner>> partners(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (const std::size_t j : reach.most < 0.49 ? grid.within(grid[i], most * 1.001) : all) {
            const std::uint64_t squared = squared_torus_distance(grid[i], grid[j]);
            if (j == i || squared >= squared_reach) continue;
            const double rest = 1 - std::max(std::sqrt(static_cast<double>(squared)), least) / most;
            const double fourth = (rest * rest) * (rest * rest);
            partners[i].push_back(
                {static_cast<std::uint32_t>(j),
                 static_cast<std::uint64_t>(fourth * fourth * contract::sample_elimination::WEIGHT_UNITS + 0.5)});
        }
    }
    return partners;
}

}

std::vector<std::uint32_t> removal_order(const PointSet& points, const EliminationReach& reach, std::size_t count)
{
    return factored_removal_order(points, reach, count, {});
}

std::vector<std::uint32_t> factored_removal_order(const PointSet& points, const EliminationReach& reach,
                                                  std::size_t count, std::span<const std::uint32_t> factors)
{
    return heaviest_first(partners_within(points, reach), count, factors);
}

std::vector<std::uint32_t> heaviest_first(const std::vector<std::vector<Partner>>& partners, std::size_t count,
                                          std::span<const std::uint32_t> factors)
{
    const auto weight_for = [&](std::uint32_t point, std::uint64_t weight) {
        return factors.empty() ? weight : weight * factors[point];
    };
    // The heaviest first; of equal weights, the lower number.
    using Entry = std::pair<std::uint64_t, std::uint32_t>;
    const auto heavier = [](const Entry& a, const Entry& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    };
    std::vector<std::uint64_t> weights;
    std::set<Entry, decltype(heavier)> heap(heavier);
    for (const auto& pairs : partners) {
        weights.push_back(0);
        const auto number = static_cast<std::uint32_t>(weights.size() - 1);
        for (const Partner& partner : pairs) weights.back() += weight_for(number, partner.weight);
        heap.emplace(weights.back(), number);
    }
    std::vector<std::uint32_t> order;
    while (order.size() < count) {
        const std::uint32_t heaviest = heap.begin()->second;
        heap.erase(heap.begin());
        order.push_back(heaviest);
        for (const Partner& partner : partners[heaviest]) {
            if (heap.erase({weights[partner.point], partner.point}) == 0) continue; // removed before
            weights[partner.point] -= weight_for(partner.point, partner.weight);
            heap.emplace(weights[partner.point], partner.point);
        }
    }
    return order;
}

}
