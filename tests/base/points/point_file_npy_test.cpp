// NumPy point files: types, byte orders, shapes and memory orders, and the message for each broken one.
#include "tests/base/points/binary_file.hpp"
#include "tests/base/points/input_error_of.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <limits>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

/// A file as numpy.save writes it: version 1 has a length of 16 bits, versions 2 and 3 of 32.
std::string npy(const std::string& type, const std::string& order, const std::string& shape, const std::string& data,
                int version = 1)
{
    const std::string header = "{'descr': " + type + ", 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
    const std::string length = version == 1 ? bytes_of(static_cast<std::uint16_t>(header.size()), std::endian::little)
                                            : bytes_of(static_cast<std::uint32_t>(header.size()), std::endian::little);
    return "\x93NUMPY" + std::string(1, static_cast<char>(version)) + std::string(1, '\0') + length + header + data;
}

template <class T>
std::string values(std::initializer_list<T> numbers, std::endian order = std::endian::little)
{
    std::string bytes;
    for (const T number : numbers) bytes += bytes_of(number, order);
    return bytes;
}

std::vector<PointSet> read_npy(std::string_view content)
{
    const TemporaryFolder folder;
    return read_points(folder.write("points.npy", content));
}

TEST(PointFileNpy, ReadsDoubles)
{
    const std::string data = values({0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
    for (const int version : {1, 2, 3}) {
        EXPECT_THAT(read_npy(npy("'<f8'", "False", "(3, 2)", data, version)),
                    ElementsAre(PointSet{2, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}}));
    }
    EXPECT_THAT(read_npy(npy("'<f8'", "False", "(2, 3)", data)),
                ElementsAre(PointSet{3, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}}));
}

TEST(PointFileNpy, ReadsBigEndianFloats)
{
    EXPECT_THAT(read_npy(npy("'>f4'", "False", "(1, 2)", values({0.1F, 0.2F}, std::endian::big))),
                ElementsAre(PointSet{2, {0.1F, 0.2F}}));
    EXPECT_THAT(read_npy(npy("'>f8'", "False", "(1, 2)", values({0.1, 0.2}, std::endian::big))),
                ElementsAre(PointSet{2, {0.1, 0.2}}));
    EXPECT_THAT(read_npy(npy("'<f4'", "False", "(1, 2)", values({0.1F, 0.2F}))),
                ElementsAre(PointSet{2, {0.1F, 0.2F}}));
}

TEST(PointFileNpy, ReadsRealizations)
{
    EXPECT_THAT(read_npy(npy("'<f8'", "False", "(2, 1, 3)", values({0.1, 0.2, 0.3, 0.4, 0.5, 0.6}))),
                ElementsAre(PointSet{3, {0.1, 0.2, 0.3}}, PointSet{3, {0.4, 0.5, 0.6}}));
}

TEST(PointFileNpy, ReadsFortranOrder)
{
    // The first index runs fastest: all x, then all y.
    EXPECT_THAT(read_npy(npy("'<f8'", "True", "(3, 2)", values({0.1, 0.3, 0.5, 0.2, 0.4, 0.6}))),
                ElementsAre(PointSet{2, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}}));
    // (realization, point, axis): 000 100 010 110 001 101 011 111.
    EXPECT_THAT(
        read_npy(npy("'<f8'", "True", "(2, 2, 2)", values({0.000, 0.100, 0.010, 0.110, 0.001, 0.101, 0.011, 0.111}))),
        ElementsAre(PointSet{2, {0.000, 0.001, 0.010, 0.011}}, PointSet{2, {0.100, 0.101, 0.110, 0.111}}));
}

TEST(PointFileNpy, RefusesOtherTypes)
{
    for (const std::string type : {"'<i4'", "'<f2'", "'|u1'", "'<c16'"}) {
        EXPECT_EQ(input_error_of("points.npy", npy(type, "False", "(1, 2)", "")),
                  "points.npy: type " + type + ": must be float32 or float64 ('<f4' or '<f8')");
    }
    EXPECT_THAT(input_error_of("points.npy", npy("[('x', '<f8'), ('y', '<f8')]", "False", "(1,)", "")),
                StartsWith("points.npy: type [('x': must be float32 or float64"));
}

TEST(PointFileNpy, RefusesOtherShapes)
{
    for (const std::string shape :
         {"(2,)", "()", "(2, 4)", "(2, 1)", "(1, 1, 1, 2)", "(-1, 2)", "(a, 2)", "(99999999999999999999, 2)"}) {
        const std::string message = input_error_of("points.npy", npy("'<f8'", "False", shape, ""));
        EXPECT_EQ(message, "points.npy: shape " + shape + ": must be (N, 2), (N, 3), (K, N, 2) or (K, N, 3)");
    }
}

TEST(PointFileNpy, RefusesArraysWithoutPoints)
{
    for (const std::string shape : {"(0, 2)", "(0, 5, 2)", "(1152921504606846976, 0, 2)"}) {
        EXPECT_EQ(input_error_of("points.npy", npy("'<f8'", "False", shape, "")),
                  "points.npy: no points: N and K of the shape must be at least 1");
    }
}

TEST(PointFileNpy, RefusesSizesThatDoNotFitTheShape)
{
    const std::string data = values({0.1, 0.2, 0.3, 0.4});
    EXPECT_EQ(input_error_of("points.npy", npy("'<f8'", "False", "(2, 2)", data.substr(0, 31))),
              "points.npy: 31 bytes of coordinates: must be 32, as the shape says");
    EXPECT_EQ(input_error_of("points.npy", npy("'<f8'", "False", "(1, 2)", data)),
              "points.npy: 32 bytes of coordinates: must be 16, as the shape says");
    EXPECT_EQ(input_error_of("points.npy", npy("'<f8'", "False", "(1000000000000, 2)", data)),
              "points.npy: 32 bytes of coordinates: must be 16000000000000, as the shape says");
    // 2^60 * 2 * 8 is 2^64: 0 if it overflowed unnoticed.
    for (const std::string shape : {"(1152921504606846976, 2)", "(4294967296, 4294967296, 2)"}) {
        EXPECT_EQ(input_error_of("points.npy", npy("'<f8'", "False", shape, "")),
                  "points.npy: shape: declares more values than any file can hold");
    }
}

TEST(PointFileNpy, RefusesTruncatedHeaders)
{
    const std::string file = npy("'<f8'", "False", "(1, 2)", "");
    for (const std::size_t size : {std::size_t{6}, std::size_t{9}, std::size_t{30}, file.size() - 1}) {
        EXPECT_EQ(input_error_of("points.npy", file.substr(0, size)),
                  "points.npy: ends after " + std::to_string(size) + " bytes: must have a whole NumPy header");
    }
    EXPECT_EQ(input_error_of("points.npy", std::string("\x93NUMPY\x02\0\xff\xff\xff\xff{}", 14)),
              "points.npy: ends after 14 bytes: must have a whole NumPy header");
    EXPECT_EQ(input_error_of("points.npy", std::string("\x93NUMPY\x01\0\x04\0{  }", 14)),
              "points.npy: NumPy header: must have the key 'descr'");
}

TEST(PointFileNpy, NamesTheByteOfABadCoordinate)
{
    for (const auto& [value, word] :
         {std::pair{2.0, "2: must be a number in [0, 1)"}, std::pair{-0.5, "-0.5: must be a number in [0, 1)"},
          std::pair{std::numeric_limits<double>::infinity(), "inf: must be a number in [0, 1)"},
          std::pair{1 + 0x1p-52, "1.0000000000000002: must be a number in [0, 1)"}}) {
        const std::string file = npy("'<f8'", "False", "(2, 2)", values({0.1, 0.2, 0.3, value}));
        EXPECT_EQ(input_error_of("points.npy", file),
                  "points.npy: byte " + std::to_string(file.size() - 8) + ": " + word);
    }
}

}
}
