// Corner cubes and dominoes: neighbours match.
#include "tiles/tilings/cube_tiling.hpp"

#include "base/errors/errors.hpp"
#include "tests/tiles/tilings/tile_colors.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

constexpr HashKind cube_hashes[] = {HashKind::permutation, HashKind::long_period, HashKind::xxh64};

/// The eight corners; [up][north][east].
struct Corners
{
    Color at[2][2][2];
};

Corners corners_of(const CubeTiling& tiling, std::int64_t x, std::int64_t y, std::int64_t z)
{
    const Color c = tiling.tile_set().colors().horizontal;
    const auto d = test::digits(tiling.tile(x, y, z), {c, c, c, c, c, c, c, c});
    Corners corners{};
    for (std::size_t up = 0; up < 2; ++up) {
        const std::size_t first = up == 1 ? 0 : 4; // the top's digits come first: NE, SE, SW, NW
        corners.at[up][1][1] = d[first];
        corners.at[up][0][1] = d[first + 1];
        corners.at[up][0][0] = d[first + 2];
        corners.at[up][1][0] = d[first + 3];
    }
    return corners;
}

void expect_neighbours_match(const CubeTiling& tiling, std::int64_t x0, std::int64_t y0, std::int64_t z0)
{
    for (std::uint64_t i = 0; i < 6 * 6 * 6; ++i) {
        const std::int64_t x = stepped(x0, i % 6);
        const std::int64_t y = stepped(y0, i / 6 % 6);
        const std::int64_t z = stepped(z0, i / 36);
        const Corners here = corners_of(tiling, x, y, z);
        const Corners east = corners_of(tiling, stepped(x, 1), y, z);
        const Corners north = corners_of(tiling, x, stepped(y, 1), z);
        const Corners up = corners_of(tiling, x, y, stepped(z, 1));
        for (int a = 0; a < 2; ++a) {
            for (int b = 0; b < 2; ++b) {
                ASSERT_EQ(here.at[a][b][1], east.at[a][b][0]);
                ASSERT_EQ(here.at[a][1][b], north.at[a][0][b]);
                ASSERT_EQ(here.at[1][a][b], up.at[0][a][b]);
            }
        }
    }
}

TEST(CubeTiling, NeighboursMatch)
{
    for (const HashKind hash : cube_hashes) {
        for (Color c = 2; c <= 8; ++c) {
            for (const Period period : {Period{}, Period{4, 5, 3}, Period{0, 0, 2}}) {
                const CubeTiling tiling(c, hash, 1, period);
                expect_neighbours_match(tiling, -3, -3, -3);
                expect_neighbours_match(tiling, INT64_MAX - 2, INT64_MIN, INT64_MAX - 4);
                expect_neighbours_match(tiling, 123'456'789'012, -5'930'659'851, 77);
            }
        }
    }
}

TEST(CubeTiling, IsMadeOfTheHashFunction)
{
    for (const HashKind hash : cube_hashes) {
        const CubeTiling tiling(4, hash, 5);
        for (std::int64_t i = -50; i < 50; ++i) {
            const Corners corners = corners_of(tiling, i, 2 * i, 7 - i);
            for (int up = 0; up < 2; ++up) {
                for (int north = 0; north < 2; ++north) {
                    for (int east = 0; east < 2; ++east)
                        ASSERT_EQ(corners.at[up][north][east],
                                  std::visit([&](const auto& h) { return h(i + east, 2 * i + north, 7 - i + up); },
                                             tiling.hash()));
                }
            }
        }
    }
}

TEST(CubeTiling, ClosesAfterItsPeriod)
{
    const CubeTiling tiling(2, HashKind::xxh64, 1, {4, 0, 3});
    int differ = 0;
    for (std::int64_t i = -100; i < 100; ++i) {
        EXPECT_EQ(tiling.tile(i, i * i, -i), tiling.tile(i + 8, i * i, -i - 3));
        differ += tiling.tile(i, i * i, -i) != tiling.tile(i, i * i + 4, -i);
    }
    EXPECT_GT(differ, 0);
}

TEST(CubeTiling, StreamsLayersFromBottomToTop)
{
    const CubeTiling tiling(3, HashKind::permutation, 2);
    std::int64_t next = 0;
    tiling.stream({-5, -6, -7, 9000, 2, 3}, [&](auto x, auto y, auto z, std::span<const TileIndex> cubes) {
        // Two pieces a row, two rows a layer, three layers.
        EXPECT_EQ(x, next % 2 == 0 ? -5 : -5 + 8192);
        EXPECT_EQ(cubes.size(), next % 2 == 0 ? 8192u : 808u);
        EXPECT_EQ(y, next / 2 % 2 == 0 ? -5 : -6);
        EXPECT_EQ(z, -7 + next / 4);
        for (std::size_t i = 0; i < cubes.size(); ++i) ASSERT_EQ(cubes[i], tiling.tile(stepped(x, i), y, z));
        ++next;
    });
    EXPECT_EQ(next, 12);
}

TEST(CubeTiling, RefusesWhatItCannotTile)
{
    EXPECT_THROW(CubeTiling(1, HashKind::xxh64, 1), InputError);
    EXPECT_THROW(CubeTiling(17, HashKind::xxh64, 1), InputError);
    EXPECT_THROW(CubeTiling(2, HashKind::xxh64, 1, {0, 0, -1}), InputError);
    EXPECT_NO_THROW(CubeTiling(16, HashKind::long_period, 1));
}

TEST(DominoTiling, NeighboursMatch)
{
    for (const HashKind hash : cube_hashes) {
        for (Color c = 2; c <= 8; ++c) {
            for (const std::int64_t period : {0, 7}) {
                const DominoTiling tiling(c, hash, 1, period);
                for (const std::int64_t x0 : {std::int64_t{-100}, INT64_MAX - 50}) {
                    for (std::uint64_t i = 0; i < 200; ++i) {
                        const std::int64_t x = stepped(x0, i);
                        const auto here = test::digits(tiling.tile(x), {c, c}); // east, west
                        ASSERT_EQ(here[0], test::digits(tiling.tile(stepped(x, 1)), {c, c})[1]);
                    }
                }
            }
        }
    }
}

TEST(DominoTiling, ClosesAfterItsPeriod)
{
    const DominoTiling ring(2, HashKind::xxh64, 1, 7);
    const DominoTiling line(2, HashKind::xxh64, 1);
    int differ = 0;
    for (std::int64_t x = -70; x < 70; ++x) {
        EXPECT_EQ(ring.tile(x), ring.tile(x + 7));
        differ += line.tile(x) != line.tile(x + 7);
    }
    EXPECT_GT(differ, 0);
}

}
}
