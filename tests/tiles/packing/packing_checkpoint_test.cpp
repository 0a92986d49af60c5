// Searches for packings in parts: on threads, in shards, from checkpoints; and disks that fail.
#include "base/crew/thread_limit.hpp"
#include "base/errors/errors.hpp"
#include "base/files/file_lock.hpp"
#include "base/files/whole_file.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/interrupt_scope.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/packing/packing_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <set>
#include <thread>

namespace poissonlab {
namespace {

using testing::HasSubstr;

const PackingSearch all_wang{.problem = {TileKind::wang, 2}, .task = PackingTask::all};
const PackingSearch wang_count{.problem = {TileKind::wang, 2}, .task = PackingTask::count};

std::vector<std::vector<TileIndex>> tiles_of(const FoundPackings& found)
{
    std::vector<std::vector<TileIndex>> tiles;
    for (const TilePacking& packing : found.packings) tiles.push_back(packing.tiles);
    return tiles;
}

TEST(PackingThreads, HaveTheSameAnswersInTheSameOrder)
{
    const auto all = tiles_of(search_packings(all_wang));
    ASSERT_EQ(all.size(), 203'520u);
    // Rounds that are shorter than the search have several subtrees find a packing at once.
    const auto first_of = [](TileKind kind, PackingMethod method, std::uint64_t seed) {
        return tiles_of(search_packings({.problem = {kind, 3, method, seed}}, {.nodes_a_round = 5000}));
    };
    const auto corners = first_of(TileKind::corner, PackingMethod::fewest, 4);
    std::vector<std::vector<std::vector<TileIndex>>> firsts;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        firsts.push_back(first_of(TileKind::wang, PackingMethod::tiles, seed));
    for (const int threads : {1, 2, 3, 7}) {
        const ThreadLimit limit(threads);
        EXPECT_EQ(tiles_of(search_packings(all_wang)), all) << threads;
        EXPECT_EQ(first_of(TileKind::corner, PackingMethod::fewest, 4), corners) << threads;
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            EXPECT_EQ(first_of(TileKind::wang, PackingMethod::tiles, seed), firsts[seed - 1]) << threads;
    }
}

TEST(PackingShards, AddUpToTheWhole)
{
    for (const std::uint32_t shards : {1u, 2u, 3u, 300u}) {
        std::uint64_t count = 0;
        std::set<std::vector<TileIndex>> corners;
        for (std::uint32_t shard = 1; shard <= shards; ++shard) {
            PackingSearch search = wang_count;
            search.shard = shard, search.shards = shards;
            count += search_packings(search).count;
            search.problem.kind = TileKind::corner;
            search.task = PackingTask::all;
            for (const auto& tiles : tiles_of(search_packings(search))) EXPECT_TRUE(corners.insert(tiles).second);
        }
        EXPECT_EQ(count, 203'520u) << shards;
        EXPECT_EQ(corners.size(), 32u) << shards;
    }
}

class PackingCheckpoint : public testing::Test
{
protected:
    /// Searches with an interrupt that comes before the first question whether one has come.
    void search_interrupted(const PackingSearch& search)
    {
        const InterruptScope scope;
        std::raise(SIGINT);
        EXPECT_THROW(search_packings(search, settings_), Interrupted);
    }

    std::string message_of_search(const PackingSearch& search) const
    {
        return message_of([&] { search_packings(search, settings_); });
    }

    const TemporaryFolder folder_;
    const PackingSearchSettings settings_{.checkpoint = folder_.path() / "search.txt"};
};

TEST_F(PackingCheckpoint, GoesOnWhereASearchWasInterrupted)
{
    const FoundPackings whole = search_packings(all_wang);
    for (int i = 0; i < 20; ++i) search_interrupted(all_wang);
    const std::string content = read_whole_file(settings_.checkpoint);
    const FoundPackings found = search_packings(all_wang, settings_);
    EXPECT_EQ(tiles_of(found), tiles_of(whole));
    EXPECT_EQ(found.nodes, whole.nodes) << "nothing is visited twice, and nothing is left out";
    EXPECT_NE(read_whole_file(settings_.checkpoint), content);
    // A finished search is not done again: an interrupt would stop any work.
    const InterruptScope scope;
    std::raise(SIGINT);
    EXPECT_EQ(search_packings(all_wang, settings_).count, 203'520u);
}

TEST_F(PackingCheckpoint, KeepsTheAnswerOfASearchForOne)
{
    const PackingSearch one{.problem = {TileKind::corner, 3, PackingMethod::fewest, 4}};
    const auto first = tiles_of(search_packings(one));
    for (int i = 0; i < 5; ++i) search_interrupted(one);
    EXPECT_EQ(tiles_of(search_packings(one, settings_)), first);
    EXPECT_EQ(tiles_of(search_packings(one, settings_)), first) << "the file has the answer";
}

/// A process that is killed leaves what was written last.
TEST_F(PackingCheckpoint, GoesOnFromTheStateThatWasWrittenLast)
{
    const auto board = make_packing_board(all_wang.problem);
    std::vector<PackingSubtree> subtrees = cut_tree(*board, 256).subtrees;
    std::uint64_t nodes = 0;
    for (std::size_t i = 0; i < subtrees.size(); i += 3) {
        walk(*board, subtrees[i], {.until_nodes = i * i});
        nodes += subtrees[i].nodes;
    }
    ASSERT_GT(nodes, 100'000u);
    write_search_file(settings_, all_wang, subtrees);
    const FoundPackings whole = search_packings(all_wang), found = search_packings(all_wang, settings_);
    EXPECT_EQ(tiles_of(found), tiles_of(whole));
    EXPECT_EQ(found.nodes, whole.nodes);
}

TEST_F(PackingCheckpoint, RefusesDamageAndOtherSearches)
{
    for (int i = 0; i < 3; ++i) search_interrupted(all_wang);
    const std::string whole = read_whole_file(settings_.checkpoint);
    const std::string damaged =
        settings_.checkpoint.string() + ": is damaged, or no checkpoint of a search for packings";
    for (std::size_t place = 0; place < whole.size(); place += whole.size() / 40 + 1) {
        std::string content = whole;
        content[place] = static_cast<char>(content[place] ^ 1);
        folder_.write("search.txt", content);
        EXPECT_EQ(message_of_search(all_wang), damaged) << place;
    }
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, whole.size() / 2, whole.size() - 1}) {
        folder_.write("search.txt", whole.substr(0, size));
        EXPECT_EQ(message_of_search(all_wang), damaged) << size;
    }
    folder_.write("search.txt", whole);
    PackingSearch other = all_wang;
    other.shards = 2;
    EXPECT_EQ(message_of_search(other),
              settings_.checkpoint.string() +
                  ": is of another search: all packings of Wang tiles over 2 colours by tiles, seed none, "
                  "65536 nodes a round, shard 1/1; this one is: all packings of Wang tiles over 2 colours by "
                  "tiles, seed none, 65536 nodes a round, shard 1/2");
    for (const PackingMethod method : {PackingMethod::pegs, PackingMethod::fewest}) {
        other = {.problem = {TileKind::corner, 2, method}, .task = PackingTask::count};
        EXPECT_THAT(message_of_search(other), HasSubstr("is of another search"));
    }
    EXPECT_EQ(read_whole_file(settings_.checkpoint), whole) << "it is left as it was";
    EXPECT_EQ(search_packings(all_wang, settings_).count, 203'520u);
}

TEST_F(PackingCheckpoint, SaysAtOnceThatAFileCannotBeWritten)
{
    EXPECT_THROW(search_packings(wang_count, {.checkpoint = folder_.path() / "none" / "search.txt"}), StorageError);
}

TEST_F(PackingCheckpoint, IsNotSharedWhereItCannotBeLocked)
{
    std::filesystem::create_directory(settings_.checkpoint.string() + ".lock");
    EXPECT_THROW(search_packings(wang_count, settings_), StorageError);
    EXPECT_FALSE(std::filesystem::exists(settings_.checkpoint));
}

TEST_F(PackingCheckpoint, IsOfOneProcessAtATime)
{
    const auto link = folder_.path() / "link.txt"; // another name of the file
    const std::string busy = ": another process is at work on this search: each needs a checkpoint of its own";
    {
        const auto other = FileLock::try_lock(settings_.checkpoint.string() + ".lock");
        ASSERT_TRUE(other);
        EXPECT_EQ(message_of_search(wang_count), settings_.checkpoint.string() + busy);
        EXPECT_FALSE(std::filesystem::exists(settings_.checkpoint));
        EXPECT_EQ(search_packings(wang_count, {.checkpoint = folder_.path() / "other.txt"}).count, 203'520u);
    }
    EXPECT_EQ(search_packings(wang_count, settings_).count, 203'520u) << "the lock is released";
    std::filesystem::create_symlink(settings_.checkpoint, link);
    const auto other = FileLock::try_lock(settings_.checkpoint.string() + ".lock");
    ASSERT_TRUE(other);
    EXPECT_EQ(message_of([&] { search_packings(wang_count, {.checkpoint = link}); }), link.string() + busy);
}

/// A search whose folder is away for a while.
class PackingDisk : public PackingCheckpoint
{
protected:
    PackingDisk()
    {
        std::filesystem::create_directory(here_);
        settings_.on_unwritten = [this](const std::string& reason) {
            ++told_;
            reason_ = reason;
        };
    }
    void unplug() const { std::filesystem::rename(here_, folder_.path() / "away"); }
    void plug_in() const { std::filesystem::rename(folder_.path() / "away", here_); }

    const std::filesystem::path here_ = folder_.path() / "here";
    PackingSearchSettings settings_{.checkpoint = here_ / "search.txt", .between_checkpoints = {}};
    std::atomic<int> told_ = 0;
    std::string reason_;
};

TEST_F(PackingDisk, ThatIsFullEndsNoSearch)
{
    struct Enough
    {
    };
    int calls = 0;
    std::string before;
    settings_.on_progress = [&](const PackingProgress&) {
        if (++calls == 1) return unplug();
        EXPECT_EQ(told_, 1) << "many writes have failed meanwhile";
        if (calls == 3) throw Enough();
        if (calls > 2) return;
        plug_in();
        before = read_whole_file(settings_.checkpoint);
    };
    const PackingSearch years{.problem = {TileKind::corner, 4}};
    EXPECT_THROW(search_packings(years, settings_), Enough);
    EXPECT_THAT(reason_, HasSubstr("search.txt"));
    EXPECT_EQ(calls, 3);
    const std::string after = read_whole_file(settings_.checkpoint);
    EXPECT_THAT(after, HasSubstr("\"nodes\""));
    EXPECT_NE(after, before) << "it is written again as soon as it can be";
}

TEST_F(PackingDisk, ThatIsFullHidesNotWhyASearchEnds)
{
    struct Reason
    {
    };
    settings_.on_progress = [&](const PackingProgress&) {
        unplug();
        throw Reason();
    };
    const PackingSearch years{.problem = {TileKind::corner, 4}};
    EXPECT_THROW(search_packings(years, settings_), Reason);
    EXPECT_EQ(told_, 1);
    EXPECT_THAT(reason_, HasSubstr("search.txt"));
}

TEST_F(PackingDisk, ThatIsFullAtTheEndLosesNoAnswer)
{
    std::jthread other([&](const std::stop_token& ended) {
        while (!std::filesystem::exists(settings_.checkpoint) && !ended.stop_requested()) std::this_thread::yield();
        unplug();
    });
    const FoundPackings found = search_packings(wang_count, settings_);
    other.join();
    EXPECT_EQ(found.count, 203'520u);
    EXPECT_THAT(found.unwritten, HasSubstr("search.txt"));
    plug_in();
    EXPECT_EQ(search_packings(wang_count, settings_).unwritten, "");
}

}
}
