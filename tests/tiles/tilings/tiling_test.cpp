// Direct tilings: neighbours match, whatever the algorithm, hash function, place and period.
#include "tiles/tilings/tiling.hpp"

#include "base/errors/errors.hpp"
#include "tests/tiles/tilings/tile_colors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace poissonlab {
namespace {

constexpr DirectAlgorithm algorithms[] = {DirectAlgorithm::corner, DirectAlgorithm::wang_two_hashes,
                                          DirectAlgorithm::wang_one_hash, DirectAlgorithm::wang_edge_hash};
constexpr HashKind tiling_hashes[] = {HashKind::permutation, HashKind::long_period, HashKind::xxh64,
                                      HashKind::two_tables};

/// Lower left corners of windows around the origin, far away, and across both ends of the coordinates and of their
/// halves.
constexpr std::array<std::int64_t, 2> places[] = {
    {-20, -12},
    {1'000'000'007, -5'930'659'848},
    {INT64_MAX - 10, INT64_MIN + 3},
    {INT64_MIN + 30, INT64_MAX - 7},
    {(std::int64_t{1} << 62) - 9, -(std::int64_t{1} << 62) - 9},
};
constexpr std::uint64_t plane_width = 40;
constexpr std::uint64_t plane_height = 24;

test::Sides sides_of(const Tiling& tiling, std::int64_t x, std::int64_t y)
{
    const WangColors c = tiling.tile_set().colors();
    const TileIndex index = tiling.tile(x, y);
    EXPECT_TRUE(tiling.tile_set().position(index)) << index;
    return tiling.tile_set().kind() == TileKind::corner ? test::corner_sides(index, c.horizontal)
                                                        : test::wang_sides(index, c);
}

void expect_neighbours_match(const Tiling& tiling)
{
    for (const auto& [x0, y0] : places) {
        for (std::uint64_t i = 0; i < plane_width; ++i) {
            for (std::uint64_t j = 0; j < plane_height; ++j) {
                const std::int64_t x = stepped(x0, i);
                const std::int64_t y = stepped(y0, j);
                const test::Sides here = sides_of(tiling, x, y);
                ASSERT_EQ(here.east, sides_of(tiling, stepped(x, 1), y).west) << x << " " << y;
                ASSERT_EQ(here.north, sides_of(tiling, x, stepped(y, 1)).south) << x << " " << y;
            }
        }
    }
}

TEST(Tiling, NeighboursMatch)
{
    for (const DirectAlgorithm algorithm : algorithms) {
        for (const HashKind hash : tiling_hashes) {
            for (Color c = 2; c <= 8; ++c) {
                for (const Period period : {Period{}, Period{7, 5, 0}, Period{0, 16, 0}, Period{1, 0, 0}})
                    expect_neighbours_match(Tiling(algorithm, {c, c}, hash, 1, period));
            }
        }
    }
}

TEST(Tiling, NeighboursMatchWithTwoNumbersOfColors)
{
    for (const auto algorithm : {DirectAlgorithm::wang_two_hashes, DirectAlgorithm::wang_edge_hash}) {
        for (const HashKind hash : tiling_hashes) {
            for (const WangColors c : {WangColors{2, 3}, WangColors{7, 4}, WangColors{256, 2}})
                expect_neighbours_match(Tiling(algorithm, c, hash, 1));
        }
    }
}

/// The colours of a tile by the definitions of section 3.3, from the tiling's hash functions.
TileIndex defined_tile(const Tiling& tiling, std::int64_t x, std::int64_t y)
{
    const auto at = [](const ColorHash& hash, std::int64_t px, std::int64_t py) {
        return std::visit([&](const auto& h) { return h(px, py); }, hash);
    };
    const ColorHash& h = tiling.hash();
    const ColorHash& v = tiling.algorithm() == DirectAlgorithm::wang_two_hashes ? tiling.vertical_hash() : h;
    const Color c = tiling.tile_set().colors().horizontal;
    std::array<Color, 4> digits{};
    if (tiling.algorithm() == DirectAlgorithm::corner)
        digits = {at(h, x + 1, y + 1), at(h, x + 1, y), at(h, x, y), at(h, x, y + 1)};
    else if (tiling.algorithm() == DirectAlgorithm::wang_edge_hash)
        digits = {at(h, 2 * x + 1, 2 * y + 2), at(h, 2 * x + 2, 2 * y + 1), at(h, 2 * x + 1, 2 * y),
                  at(h, 2 * x, 2 * y + 1)};
    else
        digits = {(at(h, x, y + 1) + at(h, x + 1, y + 1)) % c, (at(v, x + 1, y + 1) + at(v, x + 1, y)) % c,
                  (at(h, x + 1, y) + at(h, x, y)) % c, (at(v, x, y) + at(v, x, y + 1)) % c};
    return ((digits[0] * c + digits[1]) * c + digits[2]) * c + digits[3];
}

TEST(Tiling, IsThatOfTheDissertation)
{
    for (const DirectAlgorithm algorithm : algorithms) {
        for (const HashKind hash : tiling_hashes) {
            for (Color c = 2; c <= 8; ++c) {
                const Tiling tiling(algorithm, {c, c}, hash, 3);
                for (std::int64_t x = -30; x < 30; ++x) {
                    for (std::int64_t y = -30; y < 30; ++y) ASSERT_EQ(tiling.tile(x, y), defined_tile(tiling, x, y));
                }
            }
        }
    }
}

TEST(Tiling, DoesNotDependOnTheOrderOfEvaluation)
{
    std::mt19937_64 random(1);
    for (const DirectAlgorithm algorithm : algorithms) {
        for (const HashKind hash : tiling_hashes) {
            for (const Period period : {Period{}, Period{7, 5, 0}, Period{0, 1000, 0}}) {
                const Tiling tiling(algorithm, {3, 3}, hash, 1, period);
                for (const auto& [x0, y0] : places) {
                    std::map<std::array<std::int64_t, 2>, TileIndex> tiles;
                    for (std::uint64_t i = 0; i < 400; ++i) {
                        const std::int64_t x = stepped(x0, random() % plane_width);
                        const std::int64_t y = stepped(y0, random() % plane_height);
                        tiles[{x, y}] = tiling.tile(x, y);
                    }
                    const auto expect_same = [&](std::int64_t x, std::int64_t y, std::span<const TileIndex> row) {
                        for (std::size_t i = 0; i < row.size(); ++i) {
                            const auto known = tiles.find({stepped(x, i), y});
                            if (known == tiles.end()) continue;
                            ASSERT_EQ(row[i], known->second) << x << " " << y;
                        }
                    };
                    tiling.stream({x0, y0, plane_width, plane_height}, expect_same);
                    std::vector<TileIndex> row(plane_width);
                    for (std::uint64_t j = 0; j < plane_height; ++j) {
                        tiling.fill_row(x0, stepped(y0, j), row);
                        expect_same(x0, stepped(y0, j), row);
                    }
                }
            }
        }
    }
}

TEST(Tiling, StreamsEveryTileOnceFromNorthToSouthInPieces)
{
    for (const DirectAlgorithm algorithm : algorithms) {
        const Tiling tiling(algorithm, {4, 4}, HashKind::long_period, 1);
        const TileWindow window{-9000, -2, 20'000, 3};
        std::int64_t next_x = window.x;
        std::int64_t next_y = 0;
        std::size_t longest = 0;
        tiling.stream(window, [&](std::int64_t x, std::int64_t y, std::span<const TileIndex> tiles) {
            ASSERT_EQ(x, next_x);
            ASSERT_EQ(y, next_y);
            for (std::size_t i = 0; i < tiles.size(); ++i) ASSERT_EQ(tiles[i], tiling.tile(stepped(x, i), y));
            longest = std::max(longest, tiles.size());
            next_x += static_cast<std::int64_t>(tiles.size());
            if (next_x == window.x + 20'000) {
                next_x = window.x;
                --next_y;
            }
        });
        EXPECT_EQ(next_x, window.x);
        EXPECT_EQ(next_y, -3);
        EXPECT_EQ(longest, 8192u);
        tiling.stream({0, 0, 0, 5}, [](auto, auto, auto) { FAIL(); });
        tiling.stream({0, 0, 5, 0}, [](auto, auto, auto) { FAIL(); });
    }
}

TEST(Tiling, ClosesAfterItsPeriodAndNotElsewhere)
{
    for (const DirectAlgorithm algorithm : algorithms) {
        for (const HashKind hash : tiling_hashes) {
            const Tiling torus(algorithm, {3, 3}, hash, 1, {11, 6, 0});
            const Tiling cylinder(algorithm, {3, 3}, hash, 1, {11, 0, 0});
            const Tiling plane(algorithm, {3, 3}, hash, 1);
            std::array<int, 11> x_differ{};
            std::array<int, 6> y_differ{};
            int cylinder_differs = 0;
            for (std::int64_t x = -20; x < 20; ++x) {
                for (std::int64_t y = -20; y < 20; ++y) {
                    EXPECT_EQ(torus.tile(x, y), torus.tile(x + 11, y - 6));
                    EXPECT_EQ(cylinder.tile(x, y), cylinder.tile(x - 11, y));
                    cylinder_differs += cylinder.tile(x, y) != cylinder.tile(x, y + 6);
                    for (std::int64_t t = 1; t < 11; ++t) x_differ[t] += torus.tile(x, y) != torus.tile(x + t, y);
                    for (std::int64_t t = 1; t < 6; ++t) y_differ[t] += torus.tile(x, y) != torus.tile(x, y + t);
                    // Inside the period it is the tiling of the plane.
                    if (x >= 0 && x < 10 && y >= 0 && y < 5) {
                        EXPECT_EQ(torus.tile(x, y), plane.tile(x, y));
                    }
                }
            }
            EXPECT_THAT(std::span(x_differ).subspan(1), testing::Each(testing::Gt(0)));
            EXPECT_THAT(std::span(y_differ).subspan(1), testing::Each(testing::Gt(0)));
            EXPECT_GT(cylinder_differs, 0);
        }
    }
}

/// True if a region is the same so many tiles to the east, and to the north.
bool repeats(const Tiling& tiling, std::int64_t steps)
{
    for (std::int64_t x = 0; x < 40; ++x) {
        for (std::int64_t y = 0; y < 40; ++y) {
            if (tiling.tile(x, y) != tiling.tile(x + steps, y) || tiling.tile(x, y) != tiling.tile(x, y + steps))
                return false;
        }
    }
    return true;
}

TEST(Tiling, RepeatsWithItsHashFunction)
{
    struct Case
    {
        HashKind hash;
        Color colors;
        std::int64_t period;
        std::vector<std::int64_t> primes; // of the period
    };
    const Case cases[] = {{HashKind::permutation, 4, 256, {2}},
                          {HashKind::permutation, 5, 255, {3, 5, 17}},
                          {HashKind::long_period, 3, 5'930'659'848, {2, 3, 17, 19, 23, 29, 31, 37}}};
    for (const Case& c : cases) {
        for (const DirectAlgorithm algorithm : algorithms) {
            const Tiling tiling(algorithm, {c.colors, c.colors}, c.hash, 1);
            // The dense lattice has two points a tile: half of an even period.
            const bool halves = algorithm == DirectAlgorithm::wang_edge_hash && c.period % 2 == 0;
            const std::int64_t period = halves ? c.period / 2 : c.period;
            EXPECT_TRUE(repeats(tiling, period));
            for (const std::int64_t prime : c.primes) {
                if (period % prime == 0) {
                    EXPECT_FALSE(repeats(tiling, period / prime)) << period << " " << prime;
                }
            }
        }
    }
}

TEST(Tiling, FollowsFromItsSeed)
{
    for (const DirectAlgorithm algorithm : algorithms) {
        for (const HashKind hash : tiling_hashes) {
            std::vector<TileIndex> first(1000);
            std::vector<TileIndex> second(1000);
            Tiling(algorithm, {2, 2}, hash, 7).fill_row(0, 0, first);
            Tiling(algorithm, {2, 2}, hash, 7).fill_row(0, 0, second);
            EXPECT_EQ(first, second);
            Tiling(algorithm, {2, 2}, hash, 8).fill_row(0, 0, second);
            EXPECT_NE(first, second);
        }
    }
}

TEST(Tiling, RefusesWhatItCannotTile)
{
    const auto make = [](DirectAlgorithm algorithm, WangColors c, Period period = {}) {
        return Tiling(algorithm, c, HashKind::permutation, 1, period);
    };
    EXPECT_THROW(make(DirectAlgorithm::corner, {1, 1}), InputError);
    EXPECT_THROW(make(DirectAlgorithm::corner, {257, 257}), InputError);
    EXPECT_THROW(make(DirectAlgorithm::corner, {2, 3}), InputError);
    EXPECT_THROW(make(DirectAlgorithm::wang_one_hash, {2, 3}), InputError);
    EXPECT_THROW(make(DirectAlgorithm::wang_two_hashes, {2, 1}), InputError);
    EXPECT_THROW(make(DirectAlgorithm::corner, {2, 2}, {-1, 0, 0}), InputError);
    EXPECT_THROW(make(DirectAlgorithm::corner, {2, 2}, {0, std::int64_t{1} << 62, 0}), InputError);
    EXPECT_NO_THROW(make(DirectAlgorithm::corner, {256, 256}, {(std::int64_t{1} << 62) - 1, 0, 0}));
}

}
}
