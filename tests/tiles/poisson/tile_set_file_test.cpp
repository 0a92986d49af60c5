// Tile set files: what is written is read, and whatever is damaged or foreign is refused in one line.
#include "tiles/poisson/tile_set_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tiles/poisson/made_up_tile_sets.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstring>
#include <limits>
#include <random>

#include <sys/resource.h>

namespace poissonlab {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Every parameter other than its default.
PoissonTileSet unusual_set()
{
    PoissonTileParameters p = corner_parameters(3, 7, 0.4321);
    p.filling = TileFilling::dart_throwing;
    p.attempts = 12345;
    p.factor = 1;
    p.lloyd_iterations = 4'000'000'000;
    p.repulsion = true;
    p.seed = 0xfedcba9876543210;
    PoissonTileSet set = random_points(p);
    set.squared_min_distance = 123'456'789;
    return set;
}

PoissonTileSet chain_set()
{
    PoissonTileParameters p = corner_parameters(2, 9, 0.4);
    set_border(p, TileBorder::chain, 123, false, 3);
    PoissonTileSet set = random_points(p);
    for (std::uint16_t length = 0; length < 8; ++length) set.chain_lengths.push_back(length);
    return set;
}

PoissonTileSet class_set()
{
    PoissonTileParameters p = corner_parameters(2);
    set_classes(p, classes_of_radius({4, 9, 20}, 0.5, 2));
    PoissonTileSet set = random_points(p);
    set.class_squared_distances = {1, 22, 333, 4444, 55'555, 0};
    return set;
}

std::vector<PoissonTileSet> one_of_each_kind()
{
    return {unusual_set(),
            random_points(edge_parameters(1)),
            random_points(template_parameters(5)),
            random_points(sphere_parameters(2)),
            chain_set(),
            class_set(),
            with_random_ranks(class_set()),
            with_random_ranks(chain_set()),
            with_random_ranks(random_points(sphere_parameters(2)))};
}

/// The message with which these bytes are refused, or "accepted".
std::string error_of(std::string_view bytes)
{
    const std::string message = refusal_of([&] { decode_tile_set(bytes, "a.ptiles"); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_THAT(message, AnyOf(StartsWith("a.ptiles: "), "accepted"));
    return message;
}

template <class T>
std::string changed(std::string bytes, std::size_t offset, T value)
{
    std::memcpy(bytes.data() + offset, &value, sizeof(T));
    return bytes;
}

/// Writes the checksum of the bytes into them, so that only what they say is wrong.
std::string resealed(std::string bytes)
{
    Xxh64 hash;
    hash.add(std::string_view(bytes).substr(0, 120));
    hash.add(std::string_view(bytes).substr(128));
    return changed(bytes, 120, hash.value());
}

template <class T>
std::string error_after(std::size_t offset, T value)
{
    return error_of(resealed(changed(encode_tile_set(unusual_set()), offset, value)));
}

TEST(TileSetFile, ReadsWhatItWrites)
{
    const TemporaryFolder folder;
    for (const PoissonTileSet& set : one_of_each_kind()) {
        for (const char* name : {"set.ptiles", "set.json", "set"}) {
            write_tile_set(folder.path() / name, set);
            EXPECT_EQ(read_tile_set(folder.path() / name), set) << name;
        }
        EXPECT_EQ(read_whole_file(folder.path() / "set.ptiles"), encode_tile_set(set));
        EXPECT_THAT(read_whole_file(folder.path() / "set.json"), StartsWith("{"));
        EXPECT_EQ(folder.names().size(), 3U);
    }
}

TEST(TileSetFile, JsonKeepsEveryGuarantee)
{
    const TemporaryFolder folder;
    PoissonTileSet set = random_points(corner_parameters(1, 4, 0.1));
    std::mt19937_64 random(1);
    for (int i = 0; i < 200; ++i) {
        set.squared_min_distance = i < 20 ? static_cast<std::uint64_t>(i) : random() % 1'200'000'000;
        write_tile_set(folder.path() / "set.json", set);
        ASSERT_EQ(read_tile_set(folder.path() / "set.json").squared_min_distance, set.squared_min_distance);
    }
}

TEST(TileSetFile, BytesAreAsDocumented)
{
    // docs/tile-set-file.md, by hand. These bytes must not change.
    PoissonTileParameters p = corner_parameters(1, 4, 0.5);
    p.seed = 0x1122334455667788;
    const PoissonTileSet set{p, 99, {0, 1, 2, 3, 0x1234, 0xffff, 6, 7}};
    const std::string bytes = encode_tile_set(set);
    ASSERT_EQ(bytes.size(), 128U + 16);
    const auto u32 = [&](std::size_t offset) {
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
        return value;
    };
    EXPECT_EQ(bytes.substr(0, 8), "PTILES\r\n");
    const std::vector<std::pair<std::size_t, std::uint32_t>> expected{
        {8, 1},   {12, 128}, {16, 0}, {20, 2},          {24, 1},          {28, 1},          {32, 4}, {36, 0},
        {40, 99}, {44, 0},   {48, 0}, {52, 0x3fe00000}, {56, 0x55667788}, {60, 0x11223344}, {64, 1}, {68, 100},
        {80, 0},  {84, 0},   {88, 0}, {116, 0},         {128, 0x10000},   {136, 0xffff1234}};
    for (const auto& [offset, value] : expected) EXPECT_EQ(u32(offset), value) << offset;
    EXPECT_EQ(resealed(bytes), bytes);
}

TEST(TileSetFile, EveryFieldIsChecked)
{
    EXPECT_EQ(error_of(encode_tile_set(unusual_set())), "accepted");
    EXPECT_EQ(error_after(8, 4u),
              "a.ptiles: has the points of an aperiodic monotile: must be a set of square tiles here");
    EXPECT_EQ(error_after(8, 5u), "a.ptiles: version of the format 5: must be 1 to 3");
    EXPECT_EQ(error_after(8, 3u), "a.ptiles: classes = 0: must be at least 1 in version 3");
    EXPECT_EQ(error_after(12, 64u), "a.ptiles: offset of the points 64: must be 128");
    EXPECT_EQ(error_after(16, 3u), "a.ptiles: kind = 3: must be at most 2");
    EXPECT_THAT(error_after(16, 2u), HasSubstr("colors = 3: must be 1"));
    EXPECT_EQ(error_after(20, 4u), "a.ptiles: dimension = 4: must be at most 3");
    EXPECT_THAT(error_after(20, 0u), HasSubstr("dimension = 0: "));
    EXPECT_THAT(error_after(24, 0u), HasSubstr("colors = 0: "));
    EXPECT_THAT(error_after(28, 80u), HasSubstr("tiles = 80: "));
    EXPECT_THAT(error_after(32, 0xffffffffu), HasSubstr("points_per_tile = 4294967295: "));
    EXPECT_EQ(error_after(36, 1u), "a.ptiles: reserved number at byte 36: 1: must be 0");
    EXPECT_THAT(error_after(40, UINT64_MAX), HasSubstr("guaranteed squared minimum distance 18446744073709551615: "));
    EXPECT_THAT(error_after(48, std::numeric_limits<double>::quiet_NaN()), HasSubstr("relative_radius = nan: "));
    EXPECT_THAT(error_after(64, 2u), HasSubstr("filling = 2: must be at most 1"));
    EXPECT_THAT(error_after(68, 0u), HasSubstr("attempts = 0: "));
    EXPECT_THAT(error_after(72, std::numeric_limits<double>::quiet_NaN()), HasSubstr("factor = nan: "));
    EXPECT_THAT(error_after(84, 2u), HasSubstr("repulsion = 2: must be at most 1"));
    EXPECT_EQ(error_after(90, 'x'), "a.ptiles: reserved bytes 88 to 119: must be 0");
    EXPECT_EQ(error_after(32, 8u), "a.ptiles: has 2396 bytes: must be 2720 for 81 tiles of 8 points");
}

TEST(TileSetFile, EveryFieldOfVersion2IsChecked)
{
    const std::string bytes = encode_tile_set(chain_set());
    EXPECT_EQ(error_of(bytes), "accepted");
    const auto error = [&](std::size_t offset, auto value) {
        return error_of(resealed(changed(bytes, offset, value)));
    };
    EXPECT_EQ(error(8, 1u), "a.ptiles: reserved bytes 88 to 119: must be 0");
    EXPECT_EQ(error(88, 2u), "a.ptiles: border = 2: must be at most 1");
    EXPECT_THAT(error(92, 100'001u), HasSubstr("joint_iterations = 100001: must be an integer from 0 to 100000"));
    EXPECT_EQ(error(92, 0u), "accepted");
    EXPECT_EQ(error(96, 2u), "a.ptiles: null_peaks = 2: must be at most 1");
    EXPECT_THAT(error(84, 0u), HasSubstr("repulsion = false: must be true for tiles with chains"));
    EXPECT_THAT(error(100, 12u), HasSubstr("points below squares = 12: must be "));
    EXPECT_THAT(error(104, 12u), HasSubstr("points above squares = 12: must be "));
    EXPECT_EQ(error(108, 2u), "a.ptiles: ranked = 2: must be at most 1");
    EXPECT_THAT(error(108, 1u), HasSubstr("must be 1008 for 16 tiles of 9 points"));
    EXPECT_EQ(error(112, 4u), "a.ptiles: equal_moments = 4: must be at most 3");
    EXPECT_EQ(error(116, 1u), "a.ptiles: reserved bytes 116 to 119: must be 0");
    EXPECT_THAT(error_of(bytes.substr(0, bytes.size() - 16)), HasSubstr("must be "));
}

TEST(TileSetFile, EveryFieldOfVersion3IsChecked)
{
    // 3 classes: 3 numbers of points, 6 distances that are asked for, 6 that are proven.
    const std::string bytes = encode_tile_set(class_set());
    const std::size_t points = bytes.size() - 3 * 4 - 6 * 8 - 6 * 8;
    EXPECT_EQ(points, 128U + 16 * 33 * 2 * 2);
    EXPECT_EQ(error_of(bytes), "accepted");
    const auto error = [&](std::size_t offset, auto value) {
        return error_of(resealed(changed(bytes, offset, value)));
    };
    EXPECT_EQ(error(8, 2u), "a.ptiles: reserved number at byte 36: 3: must be 0");
    EXPECT_EQ(error(36, 33u), "a.ptiles: classes = 33: must be at most 32");
    EXPECT_THAT(error(36, 2u), HasSubstr("must be 2296 for 16 tiles of 33 points"));
    EXPECT_EQ(error(points, 5u), "a.ptiles: class_points = [5, 9, 20]: must be 1 or more each, 33 together");
    EXPECT_EQ(error(points, 0u), "a.ptiles: class_points = [0, 9, 20]: must be 1 or more each, 33 together");
    EXPECT_THAT(error(points + 12, 1.5), HasSubstr("class_distances = 1.5: must be numbers above 0 and at most 1"));
    EXPECT_THAT(error(points + 12, 0.01), HasSubstr("relative_radius = "));
    EXPECT_THAT(error(80, 1u), HasSubstr("lloyd_iterations = 1: must be 0 with classes"));
    EXPECT_THAT(error(84, 0u), HasSubstr("repulsion = false: must be true for tiles with classes"));
    PoissonTileSet fewer = class_set();
    fewer.class_squared_distances.pop_back();
    EXPECT_EQ(refusal_of([&] { encode_tile_set(fewer); }), "5 distances of pairs of classes: must be 6");
}

TEST(TileSetFile, RanksAreAnOrderOfEachTile)
{
    const PoissonTileSet set = with_random_ranks(chain_set());
    const std::string bytes = encode_tile_set(set);
    EXPECT_EQ(error_of(bytes), "accepted");
    const std::size_t first = bytes.size() - 2 * set.ranks.size();
    EXPECT_EQ(error_of(resealed(changed(bytes, first + 2 * (5 * 9 + 3), std::uint16_t{9}))),
              "a.ptiles: tile 5, point 3: rank 9: must be at most 8");
    EXPECT_EQ(error_of(resealed(changed(bytes, first + 2, set.ranks[0]))),
              fmt::format("a.ptiles: tile 0, point 1: rank {}: another point of the tile has it", set.ranks[0]));
    PoissonTileSet fewer = set;
    fewer.ranks.pop_back();
    EXPECT_EQ(refusal_of([&] { encode_tile_set(fewer); }), "143 ranks of points: must be 144");
    EXPECT_EQ(refusal_of([&] { certify(fewer); }), "143 ranks of points: must be 144");
}

class DamagedTileSetFile : public testing::TestWithParam<bool>
{
};

TEST_P(DamagedTileSetFile, IsNeverOverlooked)
{
    const std::string bytes =
        encode_tile_set(GetParam() ? with_random_ranks(chain_set()) : random_points(corner_parameters(2, 6)));
    for (std::size_t offset = 0; offset < 128; ++offset)
        for (int change = 1; change < 256; ++change)
            ASSERT_NE(error_of(changed(bytes, offset, static_cast<char>(bytes[offset] ^ change))), "accepted")
                << offset;
    for (std::size_t size = 0; size < bytes.size(); ++size)
        ASSERT_NE(error_of(bytes.substr(0, size)), "accepted") << size;
    for (const std::size_t extra : {1, 2, 24, 100'000})
        EXPECT_NE(error_of(bytes + std::string(extra, '\0')), "accepted");
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) {
        const std::size_t offset = 128 + random() % (bytes.size() - 128);
        ASSERT_THAT(error_of(changed(bytes, offset, static_cast<char>(bytes[offset] ^ 1 << random() % 8))),
                    HasSubstr("is damaged: its checksum is "));
    }
}

INSTANTIATE_TEST_SUITE_P(Borders, DamagedTileSetFile, testing::Bool());

/// For as long as it lives, the process can have no more memory. The address sanitizer needs all of it.
class MemoryLimit
{
public:
    explicit MemoryLimit([[maybe_unused]] rlim_t bytes)
    {
        ::getrlimit(RLIMIT_AS, &old_);
#ifndef __SANITIZE_ADDRESS__
        const rlimit limit{std::min(old_.rlim_max, bytes), old_.rlim_max};
        ::setrlimit(RLIMIT_AS, &limit);
#endif
    }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
    ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &old_); }

private:
    rlimit old_{};
};

TEST(TileSetFile, RandomHeadersTakeNoMemory)
{
    // Checksums are right, so that nothing but the sizes can tell. 4 GiB would not fit below the limit.
    const std::string bytes = encode_tile_set(random_points(corner_parameters(2, 6)));
    std::mt19937 random(1);
    const MemoryLimit limit(rlim_t{3} << 30);
    for (int i = 0; i < 20'000; ++i) {
        std::string damaged = bytes;
        for (unsigned change = 0; change <= random() % 3; ++change) {
            const std::size_t offset = 16 + 4 * (random() % 18);
            damaged = changed(damaged, offset, static_cast<std::uint32_t>(random() % 2 ? random() : random() % 70));
        }
        error_of(resealed(damaged)); // other exceptions fail the test
    }
}

TEST(TileSetFile, OtherFilesAreRefusedByName)
{
    const TemporaryFolder folder;
    const auto message = [&](const std::filesystem::path& path) { return refusal_of([&] { read_tile_set(path); }); };
    const std::string name = (folder.path() / "a").string();
    EXPECT_EQ(message(name), name + ": cannot be read: No such file or directory");
    EXPECT_EQ(message(folder.path()), folder.path().string() + ": cannot be read: Is a directory");
    folder.write("a", "");
    EXPECT_EQ(message(name), name + ": is no Poisson tile set: neither .ptiles nor JSON");
    folder.write("a", "0.1 0.2\n");
    EXPECT_EQ(message(name), name + ": is no Poisson tile set: neither .ptiles nor JSON");
    // Transferred as text.
    std::string bytes = encode_tile_set(unusual_set());
    bytes.erase(6, 1);
    folder.write("a", bytes);
    EXPECT_EQ(message(name), name + ": is no Poisson tile set: neither .ptiles nor JSON");
    folder.write("a", encode_tile_set(unusual_set()).substr(0, 100));
    EXPECT_EQ(message(name), name + ": ends after 100 bytes: must have a header of 128");
}

TEST(TileSetFile, DoesNotWriteWhatItWouldRefuse)
{
    const TemporaryFolder folder;
    PoissonTileSet set = unusual_set();
    set.points.pop_back();
    EXPECT_THROW(write_tile_set(folder.path() / "a", set), InputError);
    set = unusual_set();
    set.parameters.tiles = 80;
    EXPECT_THROW(write_tile_set(folder.path() / "a.json", set), InputError);
    EXPECT_TRUE(folder.names().empty());
    EXPECT_THROW(write_tile_set(folder.path() / "no" / "a", unusual_set()), StorageError);
}

class TileSetJson : public testing::Test
{
protected:
    TileSetJson()
    {
        PoissonTileSet set = random_points(corner_parameters(1, 4, 0.5));
        set.squared_min_distance = 5000;
        set.points = {1, 2, 3, 4, 5, 6, 7, 65535};
        write_tile_set(folder_.path() / "a.json", set);
        text_ = read_whole_file(folder_.path() / "a.json");
    }

    /// The complaint of the reader after a part of the text was replaced.
    std::string error_with(const std::string& part, const std::string& replacement) const
    {
        std::string text = text_;
        const std::size_t at = text.find(part);
        if (at == std::string::npos) return "the part is not there";
        return error_of(text.replace(at, part.size(), replacement));
    }

    TemporaryFolder folder_;
    std::string text_;
};

TEST_F(TileSetJson, EveryValueIsChecked)
{
    EXPECT_EQ(error_of(text_), "accepted");
    EXPECT_EQ(error_with("poissonlab tile set", "x"), "a.ptiles: format: must be \"poissonlab tile set\"");
    EXPECT_EQ(error_with("\"version\": 3", "\"version\": 5"), "a.ptiles: version = 5: must be 1 to 4");
    EXPECT_EQ(error_with("\"version\": 3", "\"version\": 4"), "a.ptiles: class_points: is missing");
    EXPECT_EQ(error_with("\"version\": 3", "\"version\": 3, \"class_points\": [4]"),
              "a.ptiles: class_points: is for version 4");
    EXPECT_EQ(error_with("\"corner\"", "\"corn\""),
              "a.ptiles: kind = \"corn\": must be one of corner, edge, template, sphere");
    EXPECT_EQ(error_with("\"corner\"", "\"sphere\""), "a.ptiles: dimension = 2: must be 3");
    EXPECT_EQ(error_with("\"colors\": 1", "\"colors\": 1.0"),
              "a.ptiles: colors = 1.0: must be an integer from 0 to 4294967295");
    EXPECT_EQ(error_with("\"colors\": 1,", ""), "a.ptiles: colors: is missing");
    EXPECT_EQ(error_with("\"colors\"", "\"colours\": 1, \"colors\"").substr(0, 40),
              "a.ptiles: colours: unknown key; known ke");
    EXPECT_EQ(error_with("\"repulsion\": false", "\"repulsion\": 0"), "a.ptiles: repulsion = 0: must be true or false");
    EXPECT_EQ(error_with("\"relative_radius\": 0.5", "\"relative_radius\": {}"),
              "a.ptiles: relative_radius = object: must be a number");
    EXPECT_THAT(error_with("\"tiles\": 1", "\"tiles\": 4000000000"), HasSubstr("tiles = 4000000000: must be"));
    EXPECT_EQ(error_with("65535", "65536"), "a.ptiles: tile_points[0] = 65536: must be an integer from 0 to 65535");
    EXPECT_EQ(error_with("65535", "-1"), "a.ptiles: tile_points[0] = -1: must be an integer from 0 to 65535");
    EXPECT_EQ(error_with(", 65535", ""), "a.ptiles: tile_points[0]: a point: must be a list of 2");
    EXPECT_EQ(error_with(", [7, 65535]", ""), "a.ptiles: tile_points[0]: must be a list of 4");
    EXPECT_THAT(error_with("\"guaranteed_relative_radius\": 0.", "\"guaranteed_relative_radius\": 0.9"),
                HasSubstr("must be that of min_distance"));
    EXPECT_THAT(error_with("\"min_distance\": 0", "\"min_distance\": -0"), HasSubstr("min_distance = -0.00"));
}

TEST_F(TileSetJson, DamageIsReadOrRefused)
{
    std::mt19937 random(1);
    for (int i = 0; i < 5000; ++i) {
        std::string text = text_;
        for (unsigned change = 0; change <= random() % 3; ++change) {
            const std::size_t at = random() % text.size();
            if (random() % 3 == 0)
                text.resize(at + 1);
            else
                text[at] = static_cast<char>(random() % 2 ? random() % 256 : '0' + random() % 10);
        }
        error_of(text); // other exceptions fail the test
    }
    for (std::size_t size = 0; size + 2 < text_.size(); ++size) ASSERT_NE(error_of(text_.substr(0, size)), "accepted");
    error_of("{\"a\":" + std::string(1'000'000, '['));
}

}
}
