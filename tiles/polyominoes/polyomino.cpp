#include "tiles/polyominoes/polyomino.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::array<LatticePlace, 5> p_cells{{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 2}}};
constexpr std::array<LatticePlace, 6> g_cells{{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}}};

/// The cells of the polyomino, each divided into k x k, with their numbers.
std::map<LatticePlace, std::uint32_t> divided_cells(Polyomino shape)
{
    const std::int64_t k = factor_of(shape);
    std::map<LatticePlace, std::uint32_t> numbers;
    for (const LatticePlace& cell : cells_of(shape))
        for (std::int64_t y = 0; y < k; ++y)
            for (std::int64_t x = 0; x < k; ++x)
                numbers.emplace(k * cell + LatticePlace{x, y}, static_cast<std::uint32_t>(numbers.size()));
    return numbers;
}

struct PosedCover
{
    CoverProblem problem;
    std::vector<Pose> poses; ///< of the rows
};

/// All ways to put the polyomino on numbered cells. `number_of` says the number of a cell, or nothing outside.
template <class NumberOf>
void add_poses(PosedCover& cover, Polyomino shape, const LatticePlace& place, const NumberOf& number_of)
{
    for (Turn turn = 0; turn < turns; ++turn) {
        const Pose pose{place - moved_cell({{}, turn}, cells_of(shape).front()), turn};
        std::vector<std::uint32_t> row;
        for (const LatticePlace& cell : cells_of(shape))
            if (const std::optional<std::uint32_t> number = number_of(moved_cell(pose, cell))) row.push_back(*number);
        if (row.size() != cells_of(shape).size()) continue;
        cover.problem.rows.push_back(std::move(row));
        cover.poses.push_back(pose);
    }
}

PosedCover division_problem(Polyomino shape)
{
    const auto numbers = divided_cells(shape);
    PosedCover cover;
    cover.problem.columns = static_cast<std::uint32_t>(numbers.size());
    for (const auto& [place, number] : numbers)
        add_poses(cover, shape, place, [&](const LatticePlace& cell) -> std::optional<std::uint32_t> {
            const auto found = numbers.find(cell);
            return found == numbers.end() ? std::nullopt : std::optional(found->second);
        });
    return cover;
}

PosedCover torus_problem(Polyomino shape, std::int64_t side)
{
    PosedCover cover;
    cover.problem.columns = static_cast<std::uint32_t>(side * side);
    const auto wrapped = [&](std::int64_t c) { return (c % side + side) % side; };
    for (std::int64_t i = 0; i < side * side; ++i)
        add_poses(cover, shape, {i % side, i / side}, [&](const LatticePlace& cell) {
            return std::optional(static_cast<std::uint32_t>(wrapped(cell.y) * side + wrapped(cell.x)));
        });
    return cover;
}

std::vector<Pose> poses_of(const PosedCover& cover, const std::vector<std::uint32_t>& rows)
{
    std::vector<Pose> poses;
    for (const std::uint32_t row : rows) poses.push_back(cover.poses[row]);
    return poses;
}

}

std::span<const LatticePlace> cells_of(Polyomino shape)
{
    if (shape == Polyomino::P) return p_cells;
    return g_cells;
}

LatticePlace centroid_sum(Polyomino shape)
{
    LatticePlace sum;
    for (const LatticePlace& cell : cells_of(shape)) sum = sum + 2 * cell + LatticePlace{1, 1};
    return sum;
}

PolyominoRule division_rule(Polyomino shape, const std::function<void(std::uint32_t)>& on_search)
{
    PosedCover cover = division_problem(shape);
    PolyominoRule rule{shape, factor_of(shape), {}};
    if (shape == Polyomino::P) {
        // The other rule has no child in the pose of its parent.
        for (const auto& rows : all_exact_covers(cover.problem)) {
            rule.children = poses_of(cover, rows);
            if (std::ranges::count(rule.children, Pose{}) == 1) return rule;
        }
    } else {
        cover.problem.steps = 20'000; // one search in twenty ends with a cover before that
        cover.problem.searches = 10'000;
        if (const auto rows = exact_cover(cover.problem, 0, Purpose::polyomino_division, 0, on_search)) {
            rule.children = poses_of(cover, *rows);
            return rule;
        }
    }
    throw std::logic_error("a polyomino that cannot be divided");
}

std::vector<Pose> random_torus_tiling(Polyomino shape, std::int64_t side, std::uint64_t seed, std::uint32_t realization)
{
    if (side * side % static_cast<std::int64_t>(cells_of(shape).size()) != 0) return {};
    PosedCover cover = torus_problem(shape, side);
    cover.problem.steps = 20'000;
    cover.problem.searches = 1'000;
    const auto rows = exact_cover(cover.problem, seed, Purpose::polyomino_seed, realization);
    return rows ? poses_of(cover, *rows) : std::vector<Pose>{};
}

}
