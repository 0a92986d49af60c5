// Tables as QGIS, R, pandas, Excel and this program write them, typed by hand: all of them hold the same two points.
#include "tests/base/points/input_error_of.hpp"
#include "tests/base/points/read_set.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const PointSet two{2, {0.5, 0.25, 0.125, 0.75}};
const PointSet two_in_space{3, {0.5, 0.25, 0.375, 0.125, 0.75, 0.625}};

PointSet table(std::string_view content) { return read_set("a.csv", content).set; }

std::vector<std::string> told_of(std::string_view content) { return read_set("a.csv", content).told; }

TEST(TextTable, HasColumnsOfTheseNamesInAnyCaseQuotedOrNot)
{
    for (const char* content : {
             "x,y\n0.5,0.25\n0.125,0.75\n",
             "X,Y\n0.5,0.25\n0.125,0.75\n",                   // QGIS
             "\"x\",\"y\"\n0.5,0.25\n0.125,0.75\n",           // R, row.names = FALSE
             "\"X\" , \"Y\"\n\"0.5\",\"0.25\"\n0.125,0.75\n", //
             "y,x\n0.25,0.5\n0.75,0.125\n",                   //
             "x y\n0.5 0.25\n0.125 0.75\n",                   // R, write.table without quotes and names
             "x\ty\n0.5\t0.25\n0.125\t0.75\n",                //
             "x;y\n0.5;0.25\n0.125;0.75\n",                   //
         }) {
        EXPECT_EQ(table(content), two) << content;
        EXPECT_THAT(told_of(content), IsEmpty()) << content;
    }
    EXPECT_EQ(table("X,Y,Z\n0.5,0.25,0.375\n0.125,0.75,0.625\n"), two_in_space);
}

TEST(TextTable, LeavesOutOtherColumnsWithAWord)
{
    const auto left_out = [](const std::string& names, const std::string& axes = "x and y") {
        return ElementsAre("a.csv: only the columns " + axes + " are read; left out: " + names);
    };
    for (const auto& [content, names] : {
             std::pair<const char*, const char*>{"id,x,y\n1,0.5,0.25\n2,0.125,0.75\n", "id"},
             {",x,y\n0,0.5,0.25\n1,0.125,0.75\n", "one without a name"},                     // pandas
             {",0,1\n0,0.5,0.25\n1,0.125,0.75\n", "one without a name"},                     // pandas, of an array
             {"\"\",\"x\",\"y\"\n\"1\",0.5,0.25\n\"2\",0.125,0.75\n", "one without a name"}, // R, write.csv
             {"x,y,class\n0.5,0.25,0\n0.125,0.75,3\n", "class"},                             // distribute classes
             {"fid;name;X;Y\n1;\"Oak; old\";0,5;0,25\n2;Elm;0,125;0,75\n", "fid, name"},
             {"name,x,h,y\n\"Oak, \"\"old\"\"\",0.5,7,0.25\n12 7,0.125,7,0.75\n", "name, h"},
         }) {
        EXPECT_EQ(table(content), two) << content;
        EXPECT_THAT(told_of(content), left_out(names)) << content;
    }
    EXPECT_EQ(table("x,y,z,class\n0.5,0.25,0.375,0\n0.125,0.75,0.625,1\n"), two_in_space);
    EXPECT_THAT(told_of("x,y,z,class\n0.5,0.25,0.375,0\n0.125,0.75,0.625,1\n"), left_out("class", "x, y and z"));
    EXPECT_EQ(table(",0,1,2\n0,0.5,0.25,0.375\n1,0.125,0.75,0.625\n"), two_in_space);
}

TEST(TextTable, ReadsNumbersAsNamesOfColumnsBeforeFractions)
{
    EXPECT_EQ(table("0,1\n0.5,0.25\n0.125,0.75\n"), two); // pandas, of an array, index=False
    EXPECT_THAT(told_of("0,1\n0.5,0.25\n"),
                ElementsAre("a.csv: the first line is read as the column numbers that pandas writes, not as a point"));
    EXPECT_EQ(table("0,1,2\n0.5,0.25,0.375\n0.125,0.75,0.625\n"), two_in_space);
    EXPECT_EQ(table("# domain 0:8\n0,1\n4,2\n"), (PointSet{2, {0, 0.125, 0.5, 0.25}}));
    EXPECT_EQ(table("# domain 0:8\n0 1\n4.0 2.0\n"), (PointSet{2, {0, 0.125, 0.5, 0.25}}));
}

TEST(TextTable, LeavesOutClassesAsPlyDoes)
{
    const ReadSet ply =
        read_set("a.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                          "property uint class\nend_header\n0.5 0.25 0\n0.125 0.75 3\n");
    EXPECT_EQ(ply.set, two);
    EXPECT_THAT(ply.told, ElementsAre("a.ply: the classes of the points are left out"));
}

TEST(TextTable, LeavesOutRowNamesAsRWritesThem)
{
    const char* blanks = "\"x\" \"y\"\n\"1\" 0.5 0.25\n\"2\" 0.125 0.75\n"; // write.table
    EXPECT_EQ(table(blanks), two);
    EXPECT_THAT(told_of(blanks), ElementsAre("a.csv: the names of rows, in front, are left out"));
    EXPECT_EQ(table("x y\n1 0.5 0.25\n2 0.125 0.75\n"), two); // write.table, quote = FALSE
    EXPECT_THAT(input_error_of("a.csv", "x y\n0.1 0.5 0.25\n"), HasSubstr("a.csv:2: 3 fields: must be 2"));
    EXPECT_EQ(table("x y\noak 0.5 0.25\nelm 0.125 0.75\n"), two);
    EXPECT_THAT(input_error_of("a.csv", "x,y\n0.1,0.5,0.25\n"), // not a name
                HasSubstr("a.csv:2: 3 fields: must be 2, as the names of the columns say (x, y)"));
}

TEST(TextTable, HasDecimalCommasWhereSemicolonsOrTabsSeparate)
{
    for (const char* content : {"x;y\n0,5;0,25\n0,125;0,75\n", "0,5;0,25\n0,125;0,75\n", "0,5\t0,25\n0,125\t0,75\n",
                                "x\ty\n0,5\t0,25\n0,125\t0,75\n", "sep=;\nx;y\n0,5;0,25\n0,125;0,75\n",
                                "sep=;\n0,5;0,25\n0,125;0,75\n", "0.5;0.25\n0.125;0.75\n", "5e-1; 0.25 \n0.125;0.75\n"})
        EXPECT_EQ(table(content), two) << content;
    EXPECT_THAT(
        input_error_of("a.csv", "0,5;0,25\n0.5;0,5\n"),
        HasSubstr("a.csv:2: 0.5: numbers have decimal commas (line 1) and points (line 2): must be one of them"));
    EXPECT_THAT(input_error_of("a.csv", "x;y\n1.000,5;2\n"), HasSubstr("1.000,5: numbers have decimal commas"));
}

TEST(TextTable, IsReadWhateverItsLinesEndIn)
{
    for (const std::string end : {"\n", "\r\n", "\r"})
        for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
            EXPECT_EQ(table(mark + "x,y" + end + "0.5,0.25" + end + "0.125,0.75" + end), two);
            EXPECT_EQ(table(mark + "0.5 0.25" + end + end + "0.125 0.75"), two);
            EXPECT_EQ(table(mark + "# domain 0:8" + end + "4 2" + end + "1 6" + end), two) << "the domain counts";
        }
    EXPECT_THAT(input_error_of("a.csv", "x,y\r0.5,0.25\r0.125,no\r"), HasSubstr("a.csv:3: no: must be a number"));
    EXPECT_THAT(input_error_of("a.csv", std::string_view("\xFF\xFEx\0,\0y\0\n\0", 10)),
                HasSubstr("is in UTF-16, which some programs call \"Unicode\": save it as UTF-8"));
}

TEST(TextTable, DeclaresItsDomainBeforeItsPointsOnly)
{
    EXPECT_EQ(table("id,x,y\n# domain 0:8\n1,4,2\n2,1,6\n"), two);
    EXPECT_EQ(table("x;y\n0,5;0,25\n# domain 0:8\n0,125;0,75\n"), two);
}

TEST(TextTable, MustHaveXAndY)
{
    EXPECT_EQ(input_error_of("a.csv", "east,north\n7.1,50.2\n"),
              "a.csv:1: east, north: is no point, nor names of columns: among these must be x and y, of points in "
              "space z, or "
              "longitude and latitude");
    EXPECT_THAT(input_error_of("a.csv", "x,z\n0.1,0.2\n"), HasSubstr("among these must be x and y"));
    EXPECT_EQ(input_error_of("a.csv", "x,y,X\n0.1,0.2,0.3\n"), "a.csv:1: X: two columns have this name");
}

/// Degrees are no lengths, also where they could be numbers of the domain.
TEST(TextTable, RefusesColumnsOfDegreesWhereLengthsAreMeasured)
{
    for (const char* names : {"lon,lat", "Longitude,Latitude", "lng,lat"})
        for (const char* numbers : {"4.35,50.85\n4.36,50.84\n", "0.35,0.85\n0.36,0.84\n"})
            EXPECT_THAT(input_error_of("a.csv", std::string(names) + "\n" + numbers),
                        HasSubstr("are longitude and latitude in degrees, which are not lengths"))
                << names;
    EXPECT_THAT(input_error_of("a.csv", "lon,lat\n104300,50850\n4,5\n"), HasSubstr("must be a number in [0, 1)"))
        << "no place on the globe";
}

TEST(TextTable, NamesTheFieldThatIsWrong)
{
    EXPECT_EQ(input_error_of("a.csv", "id,x,y\n1,0.5,0.5\n2,,0.5\n"),
              "a.csv:3: nothing between separators: column x must be a number");
    EXPECT_THAT(input_error_of("a.csv", "id,x,y\n1,0.5,NA\n"), HasSubstr("a.csv:2: NA: must be a number in [0, 1)"));
    EXPECT_THAT(input_error_of("a.csv", "id,x,y\n1,0.5\n"),
                HasSubstr("a.csv:2: 2 fields: must be 3, as the names of the columns say (id, x, y)"));
    EXPECT_EQ(input_error_of("a.csv", "x;y\n0,1;0,2\n0,3\n"), // whose comma is right
              "a.csv:3: 1 field: must be 2, as the names of the columns say (x, y)");
    EXPECT_THAT(input_error_of("a.csv", "id,x,y\n\"1,0.5,0.5\n"),
                HasSubstr("a quote stays open, or text goes on behind a closing one"));
    EXPECT_THAT(input_error_of("a.csv", "x,y\n\"0,5\",\"0,25\"\n"),
                HasSubstr("the comma of \"0,5\" is no decimal point: must be 0.5"));
    EXPECT_EQ(input_error_of("a.csv", "0.5;;0.5\n"), "a.csv:1: nothing between separators: must be a number");
}

}
}
