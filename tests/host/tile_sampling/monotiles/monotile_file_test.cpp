// Files with the points of monotiles: windows of the runtime header against the laboratory and against all distances,
// what their tables say of the tilings, and files that are damaged.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tiles/monotiles/monotile_file.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace poissonlab {
namespace {

using Origin = std::array<std::int64_t, 2>;
using Corner2 = std::array<double, 2>;

std::vector<pmono_point> window_points(const MonotilePointsFile& file, const Origin& origin, const Corner2& low,
                                       const Corner2& high, double density = 1, std::uint32_t seed = 1)
{
    const auto find = [&](std::vector<pmono_point>& points) {
        return pmono_in_window(&file.set(), seed, origin.data(), low.data(), high.data(), points.data(), points.size(),
                               density);
    };
    std::vector<pmono_point> points;
    points.resize(find(points));
    EXPECT_EQ(find(points), points.size());
    return points;
}

const std::string& file_bytes(const std::string& tiling, std::uint32_t points, std::uint32_t levels)
{
    static std::map<std::string, std::string> built;
    std::string& bytes = built[fmt::format("{} {} {}", tiling, points, levels)];
    if (bytes.empty()) bytes = built_monotile_file(built_in_tiling(tiling), points, levels);
    return bytes;
}

/// Returns how far the laboratory's tile is from the window's origin, by long doubles of 64 bits. Both coordinates are
/// whole + root sqrt(3), whose sum is far smaller than its terms.
Corner2 away_from(const PolygonTiling& tiling, const RingPlace& tile, const Origin& origin)
{
    const long double root = std::sqrt(3.0L), a = tile.c[0] - origin[0], b = tile.c[1], c = tile.c[2],
                      d = tile.c[3] - origin[1];
    if (tiling.lengths[1] > 1.5)
        return {static_cast<double>(a + c / 2 + 1.5L * b), static_cast<double>(root * (d + (b + c) / 2))};
    return {static_cast<double>(a + (c + root * b) / 2), static_cast<double>(d + (b + root * c) / 2)};
}

TEST(MonotileFile, WindowsHaveThePointsOfTheLaboratory)
{
    for (const char* word : {"hat", "spectre"})
        for (const auto& [count, levels] : {std::pair{1U, 0U}, {3U, 0U}, {2U, 1U}}) {
            SCOPED_TRACE(fmt::format("{}, {} points, {} levels", word, count, levels));
            const PolygonTiling& tiling = built_in_tiling(word);
            const MonotilePointsFile file(file_bytes(word, count, levels), word);
            const MonotileTable table = proven_monotile_table(file, tiling);
            const MonotilePoints laboratory(table);
            for (const Origin& origin :
                 {Origin{0, 0}, {12, -7}, {1'000'000'007, -998'244'353}, {-1'500'000'000, 900'000'000}}) {
                const RingPlace tile = laboratory.tile_at(
                    {static_cast<double>(origin[0]), static_cast<double>(origin[1]) * tiling.lengths[1]});
                const Corner2 away = away_from(tiling, tile, origin);
                constexpr double side = 50;
                const auto expected = laboratory.square(tile, side, count, {-away[0], -away[1]});
                const auto found = window_points(file, origin, {-side / 2, -side / 2}, {side / 2, side / 2});
                ASSERT_EQ(found.size(), expected.size());
                // Long doubles of numbers up to 2^31 are off by up to 2^-32; positions are off by up to 2^-31.
                for (std::size_t i = 0; i < found.size(); ++i)
                    for (std::size_t axis = 0; axis < 2; ++axis)
                        EXPECT_NEAR(found[i].position[axis], side * expected[i][axis], 0x1p-30);
            }
        }
}

// The windows are 10^12 edges away from the origin, at different places, and have half and all of the points.
TEST(MonotileFile, AllDistancesFarAwayAreThoseThatTheFilePromises)
{
    for (const char* word : {"hat", "spectre"})
        for (const std::uint32_t count : {1U, 2U, 3U, 8U}) {
            SCOPED_TRACE(fmt::format("{}, {} points", word, count));
            const MonotilePointsFile file(file_bytes(word, count, 0), word);
            const double promised = pmono_min_distance(&file.set());
            EXPECT_GT(file.relative_radius(), 0.79);
            const double side = std::sqrt(1500 / file.density());
            double least = 1e9, points = 0;
            for (const Origin& origin :
                 {Origin{std::int64_t{1} << 40, -(std::int64_t{1} << 40)}, {-987'654'321'012, 3}}) {
                const auto found = window_points(file, origin, {-side, 0.25}, {0, side + 0.25});
                points += static_cast<double>(found.size());
                for (const pmono_point& p : found)
                    for (const pmono_point* q = found.data(); q != &p; ++q)
                        least =
                            std::min(least, std::hypot(p.position[0] - q->position[0], p.position[1] - q->position[1]));
            }
            EXPECT_GT(least, promised - 0x1p-30);
            EXPECT_LT(least, promised * 1.02);
            EXPECT_NEAR(points, 3000, 60);
        }
}

TEST(MonotileFile, WindowsAreParts)
{
    const MonotilePointsFile file(file_bytes("spectre", 3, 0), "spectre");
    const auto all = window_points(file, {77, 5}, {-20, -20}, {20, 20});
    std::set<std::array<double, 3>> places;
    for (const pmono_point& p : all) places.insert({p.position[0], p.position[1], p.level});
    EXPECT_EQ(places.size(), all.size());
    std::size_t found = 0;
    for (const double x : {-20.0, -3.5})
        for (const double y : {-20.0, 11.25})
            for (const pmono_point& p :
                 window_points(file, {77, 5}, {x, y}, {x < -10 ? -3.5 : 20, y < 0 ? 11.25 : 20})) {
                ++found;
                EXPECT_TRUE(places.contains({p.position[0], p.position[1], p.level}));
            }
    EXPECT_EQ(found, all.size());
    // Another origin sees the same points from elsewhere, to the last bit: both places are integers.
    for (const pmono_point& p : window_points(file, {80, 1}, {-10, -10}, {10, 10}))
        EXPECT_TRUE(places.contains({p.position[0] + 3, p.position[1] - 4, p.level}));
    EXPECT_TRUE(window_points(file, {0, 0}, {1, 1}, {1, 2}).empty());
    EXPECT_TRUE(window_points(file, {0, 0}, {NAN, 1}, {1, 2}).empty());
    EXPECT_TRUE(window_points(file, {(std::int64_t{1} << 40) + 1, 0}, {0, 0}, {5, 5}).empty());
}

TEST(MonotileFile, PartsOfThePointsAreNestedAndAsManyAsAskedFor)
{
    for (const char* word : {"hat", "spectre"})
        for (const std::uint32_t count : {1U, 4U}) {
            const MonotilePointsFile file(file_bytes(word, count, 0), word);
            const auto all = window_points(file, {1'000'000, 1}, {-120, -120}, {120, 120}, 1, 9);
            for (const double density : {0.02, 0.25, 0.5, 0.9}) {
                const auto part = window_points(file, {1'000'000, 1}, {-120, -120}, {120, 120}, density, 9);
                std::size_t below = 0;
                for (const pmono_point& p : all) below += p.level < density;
                EXPECT_EQ(part.size(), below);
                // Random choice of the points would be off by a standard deviation of sqrt(f (1 - f) N).
                const double n = static_cast<double>(all.size()), chance = std::sqrt(density * (1 - density) * n);
                EXPECT_NEAR(static_cast<double>(part.size()), density * n, 2 * chance) << word << density;
            }
        }
}

// Points of any part by rank keep apart, also those of tiles that are alike and meet in threes around a corner. Of
// random points this many would have distances near 0.
TEST(MonotileFile, PartsOfThePointsAreSpread)
{
    for (const char* word : {"hat", "spectre"}) {
        const MonotilePointsFile file(file_bytes(word, 4, 0), word);
        for (const double density : {0.05, 0.1, 0.25, 0.5, 0.75}) {
            const double side = std::sqrt(2000 / (density * file.density()));
            const auto part = window_points(file, {1'000'000, 1}, {0, 0}, {side, side}, density);
            double least = 1e9;
            for (const pmono_point& p : part)
                for (const pmono_point* q = part.data(); q != &p; ++q)
                    least = std::min(least, std::hypot(p.position[0] - q->position[0], p.position[1] - q->position[1]));
            EXPECT_GT(relative_radius(least / side, part.size(), 2), 0.4) << word << ", density " << density;
        }
    }
}

// The growth of the number of tiles and the share of mirrored tiles follow from a file's tables alone: 4 + sqrt(15) for
// spectres; hats grow as the fourth power of the golden ratio, and one of 1 + that power is mirrored.
TEST(MonotileFile, TablesHaveTheSubstitutionOfThePapers)
{
    const double phi4 = std::pow((1 + std::sqrt(5.0)) / 2, 4);
    for (const char* word : {"hat", "spectre"})
        for (const std::uint32_t levels : {0U, 1U}) {
            const MonotilePointsFile file(file_bytes(word, 2, levels), word);
            const pmono_set& set = file.set();
            std::vector<double> shares(set.states, 1.0 / set.states);
            double growth = 0, mirrored = 0;
            for (int step = 0; step < 100; ++step) {
                std::vector<double> next(set.states);
                growth = 0;
                for (std::uint32_t s = 0; s < set.states; ++s)
                    for (std::uint32_t i = 0; i < pmono_half(set.state + 8 * s + 4); ++i, growth += shares[s])
                        next[pmono_word(set.part + 16 * (pmono_word(set.state + 8 * s) + i))] += shares[s];
                for (std::uint32_t s = 0; s < set.states; ++s) shares[s] = next[s] / growth;
            }
            for (std::uint32_t s = 0; s < set.states; ++s)
                if (pmono_half(set.state + 8 * s + 6) & 2) mirrored += shares[s];
            const bool is_hat = std::string(word) == "hat";
            EXPECT_NEAR(growth, is_hat ? phi4 : 4 + std::sqrt(15.0), 1e-12);
            if (is_hat) {
                EXPECT_NEAR(mirrored, 1 / (1 + phi4), 1e-12);
            }
        }
}

TEST(MonotileFile, DamagedFilesAreRefused)
{
    const std::string good = file_bytes("hat", 2, 0);
    EXPECT_TRUE(is_monotile_points(good));
    std::vector<std::string> cases{good.substr(0, 127), good.substr(0, good.size() - 1), good + 'x', std::string()};
    for (std::size_t at = 0; at < good.size(); at += at < 128 ? 1 : 61) {
        cases.push_back(good);
        cases.back()[at] ^= 1;
    }
    for (const std::string& bytes : cases) {
        const std::string said = message_of([&] { MonotilePointsFile(bytes, "a.ptiles"); });
        EXPECT_TRUE(said.starts_with("a.ptiles: ")) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos);
    }
    // Commands for square tiles say what such a file is.
    EXPECT_THAT(message_of([&] { decode_tile_set(good, "a.ptiles"); }), testing::HasSubstr("monotile"));
}

TEST(MonotileFile, ReadySetsAreWhatIsBuilt)
{
    for (const char* word : {"hat", "spectre"})
        EXPECT_EQ(read_whole_file(fmt::format("{}/runtime/tile_sets/{}-n4.ptiles", source_folder(), word)),
                  file_bytes(word, 4, 0));
}

}
}
