// Coordinates in other ranges than [0, 1), and files that say how many points they have.
#include "tests/base/points/input_error_of.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;

PointSet plane(std::vector<double> coordinates) { return {2, std::move(coordinates)}; }

std::vector<PointSet> read(std::string_view content, std::optional<CoordinateRange> range = {})
{
    const TemporaryFolder folder;
    return read_points(folder.write("points.dat", content), range);
}

TEST(CoordinateRange, IsReadFromText)
{
    const auto range = [](std::string_view text) {
        const auto parsed = parse_range(text);
        return parsed ? std::pair{parsed->low, parsed->high} : std::pair{0.0, 0.0};
    };
    EXPECT_EQ(range("512"), std::pair(0.0, 512.0));
    EXPECT_EQ(range("-1:1"), std::pair(-1.0, 1.0));
    EXPECT_EQ(range("0.25:1e3"), std::pair(0.25, 1000.0));
    for (const auto* wrong :
         {"", ":", "1:", ":1", "1:1", "2:1", "0", "-1", "x", "0:x", "0:inf", "nan:1", "0:1:2", "0 1"})
        EXPECT_FALSE(parse_range(wrong)) << wrong;
}

TEST(PointDomain, IsReadFromText)
{
    const auto sides = [](std::string_view text) {
        const auto domain = parse_domain(text);
        return domain ? domain->sides() : std::vector<double>{-1};
    };
    EXPECT_THAT(sides("512"), ElementsAre()) << "one range for all axes";
    EXPECT_THAT(sides("0:2 -1:0"), ElementsAre(2, 1));
    EXPECT_THAT(sides(" 2  1 "), ElementsAre(2, 1));
    EXPECT_THAT(sides("10 10 5:35"), ElementsAre(10, 10, 30));
    EXPECT_THAT(sides("1 2 3 5"), ElementsAre(2, 3)) << "corners";
    EXPECT_THAT(sides("0 0 -1 1 2 2"), ElementsAre(1, 2, 3));
    for (const auto* wrong : {"", " ", "0:2 1:1", "0:2 x", "1 2 3 4 5", "0 0 0 1", "0:1 0:1 0:1 0:1", "0:2,0:1"})
        EXPECT_FALSE(parse_domain(wrong)) << wrong;
    EXPECT_TRUE(parse_domain("0:1 4:5")->is_square());
    EXPECT_FALSE(parse_domain("0:1 4:6")->is_square());
}

/// Reads in this domain, which becomes that of the file.
std::vector<PointSet> read_in_box(const std::filesystem::path& path, std::optional<PointDomain>& domain)
{
    PointDomain found;
    const auto sets = read_points_in_box(path, {.domain = domain}, found);
    domain = found;
    return sets;
}

std::vector<double> sides_read(const std::string& content, const char* name, std::vector<double> expected,
                               std::optional<PointDomain> domain = {})
{
    const TemporaryFolder folder;
    const auto sets = read_in_box(folder.write(name, content), domain);
    EXPECT_EQ(sets.at(0).coordinates, expected);
    return domain->sides();
}

TEST(PointDomain, MapsEachAxisByItsOwnRange)
{
    EXPECT_THAT(sides_read("0 0.5\n1.5 0.25\n", "p.txt", {0, 0.5, 0.75, 0.25}, parse_domain("0:2 0:1")),
                ElementsAre(2, 1));
    EXPECT_THAT(sides_read("# domain -1:1 0:4\n0 1\n", "p.txt", {0.5, 0.25}), ElementsAre(2, 4));
    EXPECT_THAT(sides_read("# domain 0:2 0:4 0:8 box of a cell\n1 1 1\n", "p.txt", {0.5, 0.25, 0.125}),
                ElementsAre(2, 4, 8));
    EXPECT_THAT(sides_read("ply\nformat ascii 1.0\ncomment domain 0:2 0:4\nelement vertex 2\nproperty float y\n"
                           "property float x\nend_header\n1 1\n3 1.5\n",
                           "p.ply", {0.5, 0.25, 0.75, 0.75}),
                ElementsAre(2, 4))
        << "columns of PLY may be in any order";
    // A constant third coordinate has no range.
    EXPECT_THAT(sides_read("1 0.5 7\n1.5 0.25 7\n", "p.txt", {0.5, 0.5, 0.75, 0.25}, parse_domain("0:2 0:1")),
                ElementsAre(2, 1));
}

TEST(PointDomain, IsThatOfBinaryFilesAsWell)
{
    const TemporaryFolder folder;
    const std::vector<double> coordinates{0, 3, 1.5, 1};
    for (const char* name : {"p.npy", "p.h5"}) {
        const auto path = folder.path() / name;
        write_points_in_pieces(path, 2, 2, "", [&](const PointSink& sink) { sink(coordinates); });
        auto domain = parse_domain("0:2 0:4");
        EXPECT_THAT(read_in_box(path, domain), ElementsAre(plane({0, 0.75, 0.75, 0.25}))) << name;
        domain = parse_domain("0:2 0:2.5"); // on its end, 3 would be its begin by rounding
        EXPECT_THROW(read_in_box(path, domain), InputError) << name;
    }
}

TEST(PointDomain, RefusesPointsOutsideAndOfOtherDimensions)
{
    const auto message = [](const std::string& content, const char* domain) {
        const TemporaryFolder folder;
        auto given = parse_domain(domain);
        try {
            read_in_box(folder.write("p.txt", content), given);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(message("1 0.5\n1.5 1.5\n", "0:2 0:1"), testing::HasSubstr("p.txt:2: 1.5: must be a number in [0, 1)"));
    EXPECT_THAT(message("1 0.5 0\n1.5 0.25 1\n", "0:2 0:1"),
                testing::HasSubstr("has 3D points where the domain has 2"));
    EXPECT_THAT(message("1 0.5 0\n1 0.25 1\n", "0:2 0:1"),
                testing::HasSubstr("has points in a plane of space where the domain has 2 ranges"));
    EXPECT_THAT(message("1 0.5\n", "2 1 3"), testing::HasSubstr("has 2D points where the domain has 3"));
    EXPECT_THROW(read("# domain 0:2 0:1\n1 0.5\n"), InputError) << "it is read where squares are needed";
    EXPECT_THAT(read("# domain 0:2 1:3\n1 2\n"), ElementsAre(plane({0.5, 0.5})));
}

TEST(PointFileDomain, CoordinatesAreMappedToTheUnitTorus)
{
    EXPECT_THAT(read("0 256\n384 511.5\n", CoordinateRange{0, 512}), ElementsAre(plane({0, 0.5, 0.75, 511.5 / 512})));
    EXPECT_THAT(read("-1 0\n0.5 -0.5\n", CoordinateRange{-1, 1}), ElementsAre(plane({0, 0.5, 0.75, 0.25})));
    // Just below the border, the quotient would round to 1.
    EXPECT_LT(read("0.29999999999999993 0.1\n", CoordinateRange{0.1, 0.3})[0].coordinates[0], 1);
}

TEST(PointFileDomain, IsThatOfBinaryFilesToo)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "points.npy";
    const std::vector<double> coordinates{0, 256, 384, 511.5};
    write_points_in_pieces(path, 2, 2, "", [&](const PointSink& sink) { sink(coordinates); });
    EXPECT_THAT(read_points(path, CoordinateRange{0, 512}), ElementsAre(plane({0, 0.5, 0.75, 511.5 / 512})));
}

TEST(PointFileDomain, IsTakenFromTheFile)
{
    EXPECT_THAT(read("# made by hand\n# domain 0:4\n1 2\n"), ElementsAre(plane({0.25, 0.5})));
    EXPECT_THAT(read("# domain 0:4\n1 2\n", CoordinateRange{0, 8}), ElementsAre(plane({0.125, 0.25})))
        << "what is asked for comes first";
    EXPECT_THAT(read("0.5 0.5\n# domain 0:4\n0.25 0.5\n"), ElementsAre(plane({0.5, 0.5, 0.25, 0.5})))
        << "only before the points";
    EXPECT_THAT(read("ply\nformat ascii 1.0\ncomment domain -1:1\nelement vertex 1\nproperty float x\n"
                     "property float y\nproperty float z\nend_header\n0 0.5 0\n"),
                ElementsAre(plane({0.5, 0.75})));
}

TEST(PointFileDomain, ErrorsNameIt)
{
    EXPECT_EQ(input_error_of("points.dat", "# domain 0:4\n1 5\n"), "points.dat:2: 5: must be a number in [0, 4)");
    EXPECT_EQ(input_error_of("points.dat", "# domain 0:4\n1 4\n"),
              "points.dat:2: 4: must be a number in [0, 4), without 4 itself (on the torus, 4 is 0)");
    EXPECT_EQ(input_error_of("points.dat", "# domain 4:0\n1 4\n"),
              "points.dat:1: 4:0: a domain is LOW:HIGH, two numbers, the first smaller");
    EXPECT_EQ(input_error_of("points.dat", "# domain -1.7e308:1.7e308\n1e308 0\n"),
              "points.dat:1: -1.7e308:1.7e308: a domain is LOW:HIGH, two numbers, the first smaller")
        << "its width is not a number";
}

TEST(PointFileCount, MayComeFirstAndMustBeRight)
{
    EXPECT_THAT(read("2\n0.1 0.2\n0.3 0.4\n"), ElementsAre(plane({0.1, 0.2, 0.3, 0.4})));
    EXPECT_EQ(input_error_of("points.dat", "3\n0.1 0.2\n0.3 0.4\n"),
              "points.dat:1: 3: is not the number of points, which is 2");
    EXPECT_EQ(input_error_of("points.dat", "2\n0.1 0.2\n0.3 0.4\n#\n0.1 0.2\n0.3 0.4\n"),
              "points.dat:1: 2: the number of points can only be in a file of one set");
    EXPECT_EQ(input_error_of("points.dat", "2\n"), "points.dat:1: 2: is not the number of points, which is 0");
}

}
}
