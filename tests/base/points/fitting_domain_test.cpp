// The domain that messages name where numbers lie outside of theirs: it holds all of them, is round, and not much
// wider.
#include "base/points/fitting_domain.hpp"

#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

std::string fitting(double low, double high, std::uint64_t points, std::size_t dimension = 2)
{
    const CoordinateRange range = fitting_range({low, high}, points, dimension);
    return fmt::format("{}:{}", range.low, range.high);
}

TEST(FittingDomain, IsThatOfWhichTheNumbersCanBe)
{
    EXPECT_EQ(fitting(0.02, 511.7, 1000), "0:512");
    EXPECT_EQ(fitting(0.5, 511.5, 262'144), "0:512");
    EXPECT_EQ(fitting(0, 9, 100), "0:10");
    EXPECT_EQ(fitting(0.001, 91.999, 700'000, 3), "0:92");
    EXPECT_EQ(fitting(-0.998, 0.9991, 1000), "-1:1");
    EXPECT_EQ(fitting(0.01, 99.7, 500), "0:100");
    EXPECT_EQ(fitting(-180, 179.9, 1000), "-180:180");
}

TEST(FittingDomain, HoldsAllNumbers)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-9, 9), sign(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const double a = sign(random) * std::pow(10, exponent(random)),
                     b = a + std::max(std::abs(a) * 1e-6, std::pow(10, exponent(random)));
        const CoordinateRange range = fitting_range({a, b}, 1 + random() % 100'000, 2 + random() % 2);
        EXPECT_LE(range.low, a) << a << " " << b;
        EXPECT_GT(range.high, b) << a << " " << b;
        EXPECT_LE(range.high - range.low, 4 * (b - a) + 1e-15) << a << " " << b;
    }
}

std::string message(const std::string& name, std::string_view content, PointReading how = {},
                    const char* domain = "--domain {}:{}")
{
    how.options = {.domain = domain, .region = "--region 'rectangle {} {} {} {}'"};
    const TemporaryFolder folder;
    return message_of([&] { read_points(folder.write(name, content), how); });
}

TEST(FittingDomain, IsInTheMessage)
{
    EXPECT_THAT(
        message("a.txt", "0.5 500\n3 2\n511.7 100\n0.1 0.2\n"),
        EndsWith("a.txt:1: 500: must be a number in [0, 1); the numbers go from 0.1 to 511.7: --domain 0:512 would "
                 "fit"));
    EXPECT_THAT(message("a.csv", "id;x;y\n1;-0,9;0,99\n2;0,99;-0,95\n"),
                EndsWith("a.csv:2: -0.9: must be a number in [0, 1); the numbers go from -0.95 to 0.99: --domain -1:1 "
                         "would fit"));
}

TEST(FittingDomain, IsARectangleWhereAxesDiffer)
{
    EXPECT_THAT(message("a.csv", "x,y\n500000,5400000\n500999,5400400\n500500,5400100\n"), HasSubstr("would fit"));
    EXPECT_THAT(message("a.csv", "x,y\n500000,5400000\n500999,5400400\n500500,5400100\n"),
                HasSubstr(" (a periodic box) or --region 'rectangle 500000 5400000 501000 54004"));
    EXPECT_THAT(message("a.csv", "0 0\n99 79\n50 60\n"), HasSubstr("--domain 0:100 or --domain \"0:100 0:8"));
    EXPECT_THAT(message("a.csv", "0 0\n99 79\n50 60\n"),
                HasSubstr("\" (a periodic box) or --region 'rectangle 0 0 100 8"));
}

TEST(FittingDomain, IsABoxWhereAxesInSpaceDiffer)
{
    std::string box = "x,y,z\n", cube = box;
    for (int i = 0; i < 1000; ++i) {
        const double x = i % 10 / 10.0 + 0.0999, y = i / 10 % 10 / 10.0 + 0.0999, z = i / 100 / 10.0 + 0.0999;
        box += fmt::format("{},{},{}\n", 2 * x, y, z);
        cube += fmt::format("{},{},{}\n", 2 * x, 2 * y, 2 * z);
    }
    EXPECT_THAT(message("a.csv", box), EndsWith(": --domain \"0:2 0:1 0:1\" (a periodic box) would fit"));
    EXPECT_THAT(message("a.csv", box, {}, "domain=({}, {})"), EndsWith(": \"0:2 0:1 0:1\" (a periodic box) would fit"));
    EXPECT_THAT(message("a.csv", cube), HasSubstr(": --domain 0:2 would fit"));
}

/// The regions that are suggested are read without an error; none is suggested only of large extents.
TEST(FittingDomain, IsARegionOfTheGlobeThatIsAccepted)
{
    int suggested = 0, left_out = 0;
    for (const double longitude : {-180.0, -90.0, 0.0, 4.35, 150.0, 179.9, 200.0, 359.0})
        for (const double latitude : {-89.9, -60.0, -5.0, 0.0, 45.0, 88.0})
            for (const double width : {0.0, 0.3, 40.0, 80.0, 150.0, 300.0})
                for (const double height : {0.01, 1.0, 40.0, 100.0}) {
                    const double end = longitude + width, top = std::min(latitude + height, 89.99);
                    if (longitude < 0 && end > 180) continue; // mixes both ways to count
                    Extent extent;
                    for (const double x : {longitude, longitude + width / 3, longitude + 2 * width / 3, end})
                        extent.add(0, x >= 360 ? x - 360 : x);
                    for (const double y : {latitude, top}) extent.add(1, y);
                    const std::string words = degrees_words(extent, {.region = "{{{} {} {} {}}}", .crs = "crs"}, "");
                    const std::size_t begin = words.find('{'), last = words.find('}');
                    if (begin == words.npos) {
                        ++left_out;
                        EXPECT_THAT(words, HasSubstr("a rectangle around all of them is too large for a plane"));
                        EXPECT_GT(std::max(width, height), 60);
                        continue;
                    }
                    ++suggested;
                    const std::string rectangle = "rectangle " + words.substr(begin + 1, last - begin - 1);
                    EXPECT_NO_THROW(read_region(rectangle, {.crs = "EPSG:4326"})) << rectangle;
                    EXPECT_LE(extent.longitudes().high - extent.longitudes().low, width + 1e-9) << rectangle;
                }
    EXPECT_GT(suggested, 100);
    EXPECT_GT(left_out, 100);
}

TEST(FittingDomain, GoesTheShorterWayAroundTheGlobe)
{
    const auto words = [](const std::vector<double>& longitudes) {
        Extent extent;
        for (const double x : longitudes) extent.add(0, x);
        extent.add(1, 10.2);
        extent.add(1, 10.7);
        return degrees_words(extent, {.region = "R {:.4g} {:.4g} {:.5g} {:.4g}", .crs = "crs"}, "");
    };
    EXPECT_THAT(words({179.9, -179.8, 179.95}), HasSubstr("such as R 179.9 10.1"));
    EXPECT_THAT(words({179.9, 180.2}), HasSubstr("such as R 179.9 10.1"));
    EXPECT_THAT(words({0.1, 359.8}), HasSubstr("such as R -0.2"));
    EXPECT_THAT(words({-179.99, -179.5}), HasSubstr("such as R -180 10.1"));
}

/// Columns that are so named may go from 0 to 360.
TEST(FittingDomain, KnowsLongitudesUpTo360WhereTheyAreNamed)
{
    const auto refused = HasSubstr("are longitude and latitude in degrees");
    EXPECT_THAT(message("a.csv", "lon,lat\n359,50\n358,51\n"), refused);
    EXPECT_THAT(message("a.csv", "lon,lat\n0,50\n360,51\n"), refused);
    EXPECT_THAT(message("a.csv", "lon,lat\n361,50\n358,51\n"), Not(refused));
    EXPECT_THAT(message("a.csv", "lon,lat\n-90,50\n300,51\n"), Not(refused));
    EXPECT_THAT(message("a.csv", "x,y\n359,50\n358,51\n"), Not(refused));
}

TEST(FittingDomain, IsNotSaidOfNumbersThatNoDomainHolds)
{
    EXPECT_THAT(message("a.txt", "0.5 1\n"), EndsWith("without 1 itself (on the torus, 1 is 0)"));
    EXPECT_THAT(message("a.txt", "0.5 nan\n"), EndsWith("must be a number in [0, 1)"));
    EXPECT_THAT(message("a.txt", "0.5 7\n0.5 word\n"), HasSubstr("a.txt:2: word: must be a number"));
}

}
}
