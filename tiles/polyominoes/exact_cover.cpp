#include "tiles/polyominoes/exact_cover.hpp"

#include "tiles/tilings/random_permutation.hpp"

#include <algorithm>
#include <numeric>
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

}
