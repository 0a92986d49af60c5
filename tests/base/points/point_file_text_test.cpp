// Text point files: what is accepted, and the message for each thing that is not.
#include "tests/base/points/input_error_of.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<PointSet> read_text(std::string_view content)
{
    const TemporaryFolder folder;
    return read_points(folder.write("points.dat", content));
}

PointSet plane_of(std::vector<double> coordinates) { return {2, std::move(coordinates)}; }

TEST(PointFileText, ReadsBlanksTabsAndCommas)
{
    EXPECT_THAT(read_text("0.1 0.2\n\t.3 \t+0.4  \n5e-1,6E-1\n0.7 , 0.8\n"),
                ElementsAre(plane_of({0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8})));
}

TEST(PointFileText, ReadsThreeCoordinates)
{
    EXPECT_THAT(read_text("0 0 0\n0.1 0.2 0.3\n"), ElementsAre(PointSet{3, {0, 0, 0, 0.1, 0.2, 0.3}}));
}

TEST(PointFileText, ReadsFilesOfOtherSystemsAndEditors)
{
    EXPECT_THAT(read_text("\xEF\xBB\xBF# a comment\r\n0.1 0.2\r\n\r\n0.3 0.4"),
                ElementsAre(plane_of({0.1, 0.2, 0.3, 0.4})));
}

TEST(PointFileText, SeparatesRealizationsAtALoneHash)
{
    const std::vector<PointSet> expected{plane_of({0.1, 0.2, 0.3, 0.4}), plane_of({0.5, 0.6})};
    EXPECT_EQ(read_text("0.1 0.2\n0.3 0.4\n#\n0.5 0.6\n"), expected);
    EXPECT_EQ(read_text("#\n0.1 0.2\n# words\n0.3 0.4\n # \r\n0.5 0.6\n#\n"), expected);
}

TEST(PointFileText, AcceptsPointsThatCoincide)
{
    EXPECT_THAT(read_text("0.5 0.5\n0.5 0.5\n"), ElementsAre(plane_of({0.5, 0.5, 0.5, 0.5})));
}

TEST(PointFileText, TakesWhatIsNearerToZeroThanEveryDoubleAsZero)
{
    EXPECT_THAT(read_text("1e-400 4.9406564584124654e-324\n"), ElementsAre(plane_of({0, 4.9406564584124654e-324})));
}

TEST(PointFileText, RefusesOneAndSaysWhatItIsOnTheTorus)
{
    EXPECT_EQ(input_error_of("points.dat", "0.5 0.5\n0.5 1.0\n"),
              "points.dat:2: 1.0: must be a number in [0, 1), without 1 itself (on the torus, 1 is 0)");
    // So near to 1 that the nearest double is 1.
    EXPECT_THAT(input_error_of("points.dat", "0.99999999999999999999 0.5\n"),
                StartsWith("points.dat:1: 0.99999999999999999999: must be a number in [0, 1), without 1 itself"));
}

TEST(PointFileText, RefusesWhatIsNoCoordinate)
{
    for (const std::string value : {"-0.1", "1.5", "nan", "-nan", "inf", "-inf", "512", "-1e-300"}) {
        EXPECT_EQ(input_error_of("points.dat", "# head\n0.5 " + value + "\n"),
                  "points.dat:2: " + value + ": must be a number in [0, 1)");
    }
    for (const std::string value : {"x", "0.1.2", "1e400", "0x1p-1", "0.1;0.2", "+-0.1", "--0.1", "0.1f"}) {
        EXPECT_EQ(input_error_of("points.dat", "0.5 0.5\n0.5 " + value + "\n"),
                  "points.dat:2: " + value +
                      ": must be a number in [0, 1); a line that is not a point starts with `# `");
    }
}

TEST(PointFileText, RefusesCommasWithNothingBesideThem)
{
    for (const std::string line : {"0.1,,0.2", "0.1,0.2,", ",0.1,0.2", ","}) {
        EXPECT_THAT(input_error_of("points.dat", line), StartsWith("points.dat:1: nothing beside a comma: must be"));
    }
}

TEST(PointFileText, RefusesOtherNumbersOfCoordinates)
{
    EXPECT_EQ(input_error_of("points.dat", "0.1 0.2\n0.5\n"),
              "points.dat:2: 1 coordinate: a point has 2 or 3; a line that is not a point starts with `# `");
    EXPECT_EQ(input_error_of("points.dat", "0.1 0.2 0.3 0.4\n"),
              "points.dat:1: 4 coordinates: a point has 2 or 3; a line that is not a point starts with `# `");
}

TEST(PointFileText, RefusesLinesOfUnequalLength)
{
    EXPECT_EQ(input_error_of("points.dat", "0.1 0.2\n\n0.1 0.2 0.3\n"),
              "points.dat:3: 3 coordinates: must be 2, as on the lines before");
    EXPECT_EQ(input_error_of("points.dat", "0.1 0.2 0.3\n#\n0.1 0.2\n"),
              "points.dat:3: 2 coordinates: must be 3, as on the lines before");
}

TEST(PointFileText, RefusesFilesWithoutPoints)
{
    const std::string expected = "points.dat: no points: must have one point a line, 2 or 3 coordinates in [0, 1)";
    for (const std::string_view content : {"", "\n\n", "# words\n", "#\n", "#\n#\n"}) {
        EXPECT_EQ(input_error_of("points.dat", content), expected);
    }
}

TEST(PointFileText, RefusesARealizationWithoutPoints)
{
    EXPECT_EQ(input_error_of("points.dat", "0.1 0.2\n#\n#\n0.3 0.4\n"),
              "points.dat:3: #: there must be points between two lines with `#` alone");
}

TEST(PointFileText, RefusesBinaryFilesInPrintableWords)
{
    EXPECT_EQ(input_error_of("points.dat", std::string_view("\x89PNG\r\n\x1a\n\0\0", 10)),
              "points.dat:1: ?PNG: not text; a point file is text, PLY, NumPy (.npy), HDF5 or UTK (.bin)");
    EXPECT_EQ(input_error_of("points.dat", std::string_view("0.1\0\1\2", 6)),
              "points.dat:1: 0.1???: not text; a point file is text, PLY, NumPy (.npy), HDF5 or UTK (.bin)");
    EXPECT_THAT(input_error_of("points.dat", std::string(100000, 'a')),
                StartsWith("points.dat:1: " + std::string(40, 'a') + "...: must be"));
}

/// Many languages write decimals so: one number would be two.
TEST(PointFileText, NamesDecimalCommas)
{
    const std::string words = "the comma of \"0,5\" is no decimal point: must be 0.5";
    for (const char* content : {"0,5 0,25\n", "0,5 0\n", "0.1 0.2\n0.2 0.3\n0,5 0,25\n", "x,y\n0,5;0,25\n"})
        EXPECT_THAT(input_error_of("points.dat", content), HasSubstr(words)) << content;
    const TemporaryFolder folder;
    EXPECT_THAT(refusal_of([&] {
                    read_points(folder.write("a.txt", "12,5 7\n"), CoordinateRange{0, 100});
                }),
                HasSubstr("the comma of \"12,5\" is no decimal point: must be 12.5"));
    for (const char* content : {"0,0\n0.5,0.5\n", "0, 0\n0 ,0\n", "0 , 0\n", "0.1,0.2\n"})
        EXPECT_NO_THROW(read_points(folder.write("good.txt", content))) << content;
    EXPECT_THAT(input_error_of("points.ply",
                               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                               "y\nproperty float z\nend_header\n0,5 0\n"),
                HasSubstr("blanks separate the numbers of PLY; " + words));
}

TEST(PointFileText, RefusesFoldersAndMissingFiles)
{
    const TemporaryFolder folder;
    EXPECT_EQ(input_error_of(folder.path() / "missing.dat"), "missing.dat: cannot be read: No such file or directory");
    std::filesystem::create_directory(folder.path() / "folder");
    EXPECT_EQ(input_error_of(folder.path() / "folder"), "folder: cannot be read: Is a directory");
}

}
}
