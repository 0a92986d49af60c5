// Bytes of values: every bit comes back, and what is cut or has more than it should is refused.
#include "base/files/byte_archive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

enum class Word : std::uint8_t
{
    first,
    second
};

struct Inner
{
    std::array<std::int16_t, 2> pair{};
    std::optional<double> number;

    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(pair, number);
    }
    bool operator==(const Inner&) const = default;
};

/// One of each kind of part.
struct Outer
{
    bool flag = false;
    Word word = Word::first;
    std::string text;
    std::vector<double> numbers;
    std::vector<std::array<std::int16_t, 2>> pairs;
    std::vector<std::vector<std::string>> texts;
    std::vector<Inner> inner;
    std::optional<Inner> none;

    bool operator==(const Outer&) const = default;
};

template <class Archive>
void serialize(Archive& archive, Outer& outer)
{
    archive(outer.flag, outer.word, outer.text, outer.numbers, outer.pairs, outer.texts, outer.inner, outer.none);
}

Outer example()
{
    return {true,
            Word::second,
            std::string("a\0b", 3),
            {0x1.23456789abcdep-7, 1e-300, 5e-324},
            {{-1, 2}, {3, -4}},
            {{"x", ""}, {}},
            {{{5, 6}, 0.1}, {{7, 8}, {}}},
            {}};
}

TEST(ByteArchive, GivesEveryPartBack)
{
    Outer back;
    from_bytes(to_bytes(example()), back);
    EXPECT_EQ(back, example());
}

TEST(ByteArchive, KeepsEveryBitOfNumbers)
{
    // The payload of a NaN, its sign, and the sign of zero are bits of their own (IEEE 754, 3.4 and 6.2).
    const std::vector<std::uint64_t> bits{0x7ff8000000000abc, 0xfff8000000000001, 0x8000000000000000,
                                          0x7ff0000000000000, 0x0000000000000001, 0x7fefffffffffffff};
    std::vector<double> numbers;
    for (const std::uint64_t word : bits) numbers.push_back(std::bit_cast<double>(word));
    std::vector<double> back;
    from_bytes(to_bytes(numbers), back);
    std::vector<std::uint64_t> bits_back;
    for (const double number : back) bits_back.push_back(std::bit_cast<std::uint64_t>(number));
    EXPECT_EQ(bits_back, bits);
}

TEST(ByteArchive, LongListsTakeTheirNumbersAndEightBytes)
{
    EXPECT_EQ(to_bytes(std::vector<double>(1000)).size(), 8008U);
}

TEST(ByteArchive, RefusesEveryCutAndEveryByteMore)
{
    const std::string bytes = to_bytes(example());
    Outer back;
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(from_bytes(bytes.substr(0, size), back), InputError) << size;
    EXPECT_THROW(from_bytes(bytes + '\0', back), InputError);
}

TEST(ByteArchive, CountsThatNoBytesFollowTakeNoMemory)
{
    for (const std::uint64_t count : {std::uint64_t{2}, std::uint64_t{1} << 61, ~std::uint64_t{0}}) {
        std::vector<double> numbers;
        EXPECT_THROW(from_bytes(to_bytes(count), numbers), InputError);
        std::vector<Inner> values;
        EXPECT_THROW(from_bytes(to_bytes(count), values), InputError);
        std::string text;
        EXPECT_THROW(from_bytes(to_bytes(count), text), InputError);
    }
}

}
}
