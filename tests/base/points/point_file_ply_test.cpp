// PLY point files as other programs write them, and the message for each broken one.
#include "tests/base/points/binary_file.hpp"
#include "tests/base/points/input_error_of.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <limits>

namespace poissonlab {
namespace {

using testing::ElementsAre;

PointSet read_ply(std::string_view content)
{
    const TemporaryFolder folder;
    const std::vector<PointSet> sets = read_points(folder.write("points.ply", content));
    EXPECT_EQ(sets.size(), 1);
    return sets.at(0);
}

/// An ascii file with x and y.
std::string ascii(const std::string& count, const std::string& body)
{
    return "ply\nformat ascii 1.0\nelement vertex " + count + "\nproperty float x\nproperty float y\nend_header\n" +
           body;
}

TEST(PointFilePly, ReadsAscii)
{
    EXPECT_EQ(read_ply(ascii("2", "0.1 0.2\n0.3 0.4\n")), (PointSet{2, {0.1, 0.2, 0.3, 0.4}}));
    EXPECT_EQ(read_ply(ascii("1", "0.1 0.2")), (PointSet{2, {0.1, 0.2}}));
    EXPECT_EQ(read_ply(ascii("1", "0 0")), (PointSet{2, {0, 0}}));
}

TEST(PointFilePly, ReadsWindowsLineEnds)
{
    EXPECT_EQ(read_ply("ply\r\nformat ascii 1.0\r\ncomment c\r\nelement vertex 1\r\nproperty double x\r\n"
                       "property double y\r\nend_header\r\n0.1 0.2\r\n\r\n"),
              (PointSet{2, {0.1, 0.2}}));
}

TEST(PointFilePly, DropsAZThatIsZeroAndKeepsAnyOther)
{
    const std::string head = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                             "property float z\nend_header\n";
    EXPECT_EQ(read_ply(head + "0.1 0.2 0\n0.3 0.4 0.0\n"), (PointSet{2, {0.1, 0.2, 0.3, 0.4}}));
    EXPECT_EQ(read_ply(head + "0.1 0.2 0\n0.3 0.4 0.5\n"), (PointSet{3, {0.1, 0.2, 0, 0.3, 0.4, 0.5}}));
}

std::vector<std::string> classes_of_ply(const std::string& content)
{
    const TemporaryFolder folder;
    std::vector<std::string> classes;
    PointReading how;
    how.classes = {"kind", [&](std::string_view name) { classes.emplace_back(name); }};
    read_points(folder.write("points.ply", content), how);
    return classes;
}

/// Numbers are one class if the property's type holds them as one, and classes of ascii files are those of binary ones.
TEST(PointFilePly, NamesClassesByTheTypeOfTheirProperty)
{
    const auto head = [](const std::string& format, const std::string& type) {
        return "ply\nformat " + format + " 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty " +
               type + " kind\nend_header\n";
    };
    const auto text = [&](const std::string& type, const std::vector<std::string>& words) {
        std::string content = head("ascii", type);
        for (const std::string& word : words) content += "0.5 0.25 " + word + "\n";
        return classes_of_ply(content);
    };
    const auto binary = [&]<class T>(const std::string& type, const std::vector<T>& values) {
        std::string content = head("binary_little_endian", type);
        for (const T value : values)
            for (const std::string& bytes : {bytes_of(0.5, std::endian::little), bytes_of(0.25, std::endian::little),
                                             bytes_of(value, std::endian::little)})
                content += bytes;
        return classes_of_ply(content);
    };
    const auto ones = ElementsAre("1", "1", "1", "-7");
    EXPECT_THAT(text("int", {"1", "01", "1.0", "-7"}), ones);
    EXPECT_THAT(binary("int", std::vector<std::int32_t>{1, 1, 1, -7}), ones);
    const auto fractions = ElementsAre("0.1", "0.1", "0", "0");
    for (const char* type : {"float", "double"}) EXPECT_THAT(text(type, {"0.1", "0.10", "0", "-0.0"}), fractions);
    EXPECT_THAT(binary("float", std::vector<float>{0.1F, 0.1F, 0, -0.0F}), fractions);
    EXPECT_THAT(binary("double", std::vector<double>{0.1, 0.1, 0, -0.0}), fractions);
    // More digits than a float has.
    EXPECT_THAT(text("float", {"16777217", "16777216", "1e300", "nan"}),
                ElementsAre("16777216", "16777216", "1e+300", ""));
    EXPECT_THAT(text("uint", {"4294967295", "0", "1", "2"}), ElementsAre("4294967295", "0", "1", "2"));
}

TEST(PointFilePly, FindsCoordinatesAmongOtherPropertiesAndElements)
{
    EXPECT_EQ(read_ply("ply\nformat ascii 1.0\nobj_info made by hand\nelement camera 1\nproperty list uchar int a\n"
                       "element vertex 1\nproperty uchar red\nproperty float y\nproperty float nx\n"
                       "property float x\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                       "2 7 7\n255 0.2 -3 0.1\n3 0 0 0\n"),
              (PointSet{2, {0.1, 0.2}}));
}

TEST(PointFilePly, ReadsBinaryOfEitherByteOrder)
{
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const std::string name = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
        std::string file = "ply\nformat " + name +
                           " 1.0\nelement camera 2\nproperty short a\n"
                           "element vertex 2\nproperty uchar red\nproperty double x\nproperty float y\n"
                           "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
        for (const std::int16_t a : {std::int16_t{1}, std::int16_t{2}}) file += bytes_of(a, order);
        for (const double x : {0.1, 0.3}) {
            file += '\xff' + bytes_of(x, order) + bytes_of(static_cast<float>(x) / 2, order);
        }
        file += std::string("\0", 1);
        EXPECT_EQ(read_ply(file), (PointSet{2, {0.1, 0.1F / 2, 0.3, 0.3F / 2}})) << name;
    }
}

TEST(PointFilePly, NamesTheLineOfABadCoordinate)
{
    EXPECT_EQ(input_error_of("points.ply", ascii("2", "0.1 0.2\n0.3 1\n")),
              "points.ply:8: 1: must be a number in [0, 1), without 1 itself (on the torus, 1 is 0)");
    EXPECT_EQ(input_error_of("points.ply", ascii("2", "0.1 0.2\n0.3 nan\n")),
              "points.ply:8: nan: must be a number in [0, 1)");
    EXPECT_EQ(input_error_of("points.ply", ascii("2", "0.1 0.2\n0.3\n")),
              "points.ply:8: 1 numbers: must be 2, as the header says");
}

TEST(PointFilePly, NamesTheByteOfABadCoordinate)
{
    const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\n"
                             "property double y\nend_header\n";
    const std::string at = std::to_string(head.size() + 8);
    const auto file = [&](double y) {
        return head + bytes_of(0.5, std::endian::little) + bytes_of(y, std::endian::little);
    };
    EXPECT_EQ(input_error_of("points.ply", file(2)), "points.ply: byte " + at + ": 2: must be a number in [0, 1)");
    EXPECT_EQ(input_error_of("points.ply", file(std::numeric_limits<double>::quiet_NaN())),
              "points.ply: byte " + at + ": nan: must be a number in [0, 1)");
}

TEST(PointFilePly, RefusesTruncatedFilesAndHugeCounts)
{
    for (const std::string count : {"3", "1000000000000", "18446744073709551615"}) {
        const std::string expected =
            "points.ply: element vertex " + count + ": the file ends before it has that many rows";
        EXPECT_EQ(input_error_of("points.ply", ascii(count, "0.1 0.2\n0.3 0.4\n")), expected);
        EXPECT_EQ(input_error_of("points.ply", "ply\nformat binary_little_endian 1.0\nelement vertex " + count +
                                                   "\nproperty double x\nproperty double y\nend_header\n" +
                                                   std::string(47, '\0')),
                  expected);
    }
    EXPECT_EQ(input_error_of("points.ply", ascii("18446744073709551616", "")),
              "points.ply:3: 18446744073709551616: must be a number of rows");
    EXPECT_EQ(input_error_of("points.ply", ascii("-1", "")), "points.ply:3: -1: must be a number of rows");
}

TEST(PointFilePly, RefusesHugeCountsOfOtherElements)
{
    for (const std::string format : {"ascii", "binary_big_endian"}) {
        EXPECT_EQ(input_error_of("points.ply", "ply\nformat " + format +
                                                   " 1.0\nelement camera 18446744073709551615\nproperty int a\n"
                                                   "element vertex 1\nproperty float x\nproperty float y\n"
                                                   "end_header\n0 0 0\n"),
                  "points.ply: element camera 18446744073709551615: the file ends before it has that many rows");
    }
}

TEST(PointFilePly, RefusesPointsThatTheHeaderDoesNotCount)
{
    EXPECT_EQ(input_error_of("points.ply", ascii("1", "0.1 0.2\n0.3 0.4\n")),
              "points.ply:8: 0.3 0.4: the header says that there are 1 vertices");
    EXPECT_EQ(input_error_of("points.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 1\n"
                                           "property float x\nproperty float y\nend_header\n" +
                                               std::string(16, '\0')),
              "points.ply: 8 bytes after the vertices: the header says that there are 1 vertices");
}

TEST(PointFilePly, RefusesHeadersThatItDoesNotUnderstand)
{
    const auto error = [](const std::string& header) { return input_error_of("points.ply", "ply\n" + header); };
    EXPECT_EQ(error(""), "points.ply: PLY header: must end with a line `end_header`");
    EXPECT_EQ(error("format ascii 1.0\n"), "points.ply: PLY header: must end with a line `end_header`");
    EXPECT_EQ(error("end_header\n"), "points.ply:2: end_header: a line `format ...` must come before");
    EXPECT_EQ(error("format text 1.0\n"),
              "points.ply:2: text: must be ascii, binary_little_endian or binary_big_endian");
    EXPECT_EQ(error("format ascii 1.0\nproperty float x\n"),
              "points.ply:3: property: an `element` line must come before");
    EXPECT_EQ(error("format ascii 1.0\nelement vertex 1\nproperty half x\n"),
              "points.ply:4: half: must be a type of PLY, such as float or double");
    EXPECT_EQ(error("format ascii 1.0\nvertices 1\n"),
              "points.ply:3: vertices 1: must be a `format`, `element`, `property`, `comment` or `end_header` line "
              "of PLY");
    EXPECT_EQ(error("format ascii 1.0\nend_header\n"), "points.ply: PLY header: must have an `element vertex`");
    EXPECT_EQ(error("format ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n"),
              "points.ply: PLY header: the element `vertex` must have the properties x and y");
    EXPECT_EQ(error("format ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nend_header\n"),
              "points.ply: no points: the element `vertex` must have at least one row");
    EXPECT_EQ(error("format ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                    "property list uchar int a\nend_header\n0 0 0\n"),
              "points.ply: PLY header: the element `vertex` must not have lists");
    EXPECT_EQ(error("format binary_little_endian 1.0\nelement face 1\nproperty list uchar int a\n"
                    "element vertex 1\nproperty float x\nproperty float y\nend_header\n"),
              "points.ply: element face: an element with lists must come after the vertices in a binary file");
}

}
}
