// runtime/poisson_tiles.js against the C header: tiles, points of windows and nearest points of every kind of tiles, to
// the last bit. Needs node.
#include "base/files/whole_file.hpp"
#include "tests/runtime/tile_set_cases.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <random>

namespace poissonlab {
namespace {

using Numbers = std::vector<double>;

void append(Numbers& numbers, std::initializer_list<double> more) { numbers.insert(numbers.end(), more); }

void append_tiles(Numbers& numbers, const ptiles_tiling& tiling, std::mt19937& random, int count)
{
    append(numbers,
           {static_cast<double>(tiling.seed), static_cast<double>(tiling.period), 0.0, static_cast<double>(count)});
    for (int n = 0; n < count; ++n) {
        std::array<std::int32_t, 3> place{};
        for (std::uint32_t a = 0; a < tiling.set.dimension; ++a) place[a] = static_cast<std::int32_t>(random());
        append(numbers, {double{1} * place[0], double{1} * place[1], double{1} * place[2],
                         double{1} * ptiles_tile(&tiling, place[0], place[1], place[2])});
    }
}

/// Windows at any place of the plane, with borders inside of tiles.
void append_window(Numbers& numbers, const ptiles_tiling& tiling, std::mt19937& random, double side, double density)
{
    std::array<double, 3> low{}, high{};
    for (std::uint32_t a = 0; a < tiling.set.dimension; ++a) {
        low[a] = (static_cast<std::int32_t>(random()) >> 1) + static_cast<double>(random() >> 16) / 65536;
        high[a] = low[a] + side;
    }
    std::vector<ptiles_point> points(ptiles_in_window(&tiling, low.data(), high.data(), nullptr, 0, density));
    ptiles_in_window(&tiling, low.data(), high.data(), points.data(), points.size(), density);
    append(numbers, {double{1} * tiling.seed, double{1} * tiling.period, 1, low[0], low[1], low[2], high[0], high[1],
                     high[2], density, static_cast<double>(points.size())});
    for (const ptiles_point& p : points)
        append(numbers, {p.position[0], p.position[1], p.position[2], double{1} * p.index, double{1} * p.id, p.level,
                         double{1} * ptiles_class(&tiling.set, p.index)});
}

void append_nearest(Numbers& numbers, const ptiles_tiling& tiling, std::mt19937& random, int count)
{
    append(numbers, {double{1} * tiling.seed, double{1} * tiling.period, 2, static_cast<double>(count)});
    for (int n = 0; n < count; ++n) {
        std::array<double, 3> position{};
        for (std::uint32_t a = 0; a < tiling.set.dimension; ++a)
            position[a] = (static_cast<std::int32_t>(random()) >> 8) + static_cast<double>(random()) / 4294967296.0;
        ptiles_point p;
        const double squared = ptiles_nearest(&tiling, position.data(), &p);
        append(numbers, {position[0], position[1], position[2], squared, double{1} * p.tile[0], double{1} * p.tile[1],
                         double{1} * p.tile[2], double{1} * p.index});
    }
}

bool has_node() { return run_in_shell(".", "command -v node").status == 0; }

/// Runs the script over a tile set and what is expected of it, and gives the number of things compared.
std::uint64_t compared_by_node(const PoissonTileSet& set, const Numbers& numbers)
{
    const TemporaryFolder folder;
    write_tile_set(folder.path() / "set.ptiles", set);
    folder.write("expected", {reinterpret_cast<const char*>(numbers.data()), 8 * numbers.size()});
    const Outcome run =
        run_in_shell(folder.path(), "node " + quoted(source_folder() + "/tests/runtime/same_points.js") + " " +
                                        quoted(source_folder() + "/runtime/poisson_tiles.js") + " set.ptiles expected");
    EXPECT_EQ(run.status, 0) << run.error;
    return run.status == 0 ? std::stoull(run.out) : 0;
}

TEST(JavaScriptRuntime, HasThePointsOfTheHeader)
{
    if (!has_node()) GTEST_SKIP() << "no node";
    std::mt19937 random(5);
    for (const PoissonTileSet& set : tile_sets_of_every_kind()) {
        SCOPED_TRACE(name_of(set));
        Numbers numbers;
        for (const PoissonTiling& tiling : {PoissonTiling{1, 0}, {0xfedcba98, 0}, {7, 1}, {7, 5}, {7, INT32_MAX}}) {
            const ptiles_tiling runtime = runtime_tiling(set, tiling);
            append_tiles(numbers, runtime, random, 500);
            for (const double density : {1.0, 0.25, 0.6, 0.0}) append_window(numbers, runtime, random, 2.5, density);
            append_nearest(numbers, runtime, random, 50);
        }
        EXPECT_GT(compared_by_node(set, numbers), 2750U);
    }
}

TEST(JavaScriptRuntime, HasAMillionPointsOfTheHeader)
{
    if (!has_node()) GTEST_SKIP() << "no node";
    const PoissonTileSet set = with_random_ranks(random_chain_set(4, 20));
    std::mt19937 random(6);
    Numbers numbers;
    append_window(numbers, runtime_tiling(set, {3, 0}), random,
                  std::sqrt(1.05e6 / static_cast<double>(set.parameters.points_per_tile)), 1);
    EXPECT_GT(compared_by_node(set, numbers), 1'000'000U);
}

TEST(JavaScriptRuntime, RefusesWhatTheHeaderRefuses)
{
    if (!has_node()) GTEST_SKIP() << "no node";
    const TemporaryFolder folder;
    std::string bytes = tile_set_file_bytes(random_tile_set(PoissonTileKind::corner, 2, 3, 7));
    const std::string good = bytes;
    std::mt19937 random(7);
    const std::string script = R"js(
        const { TileSet } = require(process.argv[1]);
        for (const file of process.argv.slice(2)) {
            let said = "ok";
            try {
                new TileSet(require("fs").readFileSync(file));
            } catch (problem) {
                said = problem.message;
            }
            process.stdout.write(said + "\n");
        })js";
    std::string files, expected;
    for (int i = 0; i < 60; ++i) {
        bytes = good;
        if (i % 3 == 0) bytes.resize(random() % (good.size() + 1));
        if (i % 3 == 1) bytes[random() % 128] = static_cast<char>(random());
        if (i % 3 == 2) bytes.push_back('x');
        const auto file = folder.path() / std::to_string(i);
        write_whole_file(file, bytes);
        files += " " + quoted(file.string());
        ptiles_set set;
        std::vector<std::uint16_t> aligned(bytes.size() / 2 + 1);
        std::memcpy(aligned.data(), bytes.data(), bytes.size());
        const char* problem = ptiles_open(&set, aligned.data(), bytes.size());
        expected += std::string(problem ? problem : "ok") + "\n";
    }
    const Outcome run = run_in_shell(folder.path(), "node -e " + quoted(script) + " " +
                                                        quoted(source_folder() + "/runtime/poisson_tiles.js") + files);
    EXPECT_EQ(run.out, expected) << run.error;
}

}
}
