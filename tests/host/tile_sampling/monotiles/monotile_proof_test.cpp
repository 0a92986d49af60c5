// Files with the points of monotiles that lie: the proof refuses all of them, and soon.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tiles/monotiles/monotile_file.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <ctime>
#include <random>

namespace poissonlab {
namespace {

std::string shipped_file(const std::string& word)
{
    return read_whole_file(fmt::format("{}/runtime/tile_sets/{}-n4.ptiles", source_folder(), word));
}

std::string with_right_checksum(std::string bytes)
{
    const std::uint64_t sum = tile_file_checksum(bytes);
    std::memcpy(bytes.data() + 120, &sum, sizeof(sum));
    return bytes;
}

// A file with a right checksum that says anything else of the tiling or of its distances is refused. Places of points
// may be any that have these distances.
TEST(MonotileProof, FilesThatLieAreRefused)
{
    const PolygonTiling& tiling = built_in_tiling("hat");
    const std::string good = shipped_file("hat");
    EXPECT_NO_THROW(proven_monotile_table(MonotilePointsFile(good, "a"), tiling));
    const MonotilePointsFile honest(good, "a");
    const auto places = static_cast<std::size_t>(honest.set().place - honest.set().distances) + 128;
    std::mt19937 random(3);
    for (int i = 0; i < 40; ++i) {
        const std::size_t at = i < 20 ? 8 + random() % 112 : 128 + random() % (places - 128);
        std::string bytes = good;
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        const std::string said = message_of(
            [&] { proven_monotile_table(MonotilePointsFile(with_right_checksum(bytes), "a.ptiles"), tiling); });
        EXPECT_TRUE(said.starts_with("a.ptiles: ")) << at << ": " << said;
    }
    std::string larger = good;
    ++larger[40];
    EXPECT_EQ(message_of([&] { proven_monotile_table(MonotilePointsFile(with_right_checksum(larger), "a"), tiling); }),
              "a: promises other distances than are proven");
    // Commands that do not prove the distance believe no more than the densest packing has: 2 / sqrt(3) points per
    // square of the distance, of 4 points in 8 sqrt(3).
    const auto promising = [&](std::uint64_t promised) {
        std::string bytes = good;
        std::memcpy(bytes.data() + 40, &promised, sizeof(promised));
        MonotilePointsFile(with_right_checksum(bytes), "a");
    };
    constexpr std::uint64_t densest = std::uint64_t{4} << 32; // squares of 2^-16
    EXPECT_NO_THROW(promising(densest - 1));
    for (const std::uint64_t promised : {densest + 1, ~std::uint64_t{0}})
        EXPECT_TRUE(message_of([&] {
                        promising(promised);
                    }).starts_with(fmt::format("a: guaranteed squared minimum distance {}: must be", promised)));
}

/// Returns a file with another 32-bit number, and a right checksum.
std::string with_word(std::string bytes, std::size_t at, std::int64_t value)
{
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(static_cast<std::uint64_t>(value) >> 8 * i);
    return with_right_checksum(bytes);
}

/// Proofs of files that lie take no longer than those of files that do not, whatever they lie about. Points that were
/// far from their tiles took a minute, since they would be near the points of thousands of tiles.
TEST(MonotileProof, LiesAreFoundSoon)
{
    for (const char* word : {"hat", "spectre"}) {
        const PolygonTiling& tiling = built_in_tiling(word);
        const std::string good = shipped_file(word);
        const MonotilePointsFile honest(good, "a.ptiles");
        const auto seconds = [&](const std::string& bytes, std::string& said) {
            const std::clock_t begin = std::clock();
            said = message_of([&] { proven_monotile_table(MonotilePointsFile(bytes, "a.ptiles"), tiling); });
            return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        };
        const std::size_t places = static_cast<std::size_t>(honest.set().place - honest.set().distances) + 128;
        std::string said;
        proven_monotile_table(honest, tiling); // what the first proof prepares
        const std::clock_t begin = std::clock();
        proven_monotile_table(honest, tiling);
        const double usual = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        const std::int64_t far = 1 << 20;
        EXPECT_LT(seconds(with_word(good, places, far), said), 2 * usual + 0.5) << word;
        EXPECT_EQ(said, "a.ptiles: has points far from their tiles");
        // All points are moved by half an edge in their tiles, which leaves each tile as it was.
        std::string moved = good;
        for (std::size_t i = 0; i < std::size_t{honest.set().states} * 4; ++i)
            moved = with_word(moved, places + 8 * i, pmono_signed_word(honest.set().place + 8 * i) + 32768);
        EXPECT_LT(seconds(moved, said), 2 * usual + 0.5) << word;
        EXPECT_EQ(said, "a.ptiles: promises other distances than are proven");
        // The distances are stated as pairs of numbers, which need not be squares of lengths, or numbers that doubles
        // hold.
        for (const std::int64_t high : {std::int64_t{-1}, std::int64_t{0x7fffffff}, -(std::int64_t{1} << 31)})
            for (std::size_t at = 128; at < 128 + 64; at += 8) {
                EXPECT_LT(seconds(with_word(good, at + 4, high), said), 2 * usual + 0.5) << word << at;
                EXPECT_EQ(said, "a.ptiles: promises other distances than are proven");
            }
        // A distance of 0, as of a file without a promise.
        EXPECT_LT(seconds(with_word(with_word(good, 40, 0), 44, 0), said), 2 * usual + 0.5);
        EXPECT_EQ(said, "a.ptiles: promises other distances than are proven");
    }
}

}
}
