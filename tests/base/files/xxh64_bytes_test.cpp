// XXH64 of bytes against published hashes, and against itself in parts.
#include "base/files/xxh64_bytes.hpp"

#include "tiles/tilings/tile_lattice.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace poissonlab {
namespace {

TEST(Xxh64Bytes, GivesWhatIsPublished)
{
    // The test vectors of github.com/cespare/xxhash.
    EXPECT_EQ(xxh64_bytes(""), 0xef46db3751d8e999u);
    EXPECT_EQ(xxh64_bytes("a"), 0xd24ec4f1a98c6e5bu);
    EXPECT_EQ(xxh64_bytes("as"), 0x1c330fb2d66be179u);
    EXPECT_EQ(xxh64_bytes("asd"), 0x631c37ce72a97393u);
    EXPECT_EQ(xxh64_bytes("asdf"), 0x415872f599cea71eu);
    EXPECT_EQ(xxh64_bytes("Call me Ishmael. Some years ago--never mind how long precisely-"), 0x02a2e85470d6fd96u);
}

/// The buffer of the sanity checks of xxHash itself, tests/sanity_test.c.
std::string sanity_buffer(std::size_t size)
{
    std::string buffer;
    for (std::uint64_t state = 2654435761; buffer.size() < size; state *= 11400714785074694797u)
        buffer.push_back(static_cast<char>(state >> 56));
    return buffer;
}

TEST(Xxh64Bytes, PassesTheSanityChecksOfXxHash)
{
    constexpr std::uint64_t seed = 2654435761;
    EXPECT_EQ(xxh64_bytes(sanity_buffer(0), seed), 0xac75fda2929b17efu);
    EXPECT_EQ(xxh64_bytes(sanity_buffer(1)), 0xe934a84adb052768u);
    EXPECT_EQ(xxh64_bytes(sanity_buffer(1), seed), 0x5014607643a9b4c3u);
    EXPECT_EQ(xxh64_bytes(sanity_buffer(4)), 0x9136a0dca57457eeu);
    EXPECT_EQ(xxh64_bytes(sanity_buffer(14)), 0x8282dcc4994e35c8u);
    EXPECT_EQ(xxh64_bytes(sanity_buffer(14), seed), 0xc3bd6bf63deb6df0u);
    EXPECT_EQ(xxh64_bytes(sanity_buffer(222)), 0xb641ae8cb691c174u);
    EXPECT_EQ(xxh64_bytes(sanity_buffer(222), seed), 0x20cb8ab7ae10c14au);
}

TEST(Xxh64Bytes, IsTheHashOfWords)
{
    const std::string zeros(24, '\0');
    EXPECT_EQ(xxh64_bytes(zeros, 9), xxh64({0, 0, 0}, 9));
    for (std::uint64_t i = 1; i < 1000; ++i) {
        const std::array words{i * 0x9E3779B97F4A7C15, ~i, i << 40};
        const std::string_view bytes(reinterpret_cast<const char*>(words.data()), sizeof(words)); // low ones first
        ASSERT_EQ(xxh64_bytes(bytes.substr(0, 8), i), xxh64({words[0]}, i));
        ASSERT_EQ(xxh64_bytes(bytes.substr(0, 16), i), xxh64({words[0], words[1]}, i));
        ASSERT_EQ(xxh64_bytes(bytes, i), xxh64({words[0], words[1], words[2]}, i));
    }
}

TEST(Xxh64Bytes, PartsAreTheWhole)
{
    const std::string whole = sanity_buffer(150);
    for (std::size_t a = 0; a <= whole.size(); ++a) {
        for (std::size_t b = a; b <= whole.size(); b += 7) {
            Xxh64 hash(3);
            hash.add(std::string_view(whole).substr(0, a));
            hash.add(std::string_view(whole).substr(a, b - a));
            hash.add(std::string_view(whole).substr(b));
            ASSERT_EQ(hash.value(), xxh64_bytes(whole, 3)) << a << " " << b;
        }
    }
}

}
}
