// runtime/poisson_tiles_gpu.h as HLSL, with the types of HLSL in C++, against runtime/poisson_tiles.h: a million places
// of every kind of tiles. That a compiler of HLSL takes the same text: examples.sh.
#include "tests/runtime/hlsl_types.hpp"
#include "tests/runtime/tile_set_cases.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#define PTILES_HLSL
#define precise
namespace poissonlab::hlsl {
#include "runtime/poisson_tiles_gpu.h"
}
#undef precise
#undef PTILES_HLSL

namespace poissonlab {
namespace {

/// The words that a program copies to the buffer: the file's from byte 128 on.
struct HlslBuffer
{
    explicit HlslBuffer(const PoissonTileSet& set)
    {
        std::vector<std::uint16_t> numbers = set.points;
        numbers.insert(numbers.end(), set.chain_lengths.begin(), set.chain_lengths.end());
        first_rank = static_cast<std::uint32_t>(set.ranks.empty() ? 0 : numbers.size());
        numbers.insert(numbers.end(), set.ranks.begin(), set.ranks.end());
        numbers.resize((numbers.size() + 1) / 2 * 2);
        for (std::size_t i = 0; i < numbers.size(); i += 2)
            words.push_back(numbers[i] | static_cast<std::uint32_t>(numbers[i + 1]) << 16);
        hlsl::ptiles_words = words.data();
    }
    ~HlslBuffer() { hlsl::ptiles_words = nullptr; }
    HlslBuffer(const HlslBuffer&) = delete;
    HlslBuffer& operator=(const HlslBuffer&) = delete;

    hlsl::ptiles_tiling tiling(const ptiles_tiling& t) const
    {
        return {t.set.kind, t.set.dimension, t.set.colors, t.set.tiles, t.set.points_per_tile, t.seed,
                t.period,   t.set.low,       t.set.step,   t.set.below, t.set.above,           first_rank};
    }

    std::vector<std::uint32_t> words;
    std::uint32_t first_rank = 0;
};

hlsl::int3 random_place(std::mt19937& random, std::uint32_t dimension)
{
    const auto anywhere = [&] { return static_cast<std::int32_t>(random()) / 2; };
    hlsl::int3 place(anywhere(), anywhere(), dimension == 3 ? anywhere() : 0);
    return place;
}

/// The tile at a place, and one of its points.
void expect_same_point(const hlsl::ptiles_tiling& ours, const ptiles_tiling& theirs, std::mt19937& random)
{
    const hlsl::int3 at = random_place(random, ours.dimension);
    const std::uint32_t tile = ptiles_tile(&theirs, at.x, at.y, at.z);
    ASSERT_EQ(hlsl::ptiles_tile(ours, at), tile);
    const auto index = static_cast<std::uint32_t>(random() % ours.points_per_tile);
    const std::uint16_t* const numbers = ptiles_points(&theirs.set, tile) + index * ours.dimension;
    const std::int32_t place[3] = {at.x, at.y, at.z};
    const ptiles_point point = ptiles_point_at(&theirs, place, index, numbers);
    const hlsl::float3 found = hlsl::ptiles_point(ours, tile, index);
    ASSERT_EQ(found.x, ptiles_coordinate(&theirs.set, numbers[0]));
    ASSERT_EQ(found.y, ptiles_coordinate(&theirs.set, numbers[1]));
    ASSERT_EQ(found.z, ours.dimension == 3 ? ptiles_coordinate(&theirs.set, numbers[2]) : 0);
    // Levels have the bits that a float has.
    ASSERT_NEAR(hlsl::ptiles_level(ours, tile, index, point.id), point.level, 1e-7);
}

/// The nearest point, or one that is as near to a float's last bits; false then.
bool has_same_nearest(const hlsl::ptiles_tiling& ours, const ptiles_tiling& theirs, std::mt19937& random)
{
    const hlsl::int3 at = random_place(random, ours.dimension);
    const auto unit = [&] { return static_cast<float>(random() % 65536) / 65536; };
    const hlsl::float3 f(unit(), unit(), ours.dimension == 3 ? unit() : 0);
    const double position[3] = {at.x + double{f.x}, at.y + double{f.y}, at.z + double{f.z}};
    ptiles_point expected;
    const double distance = std::sqrt(ptiles_nearest(&theirs, position, &expected));
    const hlsl::ptiles_nearest found = hlsl::ptiles_nearest_point(ours, at, f);
    EXPECT_NEAR(found.distance, distance, 1e-6);
    const bool is_same = found.tile.x == expected.tile[0] && found.tile.y == expected.tile[1] &&
                         found.tile.z == expected.tile[2] && found.index == expected.index;
    EXPECT_TRUE(!is_same || found.id == expected.id);
    return is_same;
}

TEST(Hlsl, HasThePointsOfAMillionPlaces)
{
    const std::vector<PoissonTileSet> sets = tile_sets_of_every_kind();
    const std::size_t places = 1'000'000 / (2 * sets.size()) + 1;
    for (const PoissonTileSet& set : sets)
        for (const PoissonTiling& choice : {PoissonTiling{1, 0}, PoissonTiling{0x89abcdef, 6}}) {
            SCOPED_TRACE(name_of(set));
            const HlslBuffer buffer(set);
            const ptiles_tiling theirs = runtime_tiling(set, choice);
            const hlsl::ptiles_tiling ours = buffer.tiling(theirs);
            std::mt19937 random(1);
            for (std::size_t n = 0; n < places && !HasFailure(); ++n) expect_same_point(ours, theirs, random);
            int others = 0;
            for (int n = 0; n < 500; ++n) others += !has_same_nearest(ours, theirs, random);
            EXPECT_LE(others, 1);
        }
}

}
}
