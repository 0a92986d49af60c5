#include "tiles/packing/packing_subtree.hpp"

#include "base/random/random_words.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::uint64_t nodes_between_questions = 4096;

/// A node on the way to the one that is visited.
struct Branching
{
    ChoiceSet left;      ///< that were not tried yet
    std::size_t all = 0; ///< choices
};

class Walk
{
public:
    Walk(PackingBoard& board, PackingSubtree& subtree, const SubtreeWalk& how)
        : board_(board), subtree_(subtree), how_(how)
    {
        for (const std::size_t choice : std::exchange(subtree.path, {})) {
            enter();
            way_.back().left.remove_before(choice);
            way_.back().left.remove(choice);
            put(choice);
        }
        enter();
    }
    Walk(const Walk&) = delete;
    Walk& operator=(const Walk&) = delete;
    ~Walk()
    {
        for (std::size_t step = subtree_.path.size(); step > 0; --step) board_.take_back();
    }

    void go_on()
    {
        while (way_.size() > subtree_.depth) {
            const std::size_t choice = way_.back().left.take_first();
            if (choice == ChoiceSet::none) {
                way_.pop_back();
                if (way_.size() > subtree_.depth) take_back();
                continue;
            }
            put(choice);
            ++subtree_.nodes;
            if (subtree_.path.size() == board_.steps()) {
                keep_packing();
                take_back();
                if (how_.stops_at_first) break;
                continue;
            }
            enter();
            if (subtree_.nodes % nodes_between_questions != 0 && subtree_.nodes < how_.until_nodes) continue;
            note_share();
            if (subtree_.nodes >= how_.until_nodes || (how_.goes_on && !how_.goes_on())) return;
        }
        subtree_.share = 1;
        subtree_.is_done = true;
    }

private:
    void enter()
    {
        Branching& branching = way_.emplace_back(Branching{board_.choices()});
        branching.all = branching.left.size();
    }
    void put(std::size_t choice)
    {
        board_.put(choice);
        subtree_.path.push_back(choice);
    }
    void take_back()
    {
        board_.take_back();
        subtree_.path.pop_back();
    }
    void keep_packing()
    {
        ++subtree_.packings;
        if (!how_.keeps_packings) return;
        const std::vector<TileIndex> tiles = board_.packing().tiles;
        subtree_.tiles.insert(subtree_.tiles.end(), tiles.begin(), tiles.end());
    }

    /// The choices whose subtrees are done, on each level of the way.
    void note_share()
    {
        double weight = 1;
        subtree_.share = 0;
        for (std::size_t level = subtree_.depth; level + 1 < way_.size(); ++level) {
            const Branching& branching = way_[level];
            weight /= static_cast<double>(branching.all);
            subtree_.share += weight * static_cast<double>(branching.all - branching.left.size() - 1);
        }
    }

    PackingBoard& board_;
    PackingSubtree& subtree_;
    const SubtreeWalk& how_;
    std::vector<Branching> way_;
};

/// Calls visit(path) with the board at each path of `depth` choices in order; there must be such a depth.
void visit_level(PackingBoard& board, std::size_t depth, std::vector<std::size_t>& path, double weight,
                 const std::function<void(double weight)>& visit)
{
    if (path.size() == depth) return visit(weight);
    ChoiceSet choices = board.choices();
    const double each = weight / static_cast<double>(choices.size());
    for (std::size_t choice; (choice = choices.take_first()) != ChoiceSet::none;) {
        board.put(choice);
        path.push_back(choice);
        visit_level(board, depth, path, each, visit);
        path.pop_back();
        board.take_back();
    }
}

}

bool has_path(PackingBoard& board, const PackingSubtree& root, const std::vector<std::size_t>& path)
{
    if (path.size() < root.depth || path.size() >= board.steps()) return false;
    if (!std::equal(path.begin(), path.begin() + root.depth, root.path.begin())) return false;
    std::size_t made = 0;
    while (made < path.size() && board.choices().has(path[made])) board.put(path[made++]);
    for (std::size_t step = 0; step < made; ++step) board.take_back();
    return made == path.size();
}

void walk(PackingBoard& board, PackingSubtree& subtree, const SubtreeWalk& how)
{
    if (!subtree.is_done) Walk(board, subtree, how).go_on();
}

CutTree cut_tree(PackingBoard& board, std::size_t wanted)
{
    CutTree cut{{PackingSubtree{}}, 0};
    for (std::size_t depth = 1; depth < board.steps() && cut.subtrees.size() < wanted; ++depth) {
        CutTree deeper{{}, cut.nodes};
        std::vector<std::size_t> path;
        visit_level(board, depth, path, 1, [&](double weight) {
            deeper.subtrees.push_back({.path = path, .depth = depth, .weight = weight});
            ++deeper.nodes;
        });
        if (deeper.subtrees.empty()) break;
        cut = std::move(deeper);
    }
    return cut;
}

TreeEstimate estimate_nodes(PackingBoard& board, std::uint32_t walks, std::uint64_t seed)
{
    RandomWords words(stream_key(seed, Purpose::tile_packing, 3), 0);
    double sum = 0, squares = 0;
    for (std::uint32_t walk = 0; walk < walks; ++walk) {
        double nodes = 0, of_level = 1;
        std::size_t step = 0;
        for (; step < board.steps(); ++step) {
            ChoiceSet choices = board.choices();
            const auto count = static_cast<std::uint32_t>(choices.size());
            if (count == 0) break;
            nodes += of_level *= count;
            for (std::uint32_t skipped = words.below(count); skipped > 0; --skipped) choices.take_first();
            board.put(choices.take_first());
        }
        for (; step > 0; --step) board.take_back();
        sum += nodes;
        squares += nodes * nodes;
    }
    const double mean = sum / walks;
    return {mean, std::sqrt(std::max(squares / walks - mean * mean, 0.0) / (walks - 1))};
}

}
