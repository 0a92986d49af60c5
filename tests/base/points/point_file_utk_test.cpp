// UTK's binary point files: types, byte orders, several sets, and the message for each broken one.
#include "tests/base/points/binary_file.hpp"
#include "tests/base/points/input_error_of.hpp"

#include <gmock/gmock.h>

#include <cstdint>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

template <class T>
std::string utk(int type, std::uint32_t sets, std::uint32_t points, std::uint32_t dimension, std::vector<T> values,
                std::endian order = std::endian::little)
{
    std::string bytes = bytes_of(std::uint32_t{0x214B5455}, order) + std::string(1, static_cast<char>(type)) +
                        std::string(3, '\0') + bytes_of(sets, order) + bytes_of(points, order) +
                        bytes_of(dimension, order);
    for (const T value : values) bytes += bytes_of(value, order);
    return bytes;
}

std::vector<PointSet> read_utk(const std::string& content, std::optional<CoordinateRange> range = {})
{
    const TemporaryFolder folder;
    return read_points(folder.write("points.bin", content), range);
}

TEST(PointFileUtk, ReadsAllTypesOfEitherByteOrder)
{
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        EXPECT_THAT(read_utk(utk<double>(5, 1, 2, 2, {0.1, 0.2, 0.3, 0.4}, order)),
                    ElementsAre(PointSet{2, {0.1, 0.2, 0.3, 0.4}}));
        EXPECT_THAT(read_utk(utk<float>(4, 1, 1, 3, {0.5F, 0.25F, 0.125F}, order)),
                    ElementsAre(PointSet{3, {0.5, 0.25, 0.125}}));
        const CoordinateRange range{0, 8};
        const PointSet point{2, {0.5, 0.125}};
        EXPECT_THAT(read_utk(utk<std::int32_t>(0, 1, 1, 2, {4, 1}, order), range), ElementsAre(point));
        EXPECT_THAT(read_utk(utk<std::int64_t>(1, 1, 1, 2, {4, 1}, order), range), ElementsAre(point));
        EXPECT_THAT(read_utk(utk<std::uint32_t>(2, 1, 1, 2, {4, 1}, order), range), ElementsAre(point));
        EXPECT_THAT(read_utk(utk<std::uint64_t>(3, 1, 1, 2, {4, 1}, order), range), ElementsAre(point));
    }
}

TEST(PointFileUtk, ReadsSeveralSets)
{
    EXPECT_THAT(read_utk(utk<double>(5, 2, 1, 2, {0.1, 0.2, 0.3, 0.4})),
                ElementsAre(PointSet{2, {0.1, 0.2}}, PointSet{2, {0.3, 0.4}}));
}

TEST(PointFileUtk, ThatAreBrokenAreRefusedInOneLine)
{
    const auto refused = [](const std::string& content) { return refusal_of([&] { read_utk(content); }); };
    const std::vector<double> values{0.1, 0.2, 0.3, 0.4};
    EXPECT_THAT(refused("UTK!"), HasSubstr("must have a whole UTK header of 20"));
    EXPECT_THAT(refused(utk(6, 1, 2, 2, values)), HasSubstr("type 6: must be 0 to 5"));
    EXPECT_THAT(refused(utk(5, 1, 1, 4, values)), HasSubstr("4 dimensions: must be 2 or 3"));
    EXPECT_THAT(refused(utk(5, 0, 2, 2, values)), HasSubstr("0 sets of 2 points"));
    EXPECT_THAT(refused(utk(5, 1, 3, 2, values)), HasSubstr("32 bytes of coordinates: must be 1 x 3 x 2 x 8"));
    EXPECT_THAT(refused(utk(5, UINT32_MAX, UINT32_MAX, 2, values)), HasSubstr("32 bytes of coordinates"));
    EXPECT_THAT(refused(utk<double>(5, 1, 1, 2, {0.5, 1.5})), HasSubstr("byte 28: 1.5: must be a number in [0, 1)"));
}

}
}
