// Tables of Penrose points: how good the built one is, its file, and the cache.
#include "host/tile_sampling/penrose/penrose_sampler.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/tile_sampling/penrose/penrose_relaxation.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace poissonlab {
namespace {

/// Radii of the worst sets that a table makes, over the importances of a level, which has all rows.
std::vector<double> radii_over_a_level(const PenroseTable& table, std::size_t level)
{
    const PenroseTiling tiling(table);
    std::vector<double> radii;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto [begin, end] = importances_of(tiling.scales, {level, row});
        for (const std::uint64_t importance : {begin, begin + (end - begin) / 3, end - 1}) {
            const PointSet points = point_set_of(reference::penrose_points(tiling, importance));
            radii.push_back(relative_radius(min_distance_in_window(points), points.size(), 2));
        }
    }
    std::ranges::sort(radii);
    return radii;
}

TEST(PenroseTable, KeepsPointsApartForAllNumbersOfPoints)
{
    const PenroseTable table = relaxed_penrose_table();
    for (const std::size_t level : {8U, 9U, 12U}) { // other sets than those that it was made with
        const auto radii = radii_over_a_level(table, level);
        EXPECT_GT(radii.front(), 0.6) << level;
        EXPECT_GT(radii[radii.size() / 2], 0.7) << level;
    }
    // Corners of the tiling themselves are nearer.
    EXPECT_LT(radii_over_a_level({}, 9).front(), 0.55);
}

constexpr PenroseRelaxation short_relaxation{.lloyd_rounds = 2, .push_rounds = 3, .lloyd_level = 8, .push_level = 8};

TEST(PenroseTable, IsTheSameForAnyNumberOfThreads)
{
    const PenroseTable table = relaxed_penrose_table(short_relaxation);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(relaxed_penrose_table(short_relaxation), table);
}

TEST(PenroseTable, TellsItsStepsWhichCanEndIt)
{
    int steps = 0;
    EXPECT_THROW(relaxed_penrose_table(short_relaxation,
                                       [&](const std::string& what) {
                                           EXPECT_EQ(what.substr(0, 18), "Penrose table: row");
                                           if (++steps == 3) throw std::runtime_error("enough");
                                       }),
                 std::runtime_error);
    EXPECT_EQ(steps, 3);
}

TEST(PenroseTableFile, IsReadAsItWasWrittenAndRefusedWhereItIsDamaged)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "penrose.table";
    PenroseTable table;
    table.rows[20][20] = {-123, 456};
    write_penrose_table(file, table);
    EXPECT_EQ(read_penrose_table(file), table);
    std::ostringstream content;
    content << std::ifstream(file).rdbuf();
    const std::string text = content.str();
    for (const std::size_t place : {std::size_t{5}, text.find("-123"), text.size() - 3}) {
        std::string damaged = text;
        damaged[place] = damaged[place] == '7' ? '8' : '7';
        folder.write("damaged.table", damaged);
        EXPECT_FALSE(read_penrose_table(folder.path() / "damaged.table")) << place;
    }
    folder.write("short.table", text.substr(0, text.size() / 2));
    folder.write("empty.table", "");
    folder.write("long.table", text + "0 0\n");
    for (const char* name : {"short.table", "empty.table", "long.table", "missing.table"})
        EXPECT_FALSE(read_penrose_table(folder.path() / name)) << name;
}

TEST(PenroseTableCache, ReadsWhatIsThereAndReplacesWhatIsDamaged)
{
    const TemporaryFolder folder;
    PenroseTable table;
    table.rows[3][4] = {5, 6};
    write_penrose_table(folder.path() / penrose_table_name(), table);
    const auto read = cached_penrose_table(folder.path());
    EXPECT_TRUE(read.cached);
    EXPECT_EQ(read.built, table);
    folder.write(penrose_table_name(), "damaged");
    const auto built = cached_penrose_table(folder.path());
    EXPECT_FALSE(built.cached);
    EXPECT_EQ(read_penrose_table(folder.path() / penrose_table_name()), built.built);
}

}
}
