#include "app/commands/tilings/packing_search_work.hpp"

#include "base/crew/thread_limit.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/text/plain_text.hpp"
#include "experiment/run/progress.hpp"
#include "experiment/run/run_plan.hpp"

#include <fmt/format.h>

#include <unistd.h>

namespace poissonlab {
namespace {

using Clock = std::chrono::steady_clock;

std::string time_left(double seconds)
{
    constexpr double day = 86400, year = 365.25 * day;
    if (seconds < 2 * day) return duration_text(seconds);
    return seconds < year ? fmt::format("{:.0f} days", seconds / day) : fmt::format("{:.2g} years", seconds / year);
}

/// A line on standard error that is replaced by the next one on a terminal, and followed by it after half a minute
/// elsewhere.
class SearchLine
{
public:
    explicit SearchLine(bool is_quiet) : is_quiet_(is_quiet) {}
    SearchLine(const SearchLine&) = delete;
    SearchLine& operator=(const SearchLine&) = delete;
    ~SearchLine()
    {
        if (is_open_) fmt::print(stderr, "\r\033[K");
    }

    /// Says once, below the line, that the file lacks what was done since it was written.
    void warn(const std::string& reason)
    {
        fmt::print(stderr, "{}poissonlab: warning: {}; the search goes on, and tries to write it again\n",
                   is_open_ ? "\r\033[K" : "", printable(reason));
        is_open_ = false;
    }

    void show(const PackingProgress& progress)
    {
        const auto between = std::chrono::seconds(is_terminal_ ? 1 : 30);
        if (is_quiet_ || Clock::now() - said_ < between) return;
        said_ = Clock::now();
        const std::string text = fmt::format(
            "{:.3g} nodes, {:.2g} a second; {:.3g} % of a tree of about {:.2g}: {} for all of it; packings: {}",
            static_cast<double>(progress.nodes), progress.nodes_per_second, 100 * progress.share, progress.tree_nodes,
            time_left(progress.seconds_left()), progress.packings);
        fmt::print(stderr, "{}{}{}", is_terminal_ ? "\r\033[K" : "", text, is_terminal_ ? "" : "\n");
        is_open_ = is_terminal_;
    }

private:
    bool is_quiet_;
    bool is_terminal_ = ::isatty(STDERR_FILENO) == 1;
    bool is_open_ = false;
    Clock::time_point said_ = Clock::now();
};

/// Warns of searches that take longer than a person waits.
std::string note_on(const PackingProblem& problem, const SearchOptions& search)
{
    if (search.count && problem.colors > 2)
        return "nobody has counted the packings of more than two colours: see the share of the tree that is done";
    if (problem.colors < 4 || problem.method == PackingMethod::symmetric) return "";
    return fmt::format("the dissertation's search for one packing of 4 colours took {} of processor time{}; --method "
                       "symmetric takes a second",
                       problem.kind == TileKind::wang ? "23 years" : "280 days",
                       search.checkpoint.empty() ? ", and without --checkpoint FILE an interrupted search is lost"
                                                 : "");
}

}

std::vector<Option> SearchOptions::options()
{
    return {{"--all", &all, "Print every packing of two colours"},
            {"--count", &count, "Count the packings instead of printing one"},
            {"--checkpoint", &checkpoint, "Keep the search in this file, and go on from there", "FILE"},
            {"--shard", &shard, "Search only share i of n of the tree", "i/n"},
            {"--threads", &threads, "Search with so many threads; default: all", "N"}};
}

FoundPackings found_packings(const PackingProblem& problem, const SearchOptions& search, const KindOptions& options)
{
    options.say_note(note_on(problem, search));
    const auto shard = parse_shard(options.command(), search.shard).value_or(Shard{});
    if (!search.checkpoint.empty())
        say_when_interrupted("the same command goes on from " + printable(search.checkpoint.string()));
    SearchLine line(options.is_quiet());
    const ThreadLimit limit(search.threads);
    PackingSearchSettings settings{.checkpoint = search.checkpoint};
    settings.on_progress = [&](const PackingProgress& progress) { line.show(progress); };
    settings.on_unwritten = [&](const std::string& reason) {
        line.warn(reason);
        say_when_interrupted(fmt::format("the same command goes on from {} as it was last written",
                                         printable(search.checkpoint.string())));
    };
    const PackingTask task = search.all ? PackingTask::all : search.count ? PackingTask::count : PackingTask::first;
    FoundPackings found = search_packings({problem, task, shard.number, shard.count}, settings);
    if (task == PackingTask::first && found.packings.empty()) {
        if (search.shard.empty())
            throw InputError(fmt::format("there is no such packing of {} colours", problem.colors));
        options.say_note(fmt::format("shard {} has no such packing of {} colours", search.shard, problem.colors));
    }
    return found;
}

}
