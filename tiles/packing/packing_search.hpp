// The search for tile packings: on all cores, in shards, with checkpoints and estimates of what is left.
//
// Lagae and Dutre: "our backtracking algorithm also supports parallelization, checkpointing and progress estimation"
// (Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.5.3). The tree is cut into subtrees. A search for
// one packing visits so many nodes of each subtree in turn, round after round, because some subtrees have a packing
// near their beginning and others have none for years. The packing that comes first, by round and by subtree, is the
// answer: it does not depend on the number of threads. A search for all packings does one subtree after another.
#pragma once

#include "tiles/packing/packing_subtree.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <vector>

namespace poissonlab {

enum class PackingTask
{
    first, ///< one packing
    all,   ///< every one
    count  ///< every one, without keeping them: one of each class of translations is searched
};

struct PackingSearch
{
    PackingProblem problem;
    PackingTask task = PackingTask::first;
    std::uint32_t shard = 1, shards = 1; ///< of every `shards` subtrees the one of this number, from 1 on
};

/// A search tells this while it goes on.
struct PackingProgress
{
    std::uint64_t nodes = 0;    ///< visited, with those of earlier processes
    std::uint64_t packings = 0; ///< found
    double share = 0;           ///< of the tree of this shard, by Knuth's weights
    double tree_nodes = 0;      ///< of the shard's part of the tree, estimated
    double nodes_per_second = 0;

    /// The seconds that all the rest takes, by the number of nodes.
    double seconds_left() const;
};

struct PackingSearchSettings
{
    std::filesystem::path checkpoint{}; ///< the file in which the search is kept; empty: none
    std::chrono::duration<double> between_checkpoints = std::chrono::seconds(30);
    std::uint64_t nodes_a_round = std::uint64_t{1} << 16;               ///< of each subtree
    std::function<void(const PackingProgress& progress)> on_progress{}; ///< one call at a time, some a second
    /// Is told why the checkpoint could not be written, the first time; the search goes on and tries again.
    std::function<void(const std::string& reason)> on_unwritten{};
};

struct FoundPackings
{
    std::vector<TilePacking> packings{}; ///< those that were asked for, in the order of the search
    std::uint64_t count = 0;             ///< of all packings of this shard; of a search for one: 1 or 0
    std::uint64_t nodes = 0;             ///< visited
    std::string unwritten{};             ///< why the file lacks the end of the search; empty: it has it
};

/// Searches on the threads that ThreadLimit allows, from where the checkpoint is, if there is one. Throws InputError
/// for problems that are not searched, for checkpoints of other searches or damaged ones, and for one that another
/// process is at work on (a lock on a file beside it, NAME.lock); StorageError where the checkpoint cannot be written
/// at the beginning; and Interrupted, as what on_progress throws, once the checkpoint is written. A checkpoint that
/// cannot be written later on stops no search.
FoundPackings search_packings(const PackingSearch& search, const PackingSearchSettings& settings = {});

/// The first packing with choices tried in a random order. Throws as above.
TilePacking random_packing(TileKind kind, Color colors, PackingMethod method, std::uint64_t seed);

/// Writes the state of a search into its checkpoint, whole or not at all. Throws StorageError.
void write_search_file(const PackingSearchSettings& settings, const PackingSearch& search,
                       const std::vector<PackingSubtree>& subtrees);

/// Reads it into the fresh subtrees of a search, whose empty board tells which paths there are. Throws InputError, one
/// line.
void read_search_file(const PackingSearchSettings& settings, const PackingSearch& search, PackingBoard& board,
                      std::vector<PackingSubtree>& subtrees);

}
