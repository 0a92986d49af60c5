// Points of the plane with a third coordinate that is always the same, in every format.
#include "base/points/flat_points.hpp"

#include "tests/base/points/binary_file.hpp"
#include "tests/base/points/input_error_of.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

using testing::EndsWith;

std::string npy_of(const std::vector<double>& values, const std::string& shape)
{
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + shape + "), }";
    header.resize(118 - 1, ' ');
    std::string bytes = std::string("\x93NUMPY\x01\x00", 8) +
                        bytes_of(static_cast<std::uint16_t>(header.size() + 1), std::endian::little) + header + "\n";
    for (const double value : values) bytes += bytes_of(value, std::endian::little);
    return bytes;
}

std::string utk_of(const std::vector<double>& values, std::uint32_t points)
{
    std::string bytes = "UTK!" + std::string("\x05\x00\x00\x00", 4);
    for (const std::uint32_t number : {1U, points, 3U}) bytes += bytes_of(number, std::endian::little);
    for (const double value : values) bytes += bytes_of(value, std::endian::little);
    return bytes;
}

/// The sets that were read from a file, and the notes on them.
struct ReadSets
{
    std::vector<PointSet> sets;
    std::vector<std::string> told;
};

ReadSets read(const std::string& name, const std::string& content, std::optional<CoordinateRange> range = {})
{
    const TemporaryFolder folder;
    ReadSets result;
    result.sets =
        read_points(folder.write(name, content),
                    {.domain = range, .told = [&](const std::string& sentence) { result.told.push_back(sentence); }});
    return result;
}

TEST(FlatPoints, LoseTheirThirdCoordinateInEveryFormat)
{
    const PointSet plane{2, {0.125, 0.25, 0.5, 0.75}};
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                            "property double z\nend_header\n0.125 0.25 0\n0.5 0.75 0\n";
    for (const auto& [name, content] : {std::pair<std::string, std::string>{"a.txt", "0.125 0.25 0\n0.5 0.75 0\n"},
                                        {"a.csv", "x,y,z\n0.125,0.25,0.5\n0.5,0.75,0.5\n"},
                                        {"a.npy", npy_of({0.125, 0.25, 0, 0.5, 0.75, 0}, "2, 3")},
                                        {"a.bin", utk_of({0.125, 0.25, 0, 0.5, 0.75, 0}, 2)},
                                        {"a.ply", ply}}) {
        const ReadSets flat = read(name, content);
        EXPECT_EQ(flat.sets, std::vector{plane}) << name;
        ASSERT_EQ(flat.told.size(), 1U) << name;
        EXPECT_THAT(flat.told[0], EndsWith(name + ": " + flat_sentence(2)));
    }
}

TEST(FlatPoints, AreThoseOfAllSetsOfAFile)
{
    EXPECT_EQ(read("a", "0.1 0.2 0.5\n#\n0.3 0.4 0.5\n").sets,
              (std::vector<PointSet>{{2, {0.1, 0.2}}, {2, {0.3, 0.4}}}));
    const ReadSets space = read("a", "0.1 0.2 0.5\n#\n0.3 0.4 0.6\n");
    EXPECT_EQ(space.sets, (std::vector<PointSet>{{3, {0.1, 0.2, 0.5}}, {3, {0.3, 0.4, 0.6}}}));
    EXPECT_TRUE(space.told.empty());
}

TEST(FlatPoints, LieAcrossAnyAxis)
{
    const ReadSets across_x = read("a", "0.5 0.1 0.2\n0.5 0.3 0.4\n");
    EXPECT_EQ(across_x.sets, (std::vector<PointSet>{{2, {0.1, 0.2, 0.3, 0.4}}}));
    EXPECT_THAT(across_x.told.at(0), EndsWith("all points have the same first coordinate: they are taken as points of "
                                              "the plane, without it"));
    EXPECT_EQ(read("a", "0.1 0.5 0.2\n0.3 0.5 0.4\n").sets, (std::vector<PointSet>{{2, {0.1, 0.2, 0.3, 0.4}}}));
    EXPECT_EQ(read("a", "0.5 0.1 0\n0.5 0.3 0\n").sets, (std::vector<PointSet>{{2, {0.5, 0.1, 0.5, 0.3}}}));
}

TEST(FlatPoints, OnePointIsFlatAtZeroOnly)
{
    EXPECT_EQ(read("a", "0.1 0.2 0\n").sets, (std::vector<PointSet>{{2, {0.1, 0.2}}}));
    EXPECT_EQ(read("a", "0.1 0.2 0.3\n").sets, (std::vector<PointSet>{{3, {0.1, 0.2, 0.3}}}));
    EXPECT_EQ(read("a", "0.5 0.5 0\n", CoordinateRange{-1, 1}).sets, (std::vector<PointSet>{{2, {0.75, 0.75}}}));
}

TEST(FlatPoints, ThatTheProgramWroteKeepAllCoordinates)
{
    const TemporaryFolder folder;
    const PointSet space{3, {0.1, 0.2, 0.5, 0.3, 0.4, 0.5}};
    write_points(folder.path() / "own.dat", space);
    EXPECT_EQ(read_own_points(folder.path() / "own.dat"), std::vector{space});
    EXPECT_EQ(read_points(folder.path() / "own.dat").at(0).dimension, 2);
}

}
}
