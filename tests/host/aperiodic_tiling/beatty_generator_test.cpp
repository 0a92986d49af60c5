// kernels/beatty_tiling.cl against its plain twin, byte for byte.
#include "host/aperiodic_tiling/beatty_generator.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

struct BeattyCase
{
    BeattySet set;
    std::size_t work_group_size;
    TileWindow window;
};

void PrintTo(const BeattyCase& c, std::ostream* out)
{
    *out << (c.set == BeattySet::kari ? "Kari" : "Culik") << ", " << c.window.width << " x " << c.window.height
         << ", groups of " << c.work_group_size;
}

class BeattyGenerator : public testing::TestWithParam<BeattyCase>
{
};

TEST_P(BeattyGenerator, MakesTheTilesOfItsTwin)
{
    const BeattyCase& c = GetParam();
    for (const std::uint64_t seed : {1, 2}) {
        const BeattyTiling tiling(c.set, seed);
        std::vector<std::uint8_t> tiles;
        poissonlab::BeattyGenerator(Device::open(), tiling, c.work_group_size)
            .stream(c.window, [&](std::span<const std::uint8_t> row) {
                EXPECT_EQ(row.size(), c.window.width);
                tiles.insert(tiles.end(), row.begin(), row.end());
            });
        EXPECT_EQ(tiles, reference::beatty_tiles(tiling, c.window));
    }
}

INSTANTIATE_TEST_SUITE_P(Small, BeattyGenerator,
                         testing::Values(BeattyCase{BeattySet::kari, 1, {0, 0, 1, 1}},
                                         BeattyCase{BeattySet::culik, 64, {-5, -3, 300, 4}},
                                         BeattyCase{BeattySet::kari, 7, {-300, 2, 257, 3}}));
INSTANTIATE_TEST_SUITE_P(Large, BeattyGenerator,
                         testing::Values(BeattyCase{BeattySet::kari, 64, {-1000, -500, 2000, 1000}},
                                         BeattyCase{BeattySet::culik, 0, {-(std::int64_t{1} << 40), -7, 1025, 20}},
                                         BeattyCase{BeattySet::kari, 0, {(std::int64_t{1} << 40) - 700, 900, 700, 9}},
                                         BeattyCase{BeattySet::culik, 16, {3, -5000, 100'000, 100}}));

TEST(BeattyGeneratorLimits, RefusesWindowsThatReachBeyondThem)
{
    const BeattyTiling tiling(BeattySet::kari, 1);
    poissonlab::BeattyGenerator generator(Device::open(), tiling);
    const auto refusal = [&](const TileWindow& window) {
        return message_of([&] { generator.stream(window, [](auto) {}); });
    };
    EXPECT_EQ(refusal({0, beatty_row_limit - 1, 1, 2}),
              "rows of a tiling by Beatty sequences are from -1048576 to 1048575");
    EXPECT_EQ(refusal({beatty_column_limit, 0, 1, 1}),
              "columns of a tiling by Beatty sequences are from -1099511627776 to 1099511627775");
    EXPECT_EQ(refusal({0, 0, std::uint64_t{1} << 31, 1}), "a row of 2^31 tiles or more does not fit");
}

TEST(BeattyGeneratorLimits, SaysWhatMemoryItTakes)
{
    // A table, a row more than the piece, and the tiles: pieces are of 2^23 tiles, or of one row.
    EXPECT_EQ(poissonlab::BeattyGenerator::memory({0, 0, 1 << 20, 100}).total,
              beatty_table_size + 9 * sizeof(contract::beatty_tiling::Row) + (std::size_t{1} << 23));
    for (const TileWindow& window : {TileWindow{-5, 7, 1 << 20, 20}, TileWindow{0, 0, 300, 2}}) {
        Device device = Device::open();
        const std::uint64_t before = device.memory().total;
        device.watch_memory();
        poissonlab::BeattyGenerator generator(device, BeattyTiling(BeattySet::culik, 1));
        generator.stream(window, [](auto) {});
        const DeviceMemory foretold = poissonlab::BeattyGenerator::memory(window);
        EXPECT_EQ(device.peak_memory().total - before, foretold.total);
        EXPECT_EQ(device.peak_memory().largest, foretold.largest);
    }
}

}
}
