// kernels/tile_points.cl against its plain twin, bit for bit, and the twin against the header for engines.
#include "host/tile_points/tile_points.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/random_tile_set.hpp"

#include <gmock/gmock.h>

#include <array>
#include <gtest/gtest.h>
#include <set>

#include <algorithm>

namespace poissonlab {
namespace {

struct Case
{
    PoissonTileKind kind;
    int dimension;
    std::uint32_t colors;
    std::uint32_t points;
    std::size_t work_group_size = 0;

    PoissonTileSet tiles() const { return random_tile_set(kind, dimension, colors, points, 13); }
};

void PrintTo(const Case& c, std::ostream* out)
{
    *out << static_cast<int>(c.kind) << " in " << c.dimension << "D, " << c.points << " points, groups of "
         << c.work_group_size;
}

class TilePoints : public testing::TestWithParam<Case>
{
protected:
    /// The block's layers in 2D.
    TileBlock block(std::array<std::int32_t, 3> lowest, std::array<std::uint32_t, 3> size) const
    {
        if (GetParam().dimension == 2) lowest[2] = 0, size[2] = 1;
        return {lowest, size};
    }

    std::vector<TileBlock> blocks() const
    {
        return {block({0, 0, 0}, {1, 1, 1}), block({-3, -2, -1}, {5, 7, 3}), block({1000, -70000, 2}, {33, 3, 2}),
                block({-7, INT32_MIN, 0}, {1, 20, 4})};
    }
};

constexpr PoissonTiling tilings[] = {{1, 0}, {0xfedcba98, 3}, {5, 1}};

TEST_P(TilePoints, AreThoseOfTheReference)
{
    const PoissonTileSet tiles = GetParam().tiles();
    TilePointGenerator generator(Device::open(), tiles, GetParam().work_group_size);
    for (const TileBlock& block : blocks()) {
        for (const PoissonTiling& tiling : tilings) {
            const std::size_t values = block.tiles() * generator.values_per_tile();
            const TileRun all{0, static_cast<std::uint32_t>(block.tiles())};
            auto floats = Device::open().buffer<float>(values);
            generator.place(tiling, block, all, floats);
            EXPECT_EQ(floats.read(0, values), reference::tile_points(tiles, tiling, block));
            auto integers = Device::open().buffer<std::uint32_t>(values);
            generator.place(tiling, block, all, integers);
            EXPECT_EQ(integers.read(0, values), reference::exact_tile_points(tiles, tiling, block));
        }
    }
}

TEST_P(TilePoints, OfPartsAreThoseOfTheWhole)
{
    const PoissonTileSet tiles = GetParam().tiles();
    TilePointGenerator generator(Device::open(), tiles, GetParam().work_group_size);
    const TileBlock whole = block({-3, -2, -1}, {5, 7, 3});
    const auto expected = reference::exact_tile_points(tiles, {}, whole);
    std::vector<std::uint32_t> parts;
    for (std::uint64_t first = 0; first < whole.tiles(); first += 9) {
        const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(9, whole.tiles() - first));
        auto points = Device::open().buffer<std::uint32_t>(count * generator.values_per_tile());
        generator.place({}, whole, {first, count}, points);
        std::ranges::copy(points.read(0, points.size()), std::back_inserter(parts));
    }
    EXPECT_EQ(parts, expected);
}

TEST_P(TilePoints, OfATorusAreThoseOfTheReference)
{
    const PoissonTileSet tiles = GetParam().tiles();
    TilePointGenerator generator(Device::open(), tiles, GetParam().work_group_size);
    for (const std::uint32_t period : {1u, 2u, 7u}) {
        const PointSet points = generator.generate_torus(11, period);
        EXPECT_EQ(points, reference::torus_points(tiles, 11, period));
        EXPECT_TRUE(std::ranges::all_of(points.coordinates, [](double x) { return x >= 0 && x < 1; }));
    }
}

TEST_P(TilePoints, AreThoseOfTheHeaderForEngines)
{
    const PoissonTileSet tiles = GetParam().tiles();
    const TileBlock window = block({-3, -2, -1}, {5, 4, 3});
    const ptiles_tiling tiling = runtime_tiling(tiles, {1, 0});
    double low[3];
    double high[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = window.lowest[axis];
        high[axis] = low[axis] + window.size[axis];
    }
    std::vector<ptiles_point> found(ptiles_in_window(&tiling, low, high, nullptr, 0, 1));
    ptiles_in_window(&tiling, low, high, found.data(), found.size(), 1);
    std::vector<std::uint32_t> units;
    for (const ptiles_point& point : found)
        for (std::size_t axis = 0; axis < tiling.set.dimension; ++axis)
            units.push_back(static_cast<std::uint32_t>((point.position[axis] - low[axis]) * 65536));
    EXPECT_EQ(units, reference::exact_tile_points(tiles, {1, 0}, window));
}

using enum PoissonTileKind;
// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, TilePoints,
                         testing::Values(Case{corner, 2, 3, 7, 1}, Case{corner, 2, 3, 32, 8}, Case{corner, 3, 2, 5, 7},
                                         Case{corner, 3, 3, 48}, Case{edge, 2, 2, 9}));

INSTANTIATE_TEST_SUITE_P(Sizes, TilePoints,
                         testing::Values(Case{corner, 2, 4, 64}, Case{corner, 2, 4, 64, 33}, Case{corner, 2, 2, 4},
                                         Case{corner, 2, 3, 24}, Case{corner, 2, 8, 65}, Case{corner, 3, 2, 16},
                                         Case{corner, 3, 2, 13}, Case{edge, 2, 2, 16, 128}, Case{frame, 2, 1, 31},
                                         Case{frame, 2, 1, 1}, Case{frame, 2, 1, 40, 64}));

/// Points of chains lie outside of their squares: below the lowest tile as well.
TEST(TilePointsOfChains, AreThoseOfTheReference)
{
    for (const std::uint32_t points : {3u, 20u, 64u}) {
        const PoissonTileSet tiles = random_chain_set(3, points);
        TilePointGenerator generator(Device::open(), tiles);
        const TileBlock block{{-3, -2, 0}, {5, 7, 1}};
        const std::size_t values = block.tiles() * generator.values_per_tile();
        auto floats = Device::open().buffer<float>(values);
        generator.place({9, 0}, block, {0, 35}, floats);
        EXPECT_EQ(floats.read(0, values), reference::tile_points(tiles, {9, 0}, block));
        auto integers = Device::open().buffer<std::uint32_t>(values);
        generator.place({9, 0}, block, {0, 35}, integers);
        EXPECT_EQ(integers.read(0, values), reference::exact_tile_points(tiles, {9, 0}, block));
        for (std::size_t i = 0; i < values; ++i)
            ASSERT_EQ(static_cast<float>(static_cast<std::int32_t>(integers.read(i, 1)[0])) / 65536,
                      floats.read(i, 1)[0]);
    }
}

TEST(TilePointsOfChains, OfATorusAreInsideOfIt)
{
    const PoissonTileSet tiles = random_chain_set(2, 16);
    TilePointGenerator generator(Device::open(), tiles);
    for (const std::uint32_t period : {1u, 3u, 8u}) {
        const PointSet points = generator.generate_torus(5, period);
        EXPECT_EQ(points, reference::torus_points(tiles, 5, period));
        // The header for engines finds these points far from the origin, modulo the period.
        const ptiles_tiling tiling = runtime_tiling(tiles, {5, static_cast<std::int32_t>(period)});
        std::multiset<std::array<double, 2>> expected, found;
        const double side = period, low[] = {7 * side, -4 * side}, high[] = {8 * side, -3 * side};
        std::vector<ptiles_point> window(ptiles_in_window(&tiling, low, high, nullptr, 0, 1));
        ptiles_in_window(&tiling, low, high, window.data(), window.size(), 1);
        for (const ptiles_point& p : window) expected.insert({p.position[0] - low[0], p.position[1] - low[1]});
        for (std::size_t i = 0; i < points.size(); ++i)
            found.insert({points.coordinates[2 * i] * side, points.coordinates[2 * i + 1] * side});
        ASSERT_EQ(expected.size(), found.size());
        for (auto a = expected.begin(), b = found.begin(); a != expected.end(); ++a, ++b) {
            EXPECT_NEAR((*a)[0], (*b)[0], 1e-12);
            EXPECT_NEAR((*a)[1], (*b)[1], 1e-12);
        }
    }
}

TEST(TilePointStream, CoversBlocksLargerThanItsMemory)
{
    const PoissonTileSet tiles = random_tile_set(PoissonTileKind::corner, 2, 2, 65536);
    TilePointGenerator generator(Device::open(), tiles);
    const TileBlock block{{-3, 5, 0}, {10, 9, 1}};
    std::vector<std::uint32_t> streamed;
    std::size_t pieces = 0;
    generator.stream({}, block, [&](std::span<const std::uint32_t> units) {
        EXPECT_LE(units.size(), std::size_t{1} << 22);
        streamed.insert(streamed.end(), units.begin(), units.end());
        ++pieces;
    });
    EXPECT_GT(pieces, 1u);
    EXPECT_TRUE(streamed == reference::exact_tile_points(tiles, {}, block));
}

TEST(TileBlocks, AreChecked)
{
    const auto problem = [](const TileBlock& block, int dimension) {
        return refusal_of([&] { check(block, dimension); });
    };
    EXPECT_EQ(problem({{-5, 7, 0}, {65536, 1, 1}}, 2), "accepted");
    EXPECT_EQ(problem({{-5, 7, 3}, {1, 1, 9}}, 3), "accepted");
    EXPECT_THAT(problem({{0, 0, 0}, {0, 1, 1}}, 2), testing::HasSubstr("must be 1 to 65536"));
    EXPECT_THAT(problem({{0, 0, 0}, {1, 65537, 1}}, 2), testing::HasSubstr("must be 1 to 65536"));
    EXPECT_THAT(problem({{INT32_MAX, 0, 0}, {1, 1, 1}}, 2), testing::HasSubstr("32 bits"));
    EXPECT_THAT(problem({{0, 0, 0}, {1, 1, 2}}, 2), testing::HasSubstr("layers"));
}

}
}
