// Coordinates that rounding has moved to the end of their range, in binary files.
#include "tests/base/points/binary_file.hpp"
#include "tests/base/points/input_error_of.hpp"
#include "tests/base/points/read_set.hpp"

#include <gmock/gmock.h>

#include <cstdint>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A file of NumPy, N x 2, of float32 or float64.
template <class Number>
std::string npy(const std::vector<Number>& values)
{
    std::string header = "{'descr': '<f" + std::to_string(sizeof(Number)) + "', 'fortran_order': False, 'shape': (" +
                         std::to_string(values.size() / 2) + ", 2), }";
    header.resize(118 - 1, ' ');
    std::string bytes = std::string("\x93NUMPY\x01\x00", 8) +
                        bytes_of(static_cast<std::uint16_t>(header.size() + 1), std::endian::little) + header + "\n";
    for (const Number value : values) bytes += bytes_of(value, std::endian::little);
    return bytes;
}

constexpr auto one_of_four = "a.npy: 1 of 4 coordinates lie on the end of [0, 1) by rounding: taken as 0, as on the "
                             "torus";

TEST(RoundedCoordinates, OfFloatsAreZero)
{
    const ReadSet read = read_set("a.npy", npy<float>({0.25F, static_cast<float>(1 - 1e-9), 0.5F, 0.75F}));
    EXPECT_EQ(read.set, (PointSet{2, {0.25, 0, 0.5, 0.75}}));
    EXPECT_THAT(read.told, ElementsAre(one_of_four));
}

TEST(RoundedCoordinates, OfDoublesAreZero)
{
    const ReadSet read = read_set("a.npy", npy<double>({0.25, 1, 0.5, 0.75}));
    EXPECT_EQ(read.set, (PointSet{2, {0.25, 0, 0.5, 0.75}}));
    EXPECT_THAT(read.told, ElementsAre(one_of_four));
    EXPECT_EQ(input_error_of("a.npy", npy<double>({0.25, 1 + 0x1p-52})),
              "a.npy: byte 136: 1.0000000000000002: must be a number in [0, 1)");
}

/// The nearest float to 0.1 is 0.100000001490116.
TEST(RoundedCoordinates, MayBeFartherThanTheEnd)
{
    const ReadSet read = read_set("a.npy", npy<float>({0.05F, 0.1F, -0.1F, 0}), {.domain = CoordinateRange{-0.1, 0.1}});
    EXPECT_EQ(read.set.coordinates[1], 0);
    EXPECT_EQ(read.set.coordinates[2], 0);
    EXPECT_THAT(read.told, ElementsAre("a.npy: 2 of 4 coordinates lie on the end of [-0.1, 0.1) by rounding: taken as "
                                       "-0.1, as on the torus"));
    EXPECT_EQ(input_error_of("a.npy", npy<float>({0.5F, 1 + 0x1p-23F})),
              "a.npy: byte 132: 1.0000001192092896: must be a number in [0, 1)");
}

TEST(RoundedCoordinates, AreFewer)
{
    std::vector<double> grid;
    for (int i = 0; i <= 10; ++i)
        for (int j = 0; j <= 10; ++j) {
            grid.push_back(i / 10.0);
            grid.push_back(j / 10.0);
        }
    EXPECT_EQ(input_error_of("a.npy", npy(grid)),
              "a.npy: byte 296: 1: must be a number in [0, 1), without 1 itself (on the torus, 1 is 0); 22 of 242 "
              "coordinates lie there, more than rounding explains");
}

TEST(RoundedCoordinates, AreThoseOfBinaryNumbersOnly)
{
    EXPECT_EQ(input_error_of("a.txt", "0.5 1\n"),
              "a.txt:1: 1: must be a number in [0, 1), without 1 itself (on the torus, 1 is 0)");
    EXPECT_THAT(read_set("a.npy", npy<float>({0.5F, 0})).told, IsEmpty());
    std::string utk = "UTK!" + std::string("\x04\x00\x00\x00", 4);
    for (const std::uint32_t number : {1U, 1U, 2U}) utk += bytes_of(number, std::endian::little);
    EXPECT_EQ(read_set("a.bin", utk + bytes_of(1.0F, std::endian::little) + bytes_of(0.5F, std::endian::little)).set,
              (PointSet{2, {0, 0.5}}));
}

TEST(RoundedCoordinates, OfPlyAreZero)
{
    const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
                             "property double y\nend_header\n";
    EXPECT_EQ(read_set("a.ply", head + bytes_of(0.5F, std::endian::little) + bytes_of(1.0, std::endian::little)).set,
              (PointSet{2, {0.5, 0}}));
}

}
}
