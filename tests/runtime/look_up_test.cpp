// runtime/poisson_tiles.h against docs/tile-set-file.md: files, and which tile is where.
#include "tests/runtime/tile_set_cases.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_pieces.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

extern "C" std::uint32_t tile_in_c99(const ptiles_tiling* tiling, std::int32_t i, std::int32_t j, std::int32_t k);

namespace poissonlab {
namespace {

/// A tiling as the runtime header takes it, without points.
class TileLookup
{
public:
    TileLookup(PoissonTileKind kind, int dimension, std::uint32_t colors, std::uint32_t tiles, std::uint32_t seed,
               std::int32_t period = 0)
        : tiling_{{static_cast<std::uint32_t>(kind), static_cast<std::uint32_t>(dimension), colors, tiles, 0, nullptr,
                   0, 1, 0, 0, nullptr, 0, nullptr, 0, 0},
                  seed,
                  period}
    {}

    /// The number of the tile whose lowest corner is at this place; in 2D, k is not looked at.
    std::uint32_t operator()(std::int32_t i, std::int32_t j, std::int32_t k = 0) const
    {
        return ptiles_tile(&tiling_, i, j, k);
    }

private:
    ptiles_tiling tiling_;
};

/// The look-up once more, by the words of the document.
class ByTheDocument
{
public:
    ByTheDocument(const PoissonTileParameters& tiles, const PoissonTiling& tiling) : tiles_(tiles), tiling_(tiling) {}

    std::uint32_t tile(std::int64_t i, std::int64_t j, std::int64_t k) const
    {
        if (tiles_.kind == PoissonTileKind::frame) return hash(place(i), place(j), 0) % tiles_.tiles;
        if (tiles_.kind == PoissonTileKind::edge) return edge_tile(i, j);
        std::array<std::uint32_t, 8> corners{};
        for (unsigned corner = 0; corner < 1u << tiles_.dimension; ++corner)
            corners[corner] =
                color(i + (corner & 1), j + (corner >> 1 & 1), tiles_.dimension == 3 ? k + (corner >> 2) : 0);
        return corner_tile_of(corners, tiles_.dimension, tiles_.colors);
    }

private:
    static std::uint32_t mix(std::uint32_t v)
    {
        v ^= v >> 16;
        v *= 0x21f0aaad;
        v ^= v >> 15;
        v *= 0xd35a2d97;
        v ^= v >> 15;
        return v;
    }
    std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t z) const
    {
        return mix(mix(mix(mix(tiling_.seed) + x) + y) + z);
    }
    std::uint32_t place(std::int64_t at) const
    {
        if (tiling_.period == 0) return static_cast<std::uint32_t>(at);
        return static_cast<std::uint32_t>((at % tiling_.period + tiling_.period) % tiling_.period);
    }
    std::uint32_t color(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return hash(place(x), place(y), place(z)) % tiles_.colors;
    }
    std::uint32_t eastwards(std::int64_t x, std::int64_t y) const
    {
        return hash(place(x), place(y), 0) % tiles_.colors;
    }
    std::uint32_t northwards(std::int64_t x, std::int64_t y) const
    {
        return hash(place(x), place(y), 1) % tiles_.colors;
    }
    std::uint32_t edge_tile(std::int64_t i, std::int64_t j) const
    {
        return edge_tile_of({eastwards(i, j + 1), northwards(i + 1, j), eastwards(i, j), northwards(i, j),
                             eastwards(i + 1, j + 1), northwards(i + 1, j + 1), eastwards(i + 1, j),
                             northwards(i + 1, j - 1), eastwards(i - 1, j), northwards(i, j - 1),
                             eastwards(i - 1, j + 1), northwards(i, j + 1)},
                            tiles_.colors);
    }

    PoissonTileParameters tiles_;
    PoissonTiling tiling_;
};

constexpr PoissonTiling tilings[] = {{1, 0}, {0xfedcba98, 0}, {7, 1}, {7, 2}, {7, 5}, {7, 1000}, {7, INT32_MAX}};

TEST(TileLookUp, IsThatOfTheDocument)
{
    std::mt19937 random(1);
    for (const PoissonTileSet& set : tile_sets_of_every_kind()) {
        const PoissonTileParameters& p = set.parameters;
        for (const PoissonTiling& tiling : tilings) {
            const ByTheDocument expected(p, tiling);
            const TileLookup look_up(p.kind, p.dimension, p.colors, p.tiles, tiling.seed, tiling.period);
            const ptiles_tiling runtime = runtime_tiling(set, tiling);
            const auto check_at = [&](std::int32_t i, std::int32_t j, std::int32_t k) {
                const std::uint32_t tile = look_up(i, j, k);
                ASSERT_LT(tile, p.tiles);
                ASSERT_EQ(tile, expected.tile(i, j, k)) << name_of(set) << " " << i << " " << j << " " << k;
                ASSERT_EQ(tile, tile_in_c99(&runtime, i, j, k));
            };
            for (std::int32_t i = -7; i < 7; ++i)
                for (std::int32_t j = -7; j < 7; ++j) check_at(i, j, p.dimension == 3 ? i + 2 * j : 0);
            for (int n = 0; n < 200; ++n) {
                const std::int32_t k = static_cast<std::int32_t>(random());
                check_at(static_cast<std::int32_t>(random()), static_cast<std::int32_t>(random()),
                         p.dimension == 3 ? k : 0);
            }
            for (const std::int32_t end : {INT32_MIN, INT32_MAX})
                for (const std::int32_t other : {INT32_MIN, -1, 0, INT32_MAX})
                    check_at(end, other, p.dimension == 3 ? end : 0);
        }
    }
}

/// Numbers that must not change, as long as the file's version is 1.
TEST(TileLookUp, StaysAsItIs)
{
    EXPECT_EQ(ptiles_hash(1, 2, 3, 4), 2209509086u);
    EXPECT_EQ(TileLookup(PoissonTileKind::corner, 2, 4, 256, 1)(-3, 5), 28u);
    EXPECT_EQ(TileLookup(PoissonTileKind::corner, 3, 2, 256, 1)(-3, 5, 9), 144u);
    EXPECT_EQ(TileLookup(PoissonTileKind::edge, 2, 2, 4096, 1)(-3, 5), 1655u);
    EXPECT_EQ(TileLookup(PoissonTileKind::frame, 2, 1, 100, 1)(-3, 5), 23u);
}

TEST(TileSetBytes, AreOpenedWithoutCopies)
{
    for (const PoissonTileSet& set : tile_sets_of_every_kind()) {
        const std::string bytes = tile_set_file_bytes(set);
        ptiles_set opened;
        ASSERT_EQ(ptiles_open(&opened, bytes.data(), bytes.size()), nullptr) << name_of(set);
        const ptiles_set expected = runtime_tiling(set, {}).set;
        EXPECT_EQ(opened.kind, expected.kind);
        EXPECT_EQ(opened.dimension, expected.dimension);
        EXPECT_EQ(opened.colors, expected.colors);
        EXPECT_EQ(opened.tiles, expected.tiles);
        EXPECT_EQ(opened.points_per_tile, expected.points_per_tile);
        EXPECT_EQ(reinterpret_cast<const char*>(opened.points), bytes.data() + 128);
        EXPECT_EQ(std::memcmp(opened.points, set.points.data(), set.points.size() * 2), 0);
        const std::uint32_t last = set.parameters.tiles - 1;
        EXPECT_EQ(*ptiles_points(&opened, last), set.tile(last).front());
    }
}

TEST(TileSetBytes, AreThoseOfTheLaboratory)
{
    for (const PoissonTileSet& set : tile_sets_of_every_kind()) {
        const std::string bytes = encode_tile_set(set);
        ptiles_set opened;
        ASSERT_EQ(ptiles_open(&opened, bytes.data(), bytes.size()), nullptr) << name_of(set);
        EXPECT_EQ(opened.points_per_tile, set.parameters.points_per_tile);
        EXPECT_EQ(bytes.substr(128), tile_set_file_bytes(set).substr(128));
    }
}

TEST(TileSetBytes, AreRefusedWhereTheyAreWrong)
{
    const std::string good = tile_set_file_bytes(random_tile_set(PoissonTileKind::corner, 2, 3, 7));
    const auto problem = [](std::string bytes) {
        ptiles_set set;
        const char* text = ptiles_open(&set, bytes.data(), bytes.size());
        return std::string(text == nullptr ? "" : text);
    };
    const auto with = [&](std::size_t offset, char value) {
        std::string bytes = good;
        bytes[offset] = value;
        return bytes;
    };
    EXPECT_EQ(problem(good), "");
    EXPECT_EQ(problem(good.substr(0, 127)), "shorter than the header of a tile set file");
    EXPECT_EQ(problem(with(6, '\n')), "not a tile set file");
    EXPECT_EQ(problem(with(8, 4)), "an unknown version of the file format");
    EXPECT_EQ(problem(with(16, 3)), "an unknown kind of tiles");
    EXPECT_EQ(problem(with(20, 4)), "an unknown kind of tiles");
    for (const std::size_t number : {24u, 27u, 28u, 35u})
        EXPECT_EQ(problem(with(number, 100)), "numbers of colours, tiles and points that do not fit together");
    EXPECT_EQ(problem(with(32, 8)), "too short or too long for its points");
    EXPECT_EQ(problem(good.substr(0, good.size() - 1)), "too short or too long for its points");
    EXPECT_EQ(problem(good + "x"), "too short or too long for its points");
    const std::string shifted = " " + good;
    ptiles_set set;
    EXPECT_STREQ(ptiles_open(&set, shifted.data() + 1, good.size()), "bytes must be at an even address");
}

}
}
