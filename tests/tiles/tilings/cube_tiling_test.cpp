// Corner cubes and dominoes: neighbours match.
#include "tiles/tilings/scanline_tiling.hpp"

#include "base/errors/errors.hpp"
#include "tests/tiles/tilings/tile_colors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

constexpr HashKind cube_hashes[] = {HashKind::permutation, HashKind::long_period, HashKind::xxh64,
                                    HashKind::two_tables};

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

/// North, east, south, west, top, bottom.
std::vector<Color> faces_of(const CubeTiling& tiling, std::int64_t x, std::int64_t y, std::int64_t z)
{
    const Color c = tiling.tile_set().colors().horizontal;
    return test::digits(tiling.tile(x, y, z), {c, c, c, c, c, c});
}

TEST(WangCubeTiling, NeighboursMatch)
{
    for (const HashKind hash : cube_hashes)
        for (const Color colors : {2U, 3U, 8U})
            for (const Period period : {Period{}, Period{4, 5, 3}}) {
                const CubeTiling tiling(colors, hash, 1, period, TileKind::wang_cube);
                for (std::int64_t i = -40; i < 40; ++i) {
                    const std::int64_t x = i, y = 3 - i, z = 7 * i;
                    const auto here = faces_of(tiling, x, y, z);
                    ASSERT_EQ(here[0], faces_of(tiling, x, y + 1, z)[2]);
                    ASSERT_EQ(here[1], faces_of(tiling, x + 1, y, z)[3]);
                    ASSERT_EQ(here[4], faces_of(tiling, x, y, z + 1)[5]);
                    if (period.x > 0) {
                        ASSERT_EQ(here, faces_of(tiling, x - 4, y + 10, z + 3));
                    }
                }
            }
}

TEST(WangCubeTiling, HasAllCubesEquallyOften)
{
    // 64 cubes at 40 x 40 x 40 places, two apart so that they share no faces: chi-square with 63 degrees of freedom
    // passes 103.4 once in a thousand.
    const CubeTiling tiling(2, HashKind::xxh64, 3, {}, TileKind::wang_cube);
    ASSERT_EQ(tiling.tile_set().size(), 64);
    std::vector<double> counts(64);
    for (std::int64_t x = 0; x < 80; x += 2)
        for (std::int64_t y = 0; y < 80; y += 2)
            for (std::int64_t z = 0; z < 80; z += 2) ++counts.at(tiling.tile(x, y, z));
    double chi_square = 0;
    for (const double count : counts) chi_square += (count - 1000) * (count - 1000) / 1000;
    EXPECT_LT(chi_square, 103.4);
}

TEST(WangCubeTiling, FacesAreThoseOfTheIndex)
{
    for (TileIndex index = 0; index < 729; ++index) {
        const WangCube cube = wang_cube(index, 3);
        const auto digits = test::digits(index, {3, 3, 3, 3, 3, 3});
        ASSERT_EQ(digits, (std::vector<Color>{cube.north, cube.east, cube.south, cube.west, cube.top, cube.bottom}));
        ASSERT_EQ(wang_cube_index(cube, 3), index);
    }
}

TEST(DominoTiling, IsStreamedAsItIs)
{
    const DominoTiling tiling(3, HashKind::permutation, 9);
    std::vector<TileIndex> streamed;
    tiling.stream({-5, 0, 0, 10'000, 1, 1}, [&](std::int64_t x, auto, auto, std::span<const TileIndex> dominoes) {
        ASSERT_EQ(x, -5 + static_cast<std::int64_t>(streamed.size()));
        streamed.insert(streamed.end(), dominoes.begin(), dominoes.end());
    });
    ASSERT_EQ(streamed.size(), 10'000);
    for (std::size_t i = 0; i < streamed.size(); ++i)
        ASSERT_EQ(domino(streamed[i], 3), (Domino{domino(tiling.tile(static_cast<std::int64_t>(i) - 5), 3).east,
                                                  tiling.tile(static_cast<std::int64_t>(i) - 5) % 3}));
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

/// Cohen and others, 2003, section 5: 32 cubes of two colours. Faces that meet agree, cubes are of the set, and, as all
/// faces but one of a cube are independent, all cubes are as frequent: by a chi-squared test of C^5 - 1 degrees of
/// freedom, whose mean is that number and whose standard deviation is the square root of twice it.
TEST(ScanlineCubes, FitAndAreAsFrequent)
{
    for (const Color colors : {2u, 3u})
        for (const bool is_compact : {true, false}) {
            const TileSet set =
                is_compact ? compact_wang_cube_set(colors) : TileSet::complete(TileKind::wang_cube, colors);
            const double exponent = is_compact ? 5 : 6;
            EXPECT_EQ(set.size(), static_cast<std::uint64_t>(std::pow(colors, exponent)));
            constexpr std::uint64_t width = 40, height = 30, depth = 25;
            std::vector<WangCube> cubes(width * height * depth);
            std::vector<double> counts(set.size());
            std::size_t next = 0;
            stream_scanline_cubes(colors, is_compact, 7, width, height, depth,
                                  [&](std::int64_t x, std::int64_t y, std::int64_t z, std::span<const TileIndex> row) {
                                      EXPECT_EQ(x, 0);
                                      EXPECT_EQ(y, static_cast<std::int64_t>(height - 1 - next / width % height));
                                      EXPECT_EQ(z, static_cast<std::int64_t>(next / width / height));
                                      for (const TileIndex tile : row) {
                                          ++counts.at(set.position(tile).value());
                                          cubes.at(next++) = wang_cube(tile, colors);
                                      }
                                  });
            ASSERT_EQ(next, cubes.size());
            for (std::size_t i = 0; i < cubes.size(); ++i) {
                if (i % width > 0) {
                    ASSERT_EQ(cubes[i].west, cubes[i - 1].east);
                }
                if (i / width % height > 0) {
                    ASSERT_EQ(cubes[i].north, cubes[i - width].south);
                }
                if (i >= width * height) {
                    ASSERT_EQ(cubes[i].bottom, cubes[i - width * height].top);
                }
            }
            const double expected = static_cast<double>(cubes.size()) / static_cast<double>(set.size());
            double squares = 0;
            for (const double count : counts) squares += (count - expected) * (count - expected) / expected;
            const double freedom = static_cast<double>(set.size()) - 1;
            EXPECT_NEAR(squares, freedom, 5 * std::sqrt(2 * freedom)) << colors << is_compact;
        }
    int calls = 0;
    const auto count = [&](auto, auto, auto, std::span<const TileIndex> row) { calls += row.empty() ? 100 : 1; };
    stream_scanline_cubes(2, true, 1, 1, 1, 1, count);
    stream_scanline_cubes(2, true, 1, 3, 2, 0, count);
    EXPECT_EQ(calls, 1);
    EXPECT_THROW(stream_scanline_cubes(2, true, 1, 1 << 20, 1 << 20, 1, count), InputError);
    EXPECT_THROW(compact_wang_cube_set(17), InputError);
}

}
}
