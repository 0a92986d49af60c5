#include "tiles/polyominoes/polyomino.hpp"

#include "tiles/tilings/permutation_hash.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace poissonlab {
namespace {

/// The matrix as lists that are linked in four directions; nodes 0 to `columns` are the heads of columns and of the
/// list of them.
class DancingLinks
{
public:
    DancingLinks(const CoverProblem& problem, const std::vector<std::uint32_t>& order) : sizes_(problem.columns, 0)
    {
        const std::uint32_t columns = problem.columns;
        for (std::uint32_t i = 0; i <= columns; ++i)
            nodes_.push_back({i == 0 ? columns : i - 1, i == columns ? 0 : i + 1, i, i, i, 0});
        for (const std::uint32_t row : order) append(problem.rows[row], row);
    }

    /// Calls `on_cover` for covers until it returns false. Returns false if it did, or if `steps` were not enough.
    template <class OnCover>
    bool search(std::uint64_t steps, const OnCover& on_cover)
    {
        steps_ = steps;
        return descend(on_cover);
    }

private:
    struct Node
    {
        std::uint32_t left, right, up, down, column, row;
    };

    void append(const std::vector<std::uint32_t>& columns, std::uint32_t row)
    {
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        const auto count = static_cast<std::uint32_t>(columns.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t head = columns[i] + 1, here = first + i;
            nodes_.push_back(
                {first + (i + count - 1) % count, first + (i + 1) % count, nodes_[head].up, head, head, row});
            nodes_[nodes_[head].up].down = here;
            nodes_[head].up = here;
            ++sizes_[columns[i]];
        }
    }

    void cover(std::uint32_t head)
    {
        nodes_[nodes_[head].right].left = nodes_[head].left;
        nodes_[nodes_[head].left].right = nodes_[head].right;
        for (std::uint32_t i = nodes_[head].down; i != head; i = nodes_[i].down)
            for (std::uint32_t j = nodes_[i].right; j != i; j = nodes_[j].right) {
                nodes_[nodes_[j].down].up = nodes_[j].up;
                nodes_[nodes_[j].up].down = nodes_[j].down;
                --sizes_[nodes_[j].column - 1];
            }
    }

    void uncover(std::uint32_t head)
    {
        for (std::uint32_t i = nodes_[head].up; i != head; i = nodes_[i].up)
            for (std::uint32_t j = nodes_[i].left; j != i; j = nodes_[j].left) {
                ++sizes_[nodes_[j].column - 1];
                nodes_[nodes_[j].down].up = j;
                nodes_[nodes_[j].up].down = j;
            }
        nodes_[nodes_[head].right].left = head;
        nodes_[nodes_[head].left].right = head;
    }

    std::uint32_t smallest_column() const
    {
        std::uint32_t best = nodes_[0].right;
        for (std::uint32_t head = best; head != 0; head = nodes_[head].right)
            if (sizes_[head - 1] < sizes_[best - 1]) best = head;
        return best;
    }

    template <class OnCover>
    bool descend(const OnCover& on_cover)
    {
        if (nodes_[0].right == 0) return on_cover(std::as_const(chosen_));
        const std::uint32_t head = smallest_column();
        bool goes_on = true;
        cover(head);
        for (std::uint32_t i = nodes_[head].down; i != head && goes_on; i = nodes_[i].down) {
            if (steps_-- == 0) {
                goes_on = false;
                break;
            }
            chosen_.push_back(nodes_[i].row);
            for (std::uint32_t j = nodes_[i].right; j != i; j = nodes_[j].right) cover(nodes_[j].column);
            goes_on = descend(on_cover);
            for (std::uint32_t j = nodes_[i].left; j != i; j = nodes_[j].left) uncover(nodes_[j].column);
            chosen_.pop_back();
        }
        uncover(head);
        return goes_on;
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> sizes_; ///< rows left of each column
    std::vector<std::uint32_t> chosen_;
    std::uint64_t steps_ = 0;
};

std::vector<std::uint32_t> row_numbers(const CoverProblem& problem)
{
    std::vector<std::uint32_t> order(problem.rows.size());
    std::iota(order.begin(), order.end(), 0);
    return order;
}

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

std::optional<std::vector<std::uint32_t>> exact_cover(const CoverProblem& problem, std::uint64_t seed, Purpose purpose,
                                                      std::uint32_t realization,
                                                      const std::function<void(std::uint32_t)>& on_search)
{
    std::optional<std::vector<std::uint32_t>> found;
    for (std::uint32_t search = 0; search < problem.searches && !found; ++search) {
        if (on_search) on_search(search);
        const StreamKey key = stream_key(seed, purpose, realization, search);
        const auto order = random_permutation(static_cast<std::uint32_t>(problem.rows.size()), key, 0);
        DancingLinks links(problem, order);
        const bool ended = links.search(problem.steps, [&](const std::vector<std::uint32_t>& cover) {
            found = cover;
            return false;
        });
        if (ended) break; // without a cover: there is none
    }
    if (found) std::ranges::sort(*found);
    return found;
}

std::vector<std::vector<std::uint32_t>> all_exact_covers(const CoverProblem& problem)
{
    std::vector<std::vector<std::uint32_t>> covers;
    DancingLinks links(problem, row_numbers(problem));
    links.search(problem.steps, [&](std::vector<std::uint32_t> cover) {
        std::ranges::sort(cover);
        covers.push_back(std::move(cover));
        return true;
    });
    return covers;
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
