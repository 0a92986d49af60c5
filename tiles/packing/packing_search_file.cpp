// Checkpoints of searches, as JSON: what is searched, and the subtrees that were begun. A checksum finds any damage.
#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/files/json_members.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "tiles/packing/packing_search.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <utility>

namespace poissonlab {
namespace {

constexpr int format_version = 1;

/// A subtree that was begun.
struct StoredSubtree
{
    std::size_t number = 0;
    PackingSubtree state;
};

template <Stored<StoredSubtree> S>
void members(JsonMembers& m, S& subtree)
{
    m.member("number", subtree.number);
    m.member("path", subtree.state.path);
    m.member("share", subtree.state.share);
    m.member("nodes", subtree.state.nodes);
    m.member("packings", subtree.state.packings);
    m.member("tiles", subtree.state.tiles);
    m.member("is_done", subtree.state.is_done);
}

/// Describes a search in words that differ where the subtrees or their turns do.
std::string search_words(const PackingSearchSettings& settings, const PackingSearch& search)
{
    static constexpr std::array methods{"tiles", "pegs", "pegs, fewest choices first", "symmetric packings"};
    static constexpr std::array tasks{"one packing", "all packings", "the number of packings"};
    const PackingProblem& problem = search.problem;
    return fmt::format("{} of {} tiles over {} colours by {}, seed {}, {} nodes a round, shard {}/{}",
                       tasks[static_cast<std::size_t>(search.task)], problem.kind == TileKind::wang ? "Wang" : "corner",
                       problem.colors, methods[static_cast<std::size_t>(problem.method)],
                       problem.seed ? fmt::to_string(*problem.seed) : "none", settings.nodes_a_round, search.shard,
                       search.shards);
}

std::string checksum_of(std::string_view text) { return fmt::format("{:016x}", xxh64_bytes(text)); }

}

void write_search_file(const PackingSearchSettings& settings, const PackingSearch& search,
                       const std::vector<PackingSubtree>& subtrees)
{
    std::vector<StoredSubtree> begun;
    for (std::size_t number = 0; number < subtrees.size(); ++number)
        if (subtrees[number].nodes > 0 || subtrees[number].is_done) begun.push_back({number, subtrees[number]});
    const std::string words = search_words(settings, search);
    const std::string text = json_text([&](JsonMembers& m) {
        m.format("packing-search", format_version);
        m.member("search", words);
        m.objects("subtrees", std::as_const(begun));
    });
    write_whole_file(settings.checkpoint, text + "\n" + checksum_of(text) + "\n");
}

void read_search_file(const PackingSearchSettings& settings, const PackingSearch& search, PackingBoard& board,
                      std::vector<PackingSubtree>& subtrees)
{
    const SourceLocation place{settings.checkpoint.string()};
    const std::string bytes = read_whole_file(settings.checkpoint);
    const std::size_t end = bytes.find('\n');
    const std::string text = bytes.substr(0, end);
    if (end == std::string::npos || bytes.substr(end + 1) != checksum_of(text) + "\n")
        throw InputError::at(place, "is damaged, or no checkpoint of a search for packings");
    const nlohmann::json json = parsed_json(text, settings.checkpoint.string());
    std::string words;
    std::vector<StoredSubtree> begun;
    JsonMembers m(StoredObject(json, settings.checkpoint));
    m.format("packing-search", format_version);
    m.member("search", words);
    if (words != search_words(settings, search))
        throw InputError::at(place, fmt::format("is of another search: {}; this one is: {}", printable(words),
                                                search_words(settings, search)));
    m.objects("subtrees", begun);
    const std::size_t colors = search.problem.colors, tiles = colors * colors * colors * colors;
    std::size_t least = 0; // each subtree has one place in the file, in ascending order
    for (StoredSubtree& stored : begun) {
        const bool is_there = stored.number >= least && stored.number < subtrees.size();
        least = stored.number + 1;
        if (is_there) {
            stored.state.depth = subtrees[stored.number].depth;
            stored.state.weight = subtrees[stored.number].weight;
        }
        const std::size_t kept = search.task == PackingTask::count ? 0 : stored.state.packings;
        if (!is_there || !has_path(board, subtrees[stored.number], stored.state.path) ||
            stored.state.tiles.size() != kept * tiles)
            throw InputError::at(place, "has a subtree that this search has not: another version may have written it");
        subtrees[stored.number] = std::move(stored.state);
    }
}

}
