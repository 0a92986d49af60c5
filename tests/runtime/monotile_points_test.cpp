// runtime/monotile_points.js against the C header, to the last bit, on the sets that ship; needs node.
#include "base/files/whole_file.hpp"
#include "runtime/monotile_points.h"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

std::string ready_monotile(const std::string& name)
{
    return source_folder() + "/runtime/tile_sets/" + name + ".ptiles";
}

/// Appends a window and its points, as same_monotile_points.js reads them.
void append_monotile_window(std::vector<double>& numbers, const pmono_set& set, std::uint32_t seed,
                            const std::array<std::int64_t, 2>& origin, const std::array<double, 4>& window,
                            double density)
{
    const auto find = [&](std::vector<pmono_point>& points) {
        return pmono_in_window(&set, seed, origin.data(), window.data(), window.data() + 2, points.data(),
                               points.size(), density);
    };
    std::vector<pmono_point> points;
    points.resize(find(points));
    find(points);
    numbers.insert(numbers.end(),
                   {double{1} * seed, static_cast<double>(origin[0]), static_cast<double>(origin[1]), window[0],
                    window[1], window[2], window[3], density, static_cast<double>(points.size())});
    for (const pmono_point& p : points)
        numbers.insert(numbers.end(), {p.position[0], p.position[1], p.level, double{1} * p.id, double{1} * p.index});
}

TEST(MonotileRuntime, JavaScriptHasThePointsOfTheHeader)
{
    if (run_in_shell(".", "command -v node").status != 0) GTEST_SKIP() << "no node";
    std::mt19937_64 random(4);
    for (const char* name : {"hat-n4", "spectre-n4"}) {
        const std::string bytes = read_whole_file(ready_monotile(name));
        pmono_set set;
        ASSERT_STREQ(pmono_open(&set, bytes.data(), bytes.size()), nullptr);
        std::vector<double> numbers;
        for (int i = 0; i < 40; ++i) {
            const int bits = 3 + i; // up to 2^40
            const auto place = [&] {
                return static_cast<std::int64_t>(random() >> (64 - std::min(bits, 41))) -
                       (std::int64_t{1} << std::min(bits - 1, 40));
            };
            const double x = static_cast<double>(random() % 4096) / 64 - 40,
                         y = static_cast<double>(random() % 4096) / 64 - 40;
            append_monotile_window(numbers, set, static_cast<std::uint32_t>(random()), {place(), place()},
                                   {x, y, x + 21.5, y + 13.25}, i % 3 == 0 ? 0.3 : 1);
        }
        append_monotile_window(numbers, set, 1, {7, -7}, {-100, -90, 110, 95}, 1);
        const TemporaryFolder folder;
        folder.write("expected", {reinterpret_cast<const char*>(numbers.data()), 8 * numbers.size()});
        const Outcome run =
            run_in_shell(folder.path(), "node " + quoted(source_folder() + "/tests/runtime/same_monotile_points.js") +
                                            " " + quoted(source_folder() + "/runtime/monotile_points.js") + " " +
                                            quoted(ready_monotile(name)) + " expected");
        ASSERT_EQ(run.status, 0) << run.error;
        EXPECT_GT(std::stoull(run.out), 10'000U);
    }
}

TEST(MonotileRuntime, JavaScriptRefusesWhatTheHeaderRefuses)
{
    if (run_in_shell(".", "command -v node").status != 0) GTEST_SKIP() << "no node";
    const std::string good = read_whole_file(ready_monotile("hat-n4"));
    const TemporaryFolder folder;
    std::mt19937 random(7);
    std::string files, expected;
    int refused = 0;
    for (int i = 0; i < 90; ++i) {
        std::string bytes = good;
        if (i % 3 == 0) bytes.resize(random() % (good.size() + 1));
        if (i % 3 == 1) bytes[random() % 128] = static_cast<char>(random());
        if (i % 3 == 2) bytes[random() % good.size()] = static_cast<char>(random());
        const auto file = folder.path() / std::to_string(i);
        write_whole_file(file, bytes);
        files += " " + quoted(file.string());
        pmono_set set;
        const char* problem = pmono_open(&set, bytes.data(), bytes.size());
        refused += problem != nullptr;
        expected += std::string(problem ? problem : "ok") + "\n";
    }
    EXPECT_GT(refused, 50);
    EXPECT_LT(refused, 90);
    const std::string script = R"js(
        const { MonotileSet } = require(process.argv[1]);
        for (const file of process.argv.slice(2)) {
            let said = "ok";
            try {
                new MonotileSet(require("fs").readFileSync(file));
            } catch (problem) {
                said = problem.message;
            }
            process.stdout.write(said + "\n");
        })js";
    const Outcome run =
        run_in_shell(folder.path(), "node -e " + quoted(script) + " " +
                                        quoted(source_folder() + "/runtime/monotile_points.js") + files);
    EXPECT_EQ(run.out, expected) << run.error;
}

}
}
