// The blocks of the table of relaxation dart throwing in long regions, and the neighbours of cells: by their
// definitions.
#include "base/regions/region_squares.hpp"
#include "base/regions/region_text.hpp"
#include "base/regions/space_region.hpp"
#include "host/sampling/cells/cells_around.hpp"
#include "host/sampling/relaxing_grids.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace poissonlab {
namespace {

template <std::size_t D>
void expect_neighbours(std::uint32_t size, std::size_t count)
{
    std::mt19937 random(3);
    std::set<std::array<std::uint32_t, D>> chosen;
    while (chosen.size() < count) {
        std::array<std::uint32_t, D> cell{};
        for (std::uint32_t& c : cell) c = static_cast<std::uint32_t>(random()) % size;
        chosen.insert(cell);
    }
    std::vector<std::array<std::uint32_t, D>> cells(chosen.begin(), chosen.end());
    std::ranges::shuffle(cells, random);
    const std::vector<std::uint32_t> around = numbers_around(cells);
    const std::size_t neighbours = D == 2 ? 9 : 27;
    ASSERT_EQ(around.size(), neighbours * cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t n = 0; n < neighbours; ++n) {
            std::array<std::int64_t, D> wanted{};
            for (std::size_t k = 0, digits = n; k < D; ++k, digits /= 3)
                wanted[k] = std::int64_t{cells[i][k]} + static_cast<std::int64_t>(digits % 3) - 1;
            const auto found = std::ranges::find_if(
                cells, [&](const auto& cell) { return std::equal(cell.begin(), cell.end(), wanted.begin()); });
            EXPECT_EQ(around[neighbours * i + n],
                      found == cells.end() ? no_cell_around : static_cast<std::uint32_t>(found - cells.begin()));
        }
}

TEST(CellsAround, AreThoseOfTheGrid)
{
    expect_neighbours<2>(1, 1);
    expect_neighbours<2>(5, 13);
    expect_neighbours<2>(20, 300);
    expect_neighbours<3>(2, 8);
    expect_neighbours<3>(6, 100);
}

/// Each position of a square has the part of the table that its coordinates say, and no other square has this part,
/// unless it lies there as well.
template <std::size_t D, class Region>
void expect_parts(const Region& region, int cover_bits)
{
    const RegionSquares<Region> squares = squares_of(region, 1 << 14);
    ASSERT_GT(squares.corners.size(), 100u);
    for (const int grid_bits : {1, 32 - squares.shift - 5, 32 - squares.shift, 32 - squares.shift + 3}) {
        const TableFineness fineness{squares.shift, grid_bits, cover_bits};
        const TableBlocks table = table_blocks(squares.corners, fineness);
        const int block_bits = fineness.block_bits(), part_shift = 32 - grid_bits - cover_bits;
        ASSERT_EQ(table.corners.size(), D * block_count(squares.corners, fineness));
        ASSERT_EQ(table.first_parts.size(), squares.corners.size());
        EXPECT_EQ(part_count(squares.corners, fineness), (table.corners.size() / D)
                                                             << static_cast<int>(D) * block_bits);
        std::set<std::vector<std::uint32_t>> corners;
        for (auto corner = table.corners.begin(); corner != table.corners.end(); corner += D)
            EXPECT_TRUE(corners.emplace(corner, corner + D).second);
        for (std::size_t i = 0; i < squares.corners.size(); ++i) {
            const std::uint32_t block = table.first_parts[i] >> static_cast<int>(D) * block_bits;
            for (std::size_t k = 0; k < D; ++k) {
                const std::uint32_t in_block =
                    table.first_parts[i] >> static_cast<int>(k) * block_bits & ((1u << block_bits) - 1);
                EXPECT_EQ(squares.corners[i][k] >> part_shift, (table.corners[D * block + k] << cover_bits) + in_block);
            }
        }
    }
}

TEST(TableBlocks, HaveThePartsOfEachSquare)
{
    expect_parts<2>(FixedRegion(read_region("POLYGON ((0 0, 900 700, 900 703, 0 3, 0 0))")), 3);
}

TEST(TableBlocks, HaveThePartsOfEachCube) { expect_parts<3>(FixedSpace(read_space_region("box 0 0 0 900 2 1"), 0), 2); }

}
}
