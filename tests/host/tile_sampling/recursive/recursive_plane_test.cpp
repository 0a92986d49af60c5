// Windows of recursive Wang tiles in the plane: against whole tilings that are subdivided plainly, at any depth and any
// distance from the origin.
#include "host/tile_sampling/recursive/recursive_plane.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/tile_construction/recursive/recursive_construction.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <set>
#include <tuple>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;

constexpr std::uint32_t plane_tile_points = 128;
constexpr std::uint32_t plane_seed = 7;

const RecursiveTileSet& plane_set()
{
    static const RecursiveTileSet set = build_recursive_tiles(plane_tile_points, 1);
    return set;
}

RecursiveRoot root_here(std::int64_t x, std::int64_t y) { return plane_root(plane_seed, x, y); }

RecursiveWindow window_at(const char* x, const char* y, std::uint32_t width, std::uint32_t height)
{
    return {{read_recursive_address(x), read_recursive_address(y)}, {width, height}};
}

int level_of(const RecursiveWindow& window) { return static_cast<int>(window.corner[0].digits.size()); }

/// The points of a window with so many of them a tile.
std::vector<RecursivePoint> dense_points(const RecursiveWindow& window, std::uint64_t per_tile)
{
    const std::uint64_t tiles = std::uint64_t{window.size[0]} * window.size[1];
    return window_points(plane_set(), root_here, window,
                         {per_tile * tiles, {window.size[0], window.size[1]}, level_of(window), {}});
}

using Positions = std::vector<std::array<double, 2>>;

Positions positions_in(const RecursiveWindow& window, const std::vector<RecursivePoint>& points)
{
    Positions positions;
    for (const RecursivePoint& point : points) positions.push_back(place_in_window(window, point));
    std::ranges::sort(positions);
    return positions;
}

/// A tiling that is subdivided as a whole: all points with their thresholds, by the definition alone.
struct WholeTiling
{
    struct Point
    {
        std::array<std::int64_t, 2> at; ///< in units of 2^-40 tiles of level 0
        double threshold;               ///< points per tile of level 0 from which on it is there
    };
    std::vector<Point> points;

    /// The place of a point of a tile by its links, 20 of them.
    static std::array<std::int64_t, 2> followed(std::size_t tile, std::uint32_t point, int levels)
    {
        std::array<std::int64_t, 2> at{};
        for (int i = 0; i < levels; ++i) {
            const RecursiveLink link = plane_set().tile(tile).links[point];
            at = {4 * at[0] + (link.cell() & 3), 4 * at[1] + (link.cell() >> 2)};
            tile = plane_set().tile(tile).children[link.cell()];
            point = link.point();
        }
        return at;
    }

    void subdivide(std::size_t tile, std::array<std::int64_t, 2> corner, double turn, int level, int deepest)
    {
        constexpr std::array<int, 16> turns{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
        const RecursiveTile& all = plane_set().tile(tile);
        for (std::uint32_t rank = level == 0 ? 0 : plane_tile_points; rank < all.links.size(); ++rank) {
            const RecursiveLink link = all.links[rank];
            const auto inside = followed(all.children[link.cell()], link.point(), 19 - level);
            const int down = 2 * (19 - level);
            points.push_back({{corner[0] + ((std::int64_t{link.cell() & 3} << down) + inside[0]),
                               corner[1] + ((std::int64_t{link.cell() >> 2} << down) + inside[1])},
                              (rank + turn) * std::pow(16, level)});
        }
        if (level == deepest) return;
        const int down = 2 * (19 - level);
        for (std::uint32_t cell = 0; cell < recursive_cells; ++cell)
            subdivide(all.children[cell],
                      {corner[0] + (std::int64_t{cell & 3} << down), corner[1] + (std::int64_t{cell >> 2} << down)},
                      (turns[cell] + turn) / 16, level + 1, deepest);
    }
};

/// Units of WholeTiling of a window's place.
std::array<std::int64_t, 2> units_of(const RecursiveWindow& window, const std::array<double, 2>& place)
{
    std::array<std::int64_t, 2> units{};
    for (std::size_t k = 0; k < 2; ++k) {
        std::int64_t corner = window.corner[k].base;
        for (const std::uint8_t digit : window.corner[k].digits) corner = 4 * corner + digit;
        const int down = 40 - 2 * level_of(window);
        units[k] = (corner << down) + static_cast<std::int64_t>(std::floor(std::ldexp(place[k], down)));
    }
    return units;
}

TEST(RecursivePlane, HasThePointsOfAWholeTilingThatIsCropped)
{
    WholeTiling whole;
    for (std::int64_t y = -2; y < 1; ++y)
        for (std::int64_t x = -2; x < 1; ++x) {
            const RecursiveRoot root = root_here(x, y);
            whole.subdivide(root.tile, {x << 40, y << 40}, std::ldexp(static_cast<double>(root.turn), -32), 0, 2);
        }
    for (const auto& [window, per_tile] :
         {std::tuple{window_at("-2", "-2", 3, 3), 1}, std::tuple{window_at("-2", "-1", 3, 1), 2000},
          std::tuple{window_at("-1:3", "-2:1", 3, 5), 0}, std::tuple{window_at("-1:3", "-2:1", 3, 5), 1},
          std::tuple{window_at("-1:3", "-2:1", 3, 5), 2}, std::tuple{window_at("-1:3", "-2:1", 3, 5), 3},
          std::tuple{window_at("-1:3", "-2:1", 3, 5), 130}, std::tuple{window_at("-1:33", "-1:20", 9, 2), 77},
          std::tuple{window_at("0:0123", "-1:3210", 40, 1), 5}, std::tuple{window_at("-1:2222", "-1:3333", 1, 2), 8}}) {
        const int level = level_of(window);
        const double asked = per_tile * std::pow(16, level);
        std::vector<std::array<std::int64_t, 2>> expected, found;
        const auto low = units_of(window, {0, 0});
        const auto high = units_of(window, {static_cast<double>(window.size[0]), static_cast<double>(window.size[1])});
        for (const WholeTiling::Point& point : whole.points)
            if (point.threshold <= asked && point.at[0] >= low[0] && point.at[1] >= low[1] && point.at[0] < high[0] &&
                point.at[1] < high[1])
                expected.push_back(point.at);
        for (const RecursivePoint& point : dense_points(window, static_cast<std::uint64_t>(per_tile)))
            found.push_back(units_of(window, place_in_window(window, point)));
        // The window cuts places at 2^-32 tiles of its own level or deeper ones.
        for (auto* units : {&expected, &found}) {
            for (auto& at : *units) at = {at[0] >> 8, at[1] >> 8};
            std::ranges::sort(*units);
        }
        EXPECT_EQ(found, expected) << level << " " << per_tile;
        EXPECT_NEAR(static_cast<double>(found.size()), per_tile * window.size[0] * window.size[1],
                    2.0 * std::sqrt(window.size[0] * window.size[1]) + 4 * (window.size[0] + window.size[1]));
    }
}

/// Places of a window's points that lie in another one, from that one's corner, exactly; both are of one level.
Positions cropped(const Positions& positions, std::array<double, 2> from, const RecursiveWindow& to)
{
    Positions inside;
    for (const auto& [x, y] : positions)
        if (x >= from[0] && y >= from[1] && x < from[0] + to.size[0] && y < from[1] + to.size[1])
            inside.push_back({x - from[0], y - from[1]});
    std::ranges::sort(inside);
    return inside;
}

TEST(RecursivePlane, HasTheSamePointsInWindowsThatOverlap)
{
    for (const std::string base : {"0", "2147483648", "-2147483649", "4503599627370400", "-4503599627370496"})
        for (const std::string digits : {"", ":0123", ":333333333333333333333333333333", ":1"})
            for (const std::uint64_t per_tile : {1ULL, 60ULL, 500ULL, 3000ULL}) {
                const RecursiveWindow large = window_at((base + digits).c_str(), ("5" + digits).c_str(), 6, 5);
                RecursiveWindow small = large;
                small.corner = {moved(large.corner[0], 2), moved(large.corner[1], 1)};
                small.size = {3, 4};
                const auto all = dense_points(large, per_tile), part = dense_points(small, per_tile);
                EXPECT_EQ(positions_in(small, part), cropped(positions_in(large, all), {2, 1}, small))
                    << base << digits << " " << per_tile;
                EXPECT_FALSE(part.empty());
                std::set<std::uint32_t> bits;
                for (const RecursivePoint& point : all) bits.insert(point_bits(plane_seed, large, point.origin));
                for (const RecursivePoint& point : part)
                    EXPECT_TRUE(bits.contains(point_bits(plane_seed, small, point.origin)));
                EXPECT_GT(bits.size(), all.size() * 99 / 100);
            }
}

/// A window four times as far zoomed in has the same points at the same density, and more places of each.
TEST(RecursivePlane, KeepsItsPointsWhenOneZoomsIn)
{
    std::string x = "-17", y = "2147483648";
    for (int level = 0; level < 60; ++level) {
        const RecursiveWindow out = window_at(x.c_str(), y.c_str(), 2, 2);
        x += (level == 0 ? ":" : "") + std::to_string(level * 7 % 4);
        y += (level == 0 ? ":" : "") + std::to_string(level * 5 % 3);
        const RecursiveWindow in = window_at(x.c_str(), y.c_str(), 4, 4);
        // Places are cut at 2^-32 tiles of the window's level or of a deeper one: here at what both have.
        const auto cut = [](double v) { return std::floor(v * 0x1p28); };
        Positions zoomed, before;
        for (const auto& [px, py] : positions_in(in, dense_points(in, 40))) zoomed.push_back({cut(px), cut(py)});
        for (const auto& [px, py] : positions_in(out, dense_points(out, 640))) {
            const double fx = 4 * px - in.corner[0].digits.back(), fy = 4 * py - in.corner[1].digits.back();
            if (fx >= 0 && fy >= 0 && fx < 4 && fy < 4) before.push_back({cut(fx), cut(fy)});
        }
        std::ranges::sort(zoomed);
        std::ranges::sort(before);
        ASSERT_GT(zoomed.size(), 600u);
        EXPECT_EQ(zoomed, before) << level;
    }
}

/// Less density leaves points where they are.
TEST(RecursivePlane, AddsPointsWithDensity)
{
    const RecursiveWindow window = window_at("3:0312", "9:2021", 5, 7);
    Positions before;
    for (const std::uint64_t per_tile : {0ULL, 1ULL, 2ULL, 3ULL, 50ULL, 127ULL, 128ULL, 129ULL, 2048ULL, 2100ULL}) {
        const Positions all = positions_in(window, dense_points(window, per_tile));
        EXPECT_TRUE(std::ranges::includes(all, before)) << per_tile;
        EXPECT_EQ(std::ranges::adjacent_find(all), all.end());
        before = all;
    }
}

double least_distance(const Positions& positions)
{
    double least = 1e300;
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (std::size_t j = i + 1; j < positions.size() && positions[j][0] - positions[i][0] < least; ++j)
            least = std::min(least, std::hypot(positions[i][0] - positions[j][0], positions[i][1] - positions[j][1]));
    return least;
}

/// Across borders of tiles of all levels: a window around a corner of tiles of level 0, and far down around one.
TEST(RecursivePlane, KeepsDistancesAcrossBorders)
{
    for (const char* x : {"-1", "7:333", "7:3333333333333333333333333333333", "-2147483648:0333333"})
        for (const std::uint64_t per_tile : {20ULL, 100ULL, 333ULL, 1500ULL}) {
            const std::string digits = std::string(x).substr(std::min(std::string(x).find(':'), std::string(x).size()));
            const RecursiveWindow window = window_at(x, ("-1" + digits).c_str(), 2, 2);
            const Positions positions = positions_in(window, dense_points(window, per_tile));
            EXPECT_GT(relative_radius(least_distance(positions), per_tile, 2), 0.47) << x << " " << per_tile;
        }
}

TEST(RecursivePlane, ChoosesTilesThatFit)
{
    std::array<int, even_wang_tiles> seen{};
    for (const std::int64_t far : {std::int64_t{0}, std::int64_t{1} << 31, -(std::int64_t{1} << 52)})
        for (std::int64_t y = -20; y < 20; ++y)
            for (std::int64_t x = -20; x < 20; ++x) {
                const RecursiveRoot root = root_here(far + x, y);
                ++seen[root.tile];
                EXPECT_GT(root.turn, 0u);
                EXPECT_LE(root.turn, std::uint64_t{1} << 32);
                EXPECT_TRUE(may_lie_beside(root.tile, root_here(far + x + 1, y).tile, 1, 0));
                EXPECT_TRUE(may_lie_beside(root.tile, root_here(far + x, y + 1).tile, 0, 1));
            }
    for (const int count : seen) EXPECT_NEAR(count, 600, 5 * std::sqrt(600));
    // Any 4 x 4 tiles have all sixteen turns.
    std::set<std::uint64_t> turns;
    for (std::int64_t i = 0; i < 16; ++i) turns.insert((root_here(i % 4 - 1, i / 4 + 3).turn - 1) * 16 >> 32);
    EXPECT_EQ(turns.size(), 16u);
}

/// Mean power over rings of frequencies of the points in a disk-like window (a raised cosine), by its definition.
std::vector<double> ring_powers(const Positions& positions, double side)
{
    const auto weight = [&](double v) { return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * v / side); };
    const double scale = std::sqrt(static_cast<double>(positions.size())) / side; // points along a unit
    std::vector<double> powers;
    for (const double frequency : {0.15, 0.25, 0.35, 0.7, 0.85, 1.0, 1.15, 1.6}) {
        double sum = 0;
        for (int direction = 0; direction < 48; ++direction) {
            const double angle = std::numbers::pi * direction / 48, f = frequency * scale * (1 + 0.002 * direction);
            std::complex<double> transform = 0;
            double squares = 0;
            for (const auto& [x, y] : positions) {
                const double w = weight(x) * weight(y);
                transform +=
                    w * std::polar(1.0, -2 * std::numbers::pi * f * (x * std::cos(angle) + y * std::sin(angle)));
                squares += w * w;
            }
            sum += std::norm(transform) / squares;
        }
        powers.push_back(sum / 48);
    }
    return powers;
}

/// The spectra of windows at several zooms are those of the torus: of each ring, the mean over sets, whose powers are
/// spread exponentially, within five standard deviations of both means.
TEST(RecursivePlane, HasTheSpectraOfTheTorus)
{
    constexpr std::uint64_t per_tile = 300;
    constexpr std::uint32_t side = 3;
    std::vector<double> torus(8, 0.0);
    constexpr int sets = 6;
    for (std::uint32_t i = 0; i < sets; ++i) {
        const RecursiveTiling tiling(plane_set(), side, stream_key(1, Purpose::recursive_tilings, i));
        const PointSet set = tiling.torus_points(RecursiveDensity(per_tile * 9, side, 0, {}));
        Positions positions;
        for (std::size_t k = 0; k < set.size(); ++k) positions.push_back({set[k][0] * side, set[k][1] * side});
        const auto powers = ring_powers(positions, side);
        for (std::size_t k = 0; k < powers.size(); ++k) torus[k] += powers[k] / sets;
    }
    for (const std::string digits : {"", ":20", ":0312203120", ":103210321032103210321032103210"}) {
        std::vector<double> plane(8, 0.0);
        for (int i = 0; i < sets; ++i) {
            const RecursiveWindow window =
                window_at((std::to_string(100 * i) + digits).c_str(), (std::to_string(i - 3) + digits).c_str(), 3, 3);
            const auto powers = ring_powers(positions_in(window, dense_points(window, per_tile)), side);
            for (std::size_t k = 0; k < powers.size(); ++k) plane[k] += powers[k] / sets;
        }
        for (std::size_t k = 0; k < plane.size(); ++k)
            EXPECT_NEAR(plane[k], torus[k], 5 * (plane[k] + torus[k]) / std::sqrt(48.0 * sets)) << digits << " " << k;
        EXPECT_LT(plane[0], 0.35);
        EXPECT_GT(plane[5], 1);
    }
}

TEST(RecursivePlane, FollowsDensities)
{
    const Density chess = density_of_values(2, 2, {1, 0, 0, 1}, "chess");
    const RecursiveWindow window = window_at("2147483648:3333333333333333", "-1:0000000000000001", 6, 2);
    const auto points = window_points(plane_set(), root_here, window, {6000, {6, 2}, level_of(window), chess});
    EXPECT_NEAR(static_cast<double>(points.size()), 6000, 3 * std::sqrt(6000));
    for (const auto& [x, y] : positions_in(window, points)) EXPECT_EQ(x < 3, y < 1);
    // Where it is 1 are just the points of that density everywhere.
    const auto even = window_points(plane_set(), root_here, window, {12'000, {6, 2}, level_of(window), {}});
    Positions part;
    for (const auto& place : positions_in(window, even))
        if ((place[0] < 3) == (place[1] < 1)) part.push_back(place);
    EXPECT_EQ(positions_in(window, points), part);
}

TEST(RecursiveAddresses, AreReadAndMoved)
{
    for (const std::string text : {"0", "-5", "-5:0132", "4503599627370496:3", "-4503599627370496"})
        EXPECT_EQ(text_of(read_recursive_address(text)), text);
    const auto sum = [](const char* text, std::int64_t by) { return text_of(moved(read_recursive_address(text), by)); };
    EXPECT_EQ(sum("-1:333", 1), "0:000");
    EXPECT_EQ(sum("0:000", -1), "-1:333");
    EXPECT_EQ(sum("7", -9), "-2");
    EXPECT_EQ(sum("7:12", 64), "11:12");
    EXPECT_EQ(sum("7:12", -7), "6:33");
    for (const std::string text : {"", ":", "1:", "1:4", "x", "1:0 ", "+1", "1.5", "4503599627370497", "1e3",
                                   "99999999999999999999", "-9223372036854775808", "--1", "1:-1"})
        EXPECT_THAT(refusal_of([&] { static_cast<void>(read_recursive_address(text)); }), HasSubstr("must be a tile"))
            << text;
    EXPECT_EQ(read_recursive_address("1:" + std::string(1000, '2')).digits.size(), 1000u);
    EXPECT_NE(refusal_of([&] { static_cast<void>(read_recursive_address("1:" + std::string(1001, '2'))); }),
              "accepted");
}

/// A thousand levels down, a tile has just its own points at N of them.
TEST(RecursivePlane, GoesDownAThousandLevels)
{
    const std::string digits(1000, '2');
    const RecursiveWindow window = window_at(("4503599627370495:" + digits).c_str(), ("1:" + digits).c_str(), 1, 1);
    auto places = positions_in(window, dense_points(window, plane_tile_points));
    bool is_a_tile = false;
    for (std::size_t tile = 0; tile < even_wang_tiles; ++tile) {
        Positions own;
        for (const RecursivePlace& place : plane_set().places(tile))
            own.push_back({place[0] * 0x1p-32, place[1] * 0x1p-32});
        std::ranges::sort(own);
        is_a_tile = is_a_tile || own == places;
    }
    EXPECT_TRUE(is_a_tile);
}

}
}
