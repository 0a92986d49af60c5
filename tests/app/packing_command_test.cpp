// poissonlab packing: what it prints is a packing, by its own words and by a reader of this test.
#include "tests/support/command_test.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/started_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sstream>
#include <thread>

namespace poissonlab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

using Rows = std::vector<std::vector<int>>;

Rows rows_of(const std::string& text)
{
    Rows rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        rows.emplace_back(std::istream_iterator<int>(words), std::istream_iterator<int>());
    }
    return rows;
}

/// True if the rows, north first, are a packing: by the digits of the indices alone.
bool is_packing(const Rows& rows, bool is_corner, int c)
{
    std::vector<int> all;
    const std::size_t side = rows.size();
    const auto digit = [&](std::size_t row, std::size_t column, int number) { // 0: the first, north or north-east
        int index = rows[row % side][column % side];
        for (int i = number; i < 3; ++i) index /= c;
        return index % c;
    };
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t column = 0; column < side; ++column) {
            all.push_back(rows[row][column]);
            const auto here = [&](int number) { return digit(row, column, number); };
            const auto east = [&](int number) { return digit(row, column + 1, number); };
            const auto south = [&](int number) { return digit(row + 1, column, number); };
            if (is_corner ? here(0) != east(3) || here(1) != east(2) : here(1) != east(3)) return false;
            if (is_corner ? here(2) != south(3) || here(1) != south(0) : here(2) != south(0)) return false;
        }
    std::ranges::sort(all);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i] != static_cast<int>(i)) return false;
    return all.size() == static_cast<std::size_t>(c * c * c * c);
}

class PackingCommand : public test::CommandTest
{
protected:
    PackingCommand() : CommandTest("packing") {}
};

TEST_F(PackingCommand, PrintsPackingsOfEveryMethod)
{
    for (const std::string colors : {"2", "3", "4", "5", "6"}) {
        const int c = std::stoi(colors);
        EXPECT_TRUE(is_packing(rows_of(printed("corner --colors " + colors)), true, c));
        EXPECT_TRUE(is_packing(rows_of(printed("wang --colors " + colors)), false, c));
        EXPECT_TRUE(is_packing(rows_of(printed("wang --method eulerian --colors " + colors)), false, c));
    }
    EXPECT_TRUE(is_packing(rows_of(printed("corner --colors 4 --method printed")), true, 4));
    EXPECT_TRUE(is_packing(rows_of(printed("corner --colors 3 --method grown --seed 4")), true, 3));
    EXPECT_TRUE(is_packing(rows_of(printed("wang --colors 3 --method search --seed 4")), false, 3));
    EXPECT_THAT(printed("corner --colors 4 --method printed"),
                testing::StartsWith("56 108 57 28 180 62 156 182 46 248 239 27 228 59 252 47\n"));
}

TEST_F(PackingCommand, PrintsAllOfTwoColors)
{
    const std::string all = printed("corner --colors 2 --all");
    EXPECT_EQ(std::ranges::count(all, '\n'), 32 * 4 + 31);
    EXPECT_TRUE(is_packing(rows_of(all.substr(0, all.find("\n\n") + 1)), true, 2));
}

TEST_F(PackingCommand, SearchesByEveryMethod)
{
    const std::vector<std::pair<std::string, int>> searches{{"corner --method fewest --colors ", 3},
                                                            {"corner --method pegs --seed 2 --colors ", 2},
                                                            {"corner --method symmetric --colors ", 4},
                                                            {"wang --method symmetric --colors ", 4},
                                                            {"wang --method search --colors ", 3}};
    for (const auto& [words, colors] : searches) {
        const std::string arguments = words + std::to_string(colors);
        const std::string rows = printed(arguments + " --threads 1");
        EXPECT_TRUE(is_packing(rows_of(rows), arguments[0] == 'c', colors)) << arguments;
        EXPECT_EQ(printed(arguments + " --threads 3"), rows);
    }
}

TEST_F(PackingCommand, CountsThoseOfTwoColorsAloneAndInShards)
{
    EXPECT_EQ(printed("corner --colors 2 --count"), "32\n");
    EXPECT_EQ(printed("corner --colors 2 --count --method fewest --checkpoint c.txt"), "32\n");
    EXPECT_EQ(printed("corner --colors 2 --count --method fewest --checkpoint c.txt"), "32\n") << "from its file";
    EXPECT_EQ(printed("wang --colors 2 --count"), "203520\n");
    int sum = 0;
    for (const std::string shard : {"1/3", "2/3", "3/3"})
        sum += std::stoi(printed("wang --colors 2 --count --shard " + shard));
    EXPECT_EQ(sum, 203'520);
}

/// A search of four colours is interrupted, goes on, is killed, and goes on: it loses nothing.
TEST_F(PackingCommand, GoesOnFromItsCheckpoint)
{
    const std::vector<std::string> words = {"packing", "corner", "--colors",     "4",    "--method", "search",
                                            "--seed",  "7",      "--checkpoint", "c.txt"};
    const auto nodes_after = [&](int signal) {
        const std::filesystem::path file = folder_.path() / "c.txt";
        const auto number_of_file = [&] { // of its inode: each write makes another one
            struct stat state = {};
            return ::stat(file.c_str(), &state) == 0 ? state.st_ino : 0;
        };
        const auto before = number_of_file();
        StartedProgram process(folder_.path(), words);
        // A search writes its file before it begins, and asks for interrupts after some thousands of nodes.
        for (int tries = 0; number_of_file() == before && tries < 6000; ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        process.send(signal);
        const int status = process.wait();
        if (signal == SIGINT) {
            EXPECT_EQ(WEXITSTATUS(status), 130);
            EXPECT_EQ(content_of(folder_.path() / "log"),
                      "poissonlab: note: the dissertation's search for one packing of 4 colours took 280 days of "
                      "processor time; --method symmetric takes a second\n"
                      "poissonlab: interrupted; the same command goes on from c.txt\n");
        }
        const std::string state = content_of(folder_.path() / "c.txt");
        double sum = 0;
        for (std::size_t at = 0; (at = state.find("\"nodes\":", at)) != std::string::npos; ++at)
            sum += std::stod(state.substr(at + 8));
        return sum;
    };
    const double first = nodes_after(SIGINT);
    EXPECT_GT(first, 0);
    EXPECT_GE(nodes_after(SIGKILL), first);
    EXPECT_GT(nodes_after(SIGINT), first);
    expect_error(
        "corner --colors 4 --method search --seed 8 --quiet --checkpoint c.txt",
        "c.txt: is of another search: one packing of corner tiles over 4 colours by tiles, seed 7, 65536 nodes "
        "a round, shard 1/1; this one is: one packing of corner tiles over 4 colours by tiles, seed 8, 65536 "
        "nodes a round, shard 1/1");
    folder_.write("c.txt", content_of(folder_.path() / "c.txt") + "x");
    expect_error("corner --colors 4 --method search --seed 7 --quiet --checkpoint c.txt",
                 "c.txt: is damaged, or no checkpoint of a search for packings");
}

/// The packing that the whole tree has first is in one of its shards; where a shard has none, that is an answer.
TEST_F(PackingCommand, HasShardsWithoutPackings)
{
    int found = 0, none = 0;
    for (int shard = 1; shard <= 8; ++shard) {
        const std::string words = "corner --colors 2 --method pegs --shard " + std::to_string(shard) + "/300";
        const Outcome outcome = run(words + " --out shard.svg");
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        if (outcome.out.empty()) {
            ++none;
            EXPECT_THAT(outcome.error, HasSubstr("poissonlab: note: shard " + std::to_string(shard) +
                                                 "/300 has no such packing of 2 colours\n"));
            EXPECT_FALSE(std::filesystem::exists(folder_.path() / "shard.svg"));
            EXPECT_EQ(printed(words + " --json --quiet"), "{\"tiles\": [\n]}\n");
        } else {
            ++found;
            EXPECT_TRUE(is_packing(rows_of(outcome.out), true, 2));
            std::filesystem::remove(folder_.path() / "shard.svg");
        }
    }
    EXPECT_GT(found, 0);
    EXPECT_GT(none, 0);
}

TEST_F(PackingCommand, VerifiesWhatItPrinted)
{
    folder_.write("p.txt", printed("corner --colors 3"));
    EXPECT_EQ(printed("corner --colors 3 --verify p.txt"),
              "p.txt: a packing of the complete corner tile set over 3 colours: 81 tiles, each once, all neighbours "
              "fit\n");
    // These numbers mean other tiles where colours are at edges.
    const Outcome outcome = run("wang --colors 3 --verify p.txt");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, HasSubstr("p.txt: tile 27 at (1, 0) does not fit to its "));
    expect_error("corner --colors 4 --verify p.txt", "p.txt:1: a row of 9 tiles: must have 16");
}

TEST_F(PackingCommand, DrawsTilesAndPuzzles)
{
    printed("wang --colors 2 --out tiles.png --puzzle puzzle.svg --piece 20");
    const test::Picture picture = test::decode_png(content_of(folder_.path() / "tiles.png"));
    EXPECT_EQ(picture.width, 4 * 32 + 2 * 8);
    const std::string puzzle = content_of(folder_.path() / "puzzle.svg");
    EXPECT_THAT(puzzle, HasSubstr("width=\"98mm\" height=\"98mm\" viewBox=\"0 0 98 98\""));
    EXPECT_THAT(puzzle, Not(HasSubstr("<rect")));
    EXPECT_THAT(puzzle, EndsWith("</svg>\n"));
    printed("corner --colors 2 --puzzle apart.svg --kerf 0.2");
    EXPECT_GT(content_of(folder_.path() / "apart.svg").size(), puzzle.size());
}

TEST_F(PackingCommand, WrongArguments)
{
    expect_error("cube --colors 2", "packing: KIND cube: must be one of \"corner\", \"wang\"");
    expect_error("corner --colors 1", "packing: --colors 1: must be an integer from 2 to 256");
    expect_error("corner --colors 2 --method serach",
                 "packing: --method serach: must be one of \"closed\", \"printed\", \"product\", \"eulerian\", "
                 "\"search\", \"pegs\", \"fewest\", \"symmetric\", \"grown\"; did you mean \"search\"?");
    expect_error("wang --colors 2 --method product", "packing: --method product: is for wang tiles of 3 colours");
    expect_error("corner --colors 3 --all", "packing: --all with --colors 3: must be 2, nobody has seen all others");
    expect_error("corner --colors 2 --method eulerian", "packing: --method eulerian: is for wang tiles");
    expect_error("wang --colors 3 --method grown", "packing: --method grown: is for corner tiles of 3 colours");
    expect_error("corner --colors 17 --out a.png", "packing: --colors 17: must be at most 16 for a picture");
    expect_error("corner --colors 3 --out a.jpg", "packing: --out a.jpg: must end in .png or .svg");
    expect_error("corner --colors 3 --puzzle a.png", "packing: --puzzle a.png: must end in .svg");
    expect_error("corner --colors 3 --puzzle a.svg --kerf 1",
                 "packing: --kerf 1: must be a number from 0 to 0.6, in millimetres");
    expect_error("corner --colors 3 --puzzle a.svg --piece nan",
                 "packing: --piece nan: must be a number from 5 to 500, in millimetres");
    expect_error("corner --colors 5 --method search", "packing: --method search: has at most 4 colours");
    expect_error("wang --colors 6 --method symmetric", "packing: --method symmetric: has at most 5 colours");
    expect_error("corner --colors 2 --method symmetric",
                 "packing: --method symmetric: is for corner tiles of 3 colours or more: of 2 there are none");
    expect_error("wang --colors 3 --method fewest", "packing: --method fewest: is for corner tiles");
    expect_error("corner --colors 5 --count", "packing: --colors 5: must be at most 4 to be searched");
    expect_error("corner --colors 2 --count --all", "packing: --all and --count: only one of them");
    expect_error("corner --colors 2 --count --out a.png",
                 "packing: --count prints only: not with --verify, --out or --puzzle");
    expect_error(
        "corner --colors 3 --checkpoint c.txt",
        "packing: --checkpoint: is for searches only: --all, --count, --method search, pegs, fewest or symmetric");
    expect_error("corner --colors 3 --method search --shard 4/3",
                 "packing: --shard 4/3: must be i/n, with i from 1 to n");
    expect_error("corner --colors 5 --method printed", "packing: --method printed: has at most 4 colours");
    expect_error("corner --colors 3 --method printed --count --seed 5",
                 "packing: --method printed: cannot be combined with --count, which searches: must be search, pegs, "
                 "fewest or symmetric");
    const std::string random = ": is for one packing of --method eulerian, search, pegs, fewest, symmetric or grown";
    for (const std::string words : {"--method printed", "--method closed", "--count", "--all", "--verify p.txt"})
        expect_error("corner --colors 2 --seed 5 " + words, "packing: --seed 5" + random);
    expect_error("corner --colors 2 --threads 2", "packing: --threads 2: is for searches only");
    expect_error("corner --colors 2 --kerf 0.1", "packing: --piece and --kerf need --puzzle");
    expect_error("corner --colors 2 --method pegs --verify p.txt",
                 "packing: --method pegs: cannot be combined with --verify");
}

}
}
