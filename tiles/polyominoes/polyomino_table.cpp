#include "tiles/polyominoes/polyomino_table.hpp"

#include "base/geometry/relative_radius.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

namespace poissonlab {
namespace {

constexpr int divisions = 4;

/// A share that keeps its place among the others while it dies out.
constexpr double least_frequency = 1e-6;

/// A class or pair, and one that follows from it by a division.
struct Descent
{
    std::size_t parent;
    std::size_t child;
};

std::vector<Descent> all_descents(const Neighbourhoods& all)
{
    std::vector<Descent> descents;
    const std::size_t classes = all.collars.size();
    const auto add_pairs = [&](std::size_t parent, const NearTiles& tiles) {
        for_near_children(all, tiles, [&](const NearTiles& pair) {
            const auto found = std::ranges::lower_bound(all.pairs, pair);
            descents.push_back({parent, classes + static_cast<std::size_t>(found - all.pairs.begin())});
        });
    };
    for (std::uint32_t c = 0; c < classes; ++c) {
        for (std::size_t i = 0; i < all.rule.children.size(); ++i) descents.push_back({c, all.child_class(c, i)});
        add_pairs(c, {c, c, Pose{}});
    }
    for (std::size_t i = 0; i < all.pairs.size(); ++i) add_pairs(classes + i, all.pairs[i]);
    return descents;
}

}

std::vector<double> frequencies_of(const Neighbourhoods& neighbourhoods)
{
    const std::vector<Descent> descents = all_descents(neighbourhoods);
    const std::size_t classes = neighbourhoods.collars.size();
    const double part = 1 / static_cast<double>(neighbourhoods.rule.children.size());
    std::vector<double> frequencies(classes + neighbourhoods.pairs.size(), 1 / static_cast<double>(classes));
    for (int i = 0; i < divisions; ++i) {
        std::vector<double> next(frequencies.size(), least_frequency);
        for (const auto& [parent, child] : descents) next[child] += part * frequencies[parent];
        frequencies = std::move(next);
    }
    return frequencies;
}

namespace {

/// Squared distances of the nearest copies of children i and j, [i * k^2 + j], in a unit that all have in common.
std::vector<std::int64_t> child_distances(const Neighbourhoods& all)
{
    const std::size_t count = all.rule.children.size();
    const std::int64_t parts = 2 * static_cast<std::int64_t>(cells_of(all.rule.shape).size());
    const LatticePlace centroid = centroid_sum(all.rule.shape);
    const auto middle = [&](const Pose& tile) { return turned(tile.turn, centroid) + parts * tile.shift; };
    std::vector<std::int64_t> nearest(count * count, std::numeric_limits<std::int64_t>::max());
    const auto compare = [&](const Pose& parent) {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < count; ++j) {
                const Pose child = all.rule.child(parent, j);
                if (child == all.rule.children[i]) continue;
                const LatticePlace d = middle(child) - middle(all.rule.children[i]);
                std::int64_t& least = nearest[i * count + j];
                least = std::min(least, d.x * d.x + d.y * d.y);
            }
    };
    compare(Pose{});
    std::vector<Pose> poses;
    for (const NearTiles& pair : all.pairs) poses.push_back(pair.pose);
    std::ranges::sort(poses);
    const auto doubles = std::ranges::unique(poses);
    poses.erase(doubles.begin(), doubles.end());
    for (const Pose& pose : poses) compare(pose);
    return nearest;
}

}

std::vector<std::uint32_t> farthest_children(const Neighbourhoods& neighbourhoods)
{
    const std::size_t count = neighbourhoods.rule.children.size();
    const std::vector<std::int64_t> distances = child_distances(neighbourhoods);
    std::vector<std::int64_t> gap; // to the copies of children that are chosen, and to its own
    for (std::size_t i = 0; i < count; ++i) gap.push_back(distances[i * count + i]);
    std::vector<std::uint32_t> order;
    while (order.size() < count) {
        const auto best = static_cast<std::size_t>(std::ranges::max_element(gap) - gap.begin());
        order.push_back(static_cast<std::uint32_t>(best));
        for (std::size_t i = 0; i < count; ++i) gap[i] = std::min(gap[i], distances[best * count + i]);
        for (const std::uint32_t chosen : order) gap[chosen] = -1;
    }
    return order;
}

Neighbourhoods with_children_in_order(const Neighbourhoods& neighbourhoods, const std::vector<std::uint32_t>& order)
{
    Neighbourhoods ordered = neighbourhoods;
    for (std::size_t i = 0; i < order.size(); ++i) {
        ordered.rule.children[i] = neighbourhoods.rule.children[order[i]];
        for (std::uint32_t c = 0; c < neighbourhoods.collars.size(); ++c)
            ordered.next[c * order.size() + i] = neighbourhoods.child_class(c, order[i]);
    }
    return ordered;
}

namespace {

/// The largest distance of a point from the anchor in its tile, rounded up, in units.
std::int64_t largest_correction(const std::vector<Correction>& row)
{
    std::int64_t largest = 0;
    for (const auto& [x, y] : row) largest = std::max<std::int64_t>(largest, std::int64_t{x} * x + std::int64_t{y} * y);
    return static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(largest)))) + 1;
}

/// The least squared distance of the pairs that PairSearch visits: of ancestors that are near, or of all that can be
/// seen from each other.
std::uint64_t least_visited(const PolyominoTable& table, std::uint32_t row, std::uint32_t levels, double reach,
                            bool are_near)
{
    const std::vector<Correction>& corrections = table.rows[row - 1];
    const KeptTiles tiles{table.neighbourhoods, table.depth, row};
    const LatticePlace anchor = anchor_of(table.neighbourhoods.rule.shape);
    const std::uint64_t numbers = tiles.numbers();
    const auto point = [&](const TableTile& tile) {
        return point_of(tile.pose, anchor, corrections[tile.entry / numbers * row + tile.entry % numbers]);
    };
    auto least = std::numeric_limits<std::int64_t>::max();
    const auto visit = [&](const TableTile& a, const TableTile& b, std::size_t) {
        const LatticePlace d = point(b) - point(a);
        least = std::min(least, d.x * d.x + d.y * d.y);
    };
    const PairSearch search(tiles, levels, reach);
    if (are_near)
        search.run(visit);
    else
        search.run(pairs_within(table.neighbourhoods, search.reach_of_ancestors()), visit);
    return static_cast<std::uint64_t>(least);
}

/// The density of a row in points per cell.
double row_density(const PolyominoTable& table, std::uint32_t row)
{
    const auto cells = static_cast<double>(cells_of(table.neighbourhoods.rule.shape).size());
    return row / (cells * table.last_row());
}

}

LatticePlace anchor_of(Polyomino shape)
{
    const auto parts = static_cast<std::int64_t>(2 * cells_of(shape).size());
    const LatticePlace sum = centroid_sum(shape);
    return {(cell_units * sum.x + parts / 2) / parts, (cell_units * sum.y + parts / 2) / parts};
}

RowProof proof_of_row(const PolyominoTable& table, std::uint32_t row)
{
    const std::int64_t correction = largest_correction(table.rows[row - 1]);
    const double spacing = max_min_distance(1, 2) / std::sqrt(row_density(table, row)); // in cells
    // Points that are nearer than the spacing of the densest packing have middles of tiles that are within this.
    const double reach = spacing + 2.0 * static_cast<double>(correction + 1) / cell_units;
    std::int64_t gap = 2 * cell_units;
    for (std::uint32_t level = 0; level < table.depth; ++level) gap *= table.neighbourhoods.rule.factor;
    for (std::uint32_t levels = table.depth;; ++levels, gap *= table.neighbourhoods.rule.factor) {
        // Tiles whose ancestors are not near are two cells of these apart at least, and points leave tiles by their
        // corrections only.
        const std::int64_t apart = gap - 2 * correction;
        if (static_cast<double>(apart) < spacing * cell_units) continue;
        const std::uint64_t proven = least_visited(table, row, levels, reach, true);
        const bool needs_more = levels > table.depth;
        return {proven, table.neighbourhoods.first_level + levels,
                needs_more ? std::min(proven, least_visited(table, row, table.depth, reach, false)) : proven};
    }
}

double proven_relative_radius(const PolyominoTable& table, std::uint32_t row)
{
    const double distance = std::sqrt(static_cast<double>(table.proofs[row - 1].squared_distance)) / cell_units;
    return distance * std::sqrt(row_density(table, row)) / max_min_distance(1, 2);
}

PolyominoTable build_polyomino_table(Polyomino shape, const PolyominoProgress& progress)
{
    std::mutex reporting;
    const auto report = [&](const std::string& what, std::size_t done, std::size_t total) {
        const std::lock_guard lock(reporting);
        if (progress) progress(what, done, total);
    };
    const PolyominoRule rule = division_rule(shape, [&](std::uint32_t search) { report("division", search, 0); });
    report("neighbourhoods", 0, 1);
    PolyominoTable table;
    const Neighbourhoods unordered = neighbourhoods_of(rule);
    table.neighbourhoods = with_children_in_order(unordered, farthest_children(unordered));
    table.depth = table_depth_of(shape);
    const auto rows = static_cast<std::uint32_t>(KeptTiles{table.neighbourhoods, table.depth, 1}.numbers());
    table.rows.resize(rows);
    table.proofs.resize(rows);
    std::atomic<std::size_t> done = 0;
    const std::vector<double> frequencies = frequencies_of(table.neighbourhoods);
    tbb::parallel_for(std::uint32_t{1}, rows + 1, [&](std::uint32_t row) {
        table.rows[row - 1] = relaxed_row({table.neighbourhoods, table.depth, row}, frequencies);
        table.proofs[row - 1] = proof_of_row(table, row);
        report("corrections", ++done, rows);
    });
    return table;
}

}
