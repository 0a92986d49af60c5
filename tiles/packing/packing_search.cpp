#include "tiles/packing/packing_search.hpp"

#include "base/crew/thread_limit.hpp"
#include "base/errors/errors.hpp"
#include "base/files/file_lock.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/side_by_side.hpp"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <unistd.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

namespace poissonlab {
namespace {

using Clock = std::chrono::steady_clock;

/// Walks down for an estimate are made a few at a time: those of 4 colours take milliseconds each.
constexpr std::uint32_t walks_at_a_time = 20, most_batches = 50;

/// The tree is cut into as many parts, or a little more. Their number bounds the size of checkpoints, does not depend
/// on the number of threads, and gives each shard some.
constexpr std::size_t least_subtrees = 256, most_subtrees = 65'536, subtrees_a_shard = 16;

/// The turn in which something happens to a subtree: the lowest comes first.
using Turn = std::pair<std::uint64_t, std::size_t>;
constexpr Turn never{std::numeric_limits<std::uint64_t>::max(), 0};

/// Keeps other processes away from a checkpoint: of two that write it in turns, one would lose its work. The lock is on
/// a file beside it, because a checkpoint is replaced whenever it is written. Devices have none, nor have folders where
/// nothing can be written: the first save says so. Throws StorageError where the file beside it cannot be locked.
std::optional<FileLock> lock_beside(const std::filesystem::path& checkpoint)
{
    std::error_code none;
    if (checkpoint.empty()) return std::nullopt;
    const auto status = std::filesystem::status(checkpoint, none);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return std::nullopt;
    const auto target = std::filesystem::weakly_canonical(checkpoint, none);
    const std::filesystem::path file = (target.empty() ? checkpoint : target).string() + ".lock";
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    if (!std::filesystem::exists(file, none) && ::access(folder.c_str(), W_OK) != 0) return std::nullopt;
    if (auto lock = FileLock::try_lock(file)) return lock;
    throw InputError::at({checkpoint.string()}, "another process is at work on this search: each needs a checkpoint of "
                                                "its own");
}

class ParallelSearch
{
public:
    ParallelSearch(const PackingSearch& search, const PackingSearchSettings& settings)
        : search_(search), settings_(settings), lock_(lock_beside(settings.checkpoint))
    {
        search_.problem.has_first_tile = search.task == PackingTask::count;
        const auto board = make_packing_board(search_.problem);
        tree_ = cut_tree(*board, std::clamp(subtrees_a_shard * search.shards, least_subtrees, most_subtrees));
        std::error_code failure;
        const bool has_file = std::filesystem::exists(settings.checkpoint, failure);
        if (failure)
            throw StorageError(fmt::format("{}: cannot be read: {}", settings.checkpoint.string(), failure.message()));
        if (has_file) read_search_file(settings, search_, *board, tree_.subtrees);
        is_taken_.resize(tree_.subtrees.size());
        for (std::size_t i = 0; i < tree_.subtrees.size(); ++i) {
            note_answer(i);
            nodes_ += tree_.subtrees[i].nodes;
        }
        nodes_before_ = nodes_;
    }

    FoundPackings search()
    {
        save(); // a file that cannot be written is known before any work
        const int threads = ThreadLimit::current();
        try {
            tbb::task_arena arena(threads);
            arena.execute(
                [&] { for_all_side_by_side(static_cast<std::size_t>(threads), [&](std::size_t) { work(); }); });
        } catch (...) {
            save_or_go_on(); // a full disk must not hide why the search ended
            throw;
        }
        FoundPackings all = found();
        try {
            save();
        } catch (const StorageError& error) { // what was found is not lost with it
            all.unwritten = error.what();
        }
        return all;
    }

private:
    bool is_first_enough() const { return search_.task == PackingTask::first; }

    Turn next_turn_of(std::size_t subtree) const
    {
        return {is_first_enough() ? tree_.subtrees[subtree].nodes / settings_.nodes_a_round : 0, subtree};
    }

    /// Notes the turn in which a subtree has had its packing, where one is enough.
    void note_answer(std::size_t subtree)
    {
        const PackingSubtree& done = tree_.subtrees[subtree];
        if (!is_first_enough() || done.packings == 0 || done.nodes == 0) return;
        answer_ = std::min(answer_, Turn{(done.nodes - 1) / settings_.nodes_a_round, subtree});
    }

    /// Takes the subtree whose turn is next, if it comes before the answer.
    std::optional<std::size_t> take()
    {
        const std::lock_guard lock(mutex_);
        Turn next = never;
        for (std::size_t i = search_.shard - 1; i < tree_.subtrees.size(); i += search_.shards)
            if (!is_taken_[i] && !tree_.subtrees[i].is_done) next = std::min(next, next_turn_of(i));
        if (is_stopping_ || next >= answer_) return std::nullopt;
        is_taken_[next.second] = true;
        return next.second;
    }

    void put_back(std::size_t number, PackingSubtree&& subtree)
    {
        const std::lock_guard lock(mutex_);
        nodes_ += subtree.nodes - tree_.subtrees[number].nodes;
        tree_.subtrees[number] = std::move(subtree);
        is_taken_[number] = false;
        note_answer(number);
        if (Clock::now() - saved_ >= settings_.between_checkpoints) save_or_go_on();
    }

    /// A disk that is full for an hour must not end a search of months.
    void save_or_go_on()
    {
        try {
            save();
            is_unwritten_ = false;
        } catch (const StorageError& error) {
            saved_ = Clock::now(); // tried again after as long
            if (!std::exchange(is_unwritten_, true) && settings_.on_unwritten) settings_.on_unwritten(error.what());
        }
    }

    /// Does turns until there are no more. What fails stops the other threads as well.
    void work()
    {
        try {
            const auto board = make_packing_board(search_.problem);
            while (const auto number = take()) {
                do_turn(*board, *number);
                tell();
            }
        } catch (...) {
            stop();
            throw;
        }
    }

    void do_turn(PackingBoard& board, std::size_t number)
    {
        PackingSubtree subtree = tree_.subtrees[number];
        const Turn turn = next_turn_of(number);
        const std::uint64_t until = (subtree.nodes / settings_.nodes_a_round + 1) * settings_.nodes_a_round;
        try {
            walk(board, subtree,
                 {until, is_first_enough(), search_.task != PackingTask::count, [&] { return is_needed(turn); }});
        } catch (...) {
            put_back(number, std::move(subtree));
            throw;
        }
        put_back(number, std::move(subtree));
    }

    void stop()
    {
        const std::lock_guard lock(mutex_);
        is_stopping_ = true;
    }

    /// False where another thread has stopped, or has found what comes before this turn.
    bool is_needed(Turn turn)
    {
        stop_if_interrupted();
        const std::lock_guard lock(mutex_);
        return !is_stopping_ && turn < answer_;
    }

    /// Calls the listener where some time has passed.
    void tell()
    {
        const std::lock_guard lock(mutex_);
        if (!settings_.on_progress || Clock::now() - told_ < std::chrono::milliseconds(300)) return;
        told_ = Clock::now();
        if (batches_ < most_batches) {
            if (!estimated_) estimated_ = make_packing_board(search_.problem);
            estimate_ += (estimate_nodes(*estimated_, walks_at_a_time, batches_).nodes - estimate_) / (batches_ + 1);
            ++batches_;
        }
        settings_.on_progress(progress());
    }

    PackingProgress progress() const
    {
        PackingProgress progress{.nodes = nodes_ + tree_.nodes};
        double weights = 0, done = 0, all = 0;
        for (const PackingSubtree& subtree : tree_.subtrees) all += subtree.weight;
        for (std::size_t i = search_.shard - 1; i < tree_.subtrees.size(); i += search_.shards) {
            const PackingSubtree& subtree = tree_.subtrees[i];
            progress.packings += subtree.packings;
            weights += subtree.weight;
            done += subtree.weight * subtree.share;
        }
        progress.share = weights > 0 ? done / weights : 1;
        progress.tree_nodes = all > 0 ? estimate_ * weights / all : estimate_;
        if (search_.task == PackingTask::count) progress.packings *= tiles_of_set();
        const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
        progress.nodes_per_second = static_cast<double>(nodes_ - nodes_before_) / std::max(seconds, 1e-3);
        return progress;
    }

    void save()
    {
        if (settings_.checkpoint.empty()) return;
        write_search_file(settings_, search_, tree_.subtrees);
        saved_ = Clock::now();
    }

    std::size_t tiles_of_set() const
    {
        const std::size_t colors = search_.problem.colors;
        return colors * colors * colors * colors;
    }

    FoundPackings found() const
    {
        FoundPackings found{.nodes = nodes_ + tree_.nodes};
        const Color colors = search_.problem.colors;
        const std::size_t tiles = tiles_of_set();
        const auto add = [&](const PackingSubtree& subtree) {
            found.count += subtree.packings;
            for (auto first = subtree.tiles.begin(); first != subtree.tiles.end();
                 first += static_cast<std::ptrdiff_t>(tiles))
                found.packings.push_back(
                    {search_.problem.kind, colors, {first, first + static_cast<std::ptrdiff_t>(tiles)}});
        };
        if (answer_ != never) add(tree_.subtrees[answer_.second]);
        if (!is_first_enough())
            for (std::size_t i = search_.shard - 1; i < tree_.subtrees.size(); i += search_.shards)
                add(tree_.subtrees[i]);
        if (search_.task == PackingTask::count) found.count *= tiles;
        return found;
    }

    PackingSearch search_;
    const PackingSearchSettings& settings_;
    std::optional<FileLock> lock_; ///< held as long as the search goes on
    CutTree tree_;
    std::unique_ptr<PackingBoard> estimated_;
    double estimate_ = 0; ///< of the tree's nodes, the mean of so many batches
    std::uint32_t batches_ = 0;
    std::mutex mutex_; ///< of all below, and of the subtrees that are not taken
    std::vector<char> is_taken_;
    Turn answer_ = never;
    std::uint64_t nodes_ = 0;
    std::uint64_t nodes_before_ = 0; ///< of earlier processes
    bool is_stopping_ = false, is_unwritten_ = false;
    Clock::time_point begin_ = Clock::now(), saved_ = begin_, told_ = begin_;
};

}

double PackingProgress::seconds_left() const
{
    // Estimates of a search that has done a good part of the tree rest on that part.
    const double all = share > 0.01 ? static_cast<double>(nodes) / share : tree_nodes;
    return std::max(all - static_cast<double>(nodes), 0.0) / std::max(nodes_per_second, 1.0);
}

FoundPackings search_packings(const PackingSearch& search, const PackingSearchSettings& settings)
{
    return ParallelSearch(search, settings).search();
}

TilePacking random_packing(TileKind kind, Color colors, PackingMethod method, std::uint64_t seed)
{
    FoundPackings found = search_packings({.problem = {kind, colors, method, seed}});
    if (found.packings.empty()) throw InputError(fmt::format("there is no such packing of {} colours", colors));
    return std::move(found.packings.front());
}

}
