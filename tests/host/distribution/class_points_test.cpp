// Kind "classes": what settings mean, what is measured and written, and what is refused.
#include "host/distribution/classes/class_points.hpp"

#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/distribution/classes/class_files.hpp"
#include "host/distribution/classes/class_names.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "host/distribution/classes/class_set.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace poissonlab {
namespace {

const DistributionPlace class_place{.engine = Engine::reference, .device = {}};

ClassSettings three_classes()
{
    ClassSettings settings;
    settings.points = {20, 60, 200};
    return settings;
}

double number_of(const ClassSet& set, const std::string& key)
{
    for (const DistributionNumber& number : class_numbers(set))
        if (number.key == key) return number.value;
    return NAN;
}

TEST(ClassPoints, HaveDistancesOfTheRelativeRadius)
{
    const ClassSet set = throw_classes(three_classes(), 1, class_place);
    EXPECT_EQ(set.points.counts(), (std::vector<std::size_t>{20, 60, 200}));
    EXPECT_DOUBLE_EQ(set.kept().at(1, 1), min_distance_for(0.62, 60, 2));
    EXPECT_EQ(number_of(set, "points"), 280);
    // Measured distances are no less than those that are kept.
    for (int i = 0; i < 3; ++i) {
        EXPECT_GE(number_of(set, "relative_radius_" + std::to_string(i)), 0.62 - 1e-12);
        for (int j = 0; j <= i; ++j) {
            const std::string pair = std::to_string(j) + "_" + std::to_string(i);
            EXPECT_GE(number_of(set, "least_" + pair), number_of(set, "distance_" + pair) - 1e-15) << pair;
        }
    }
    EXPECT_GE(number_of(set, "relative_radius"), 0.61);
}

TEST(ClassPoints, TakeAMatrixAsItIs)
{
    ClassSettings settings;
    settings.matrix = {0.1, 0.2, 0.2, 0.05};
    const ClassSet set = throw_classes(settings, 1, class_place);
    EXPECT_GE(number_of(set, "least_0_1"), 0.2 - 1e-15);
    EXPECT_TRUE(set.points.is_full[0] && set.points.is_full[1]);
}

/// At 60 degrees north, 0.002 degrees of longitude and latitude are about 111.4 m by 222.8 m, because a degree of
/// longitude is half as long there.
TEST(ClassPoints, KeepMetresInRegionsOfDegrees)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "park.geojson";
    write_whole_file(file,
                     R"({"type": "Polygon", "coordinates": [[[10, 60], [10.002, 60], [10.002, 60.002], [10, 60.002],
                              [10, 60]]]})");
    ClassSettings settings;
    settings.place.region = file.string();
    settings.distances = {30, 9};
    const ClassSet set = throw_classes(settings, 1, class_place);
    EXPECT_NEAR(set.size(), 111.4 * 222.8, 0.01 * 111.4 * 222.8);
    EXPECT_TRUE(set.points.is_full[0] && set.points.is_full[1]);
    const ClassedPoints metres = set.in_units(), degrees = set.as_in_files();
    constexpr double metres_a_degree = 111'412; // of latitude at 60 degrees, WGS 84
    for (std::size_t i = 0; i < metres.classes.size(); ++i) {
        EXPECT_TRUE(degrees.points[i][0] >= 10 && degrees.points[i][0] <= 10.002);
        EXPECT_TRUE(degrees.points[i][1] >= 60 && degrees.points[i][1] <= 60.002);
        for (std::size_t j = 0; j < i; ++j) {
            const double kept = set.kept().at(metres.classes[i], metres.classes[j]);
            EXPECT_GE(std::hypot(metres.points[i][0] - metres.points[j][0], metres.points[i][1] - metres.points[j][1]),
                      kept);
            // Lengths of degrees are off by less than a hundredth.
            const double east = (degrees.points[i][0] - degrees.points[j][0]) * metres_a_degree / 2,
                         north = (degrees.points[i][1] - degrees.points[j][1]) * metres_a_degree;
            EXPECT_GE(std::hypot(east, north), 0.99 * kept);
        }
    }
}

TEST(ClassPoints, SayWhereThereIsNoRoom)
{
    ClassSettings settings = three_classes();
    settings.relative_radius = 0.9;
    EXPECT_THAT(
        message_of([&] { throw_classes(settings, 1, class_place); }),
        testing::MatchesRegex("class [0-2] is full with [0-9]+ of [0-9]+ points: no further one fits; a relative "
                              "radius of about 0\\.[0-9]+ can be reached"));
}

/// Classes of equal numbers: the power of all points is the mean of both and their cross power. Where one class has its
/// points between those of the other, that is negative, from sqrt(N) of one class to that of both; a ring of k
/// frequencies has an error of some 1 / sqrt(pi k), all of these of 0.03.
TEST(ClassPoints, AreEvenTogether)
{
    ClassSettings settings;
    settings.points = {500, 500};
    const ClassSet set = throw_classes(settings, 2, class_place);
    const CrossSpectra spectra = class_spectra(set.points);
    double low = 0, between = 0;
    for (std::size_t k = 0; k < 30; ++k) {
        EXPECT_NEAR(spectra.power[2][k], (spectra.power[0][k] + spectra.power[1][k]) / 2 + spectra.cross[0][k], 1e-4);
        (k < 10 ? low : between) += k < 10 ? spectra.power[2][k] / 10 : spectra.cross[0][k] / 20;
    }
    EXPECT_LT(low, 0.2);
    EXPECT_LT(between, -0.2);
}

/// Means and errors of three sets are those of their spectra one by one; the first set is that without averages.
TEST(ClassAverages, AreMeansOverSets)
{
    ClassSettings settings;
    settings.points = {40, 90};
    const ClassSet first = throw_classes(settings, 5, class_place);
    settings.sets = 3;
    const ClassSpectra spectra = averaged_spectra(settings, 5, class_place, first);
    std::vector<CrossSpectra> each;
    for (std::uint32_t k = 0; k < 3; ++k)
        each.push_back(class_spectra(throw_classes(settings, 5, class_place, k).points));
    EXPECT_EQ(each[0].power, class_spectra(first.points).power);
    EXPECT_NE(each[1].power, each[2].power);
    for (std::size_t bin = 0; bin < spectra.mean.bins(); ++bin) {
        const double a = each[0].cross[0][bin], b = each[1].cross[0][bin], c = each[2].cross[0][bin],
                     mean = (a + b + c) / 3;
        const double squares = a * a + b * b + c * c - 3 * mean * mean;
        EXPECT_NEAR(spectra.mean.cross[0][bin], mean, 1e-12);
        EXPECT_NEAR(spectra.error.cross[0][bin], std::sqrt(std::max(0.0, squares) / 6), 1e-6);
        EXPECT_NEAR(spectra.mean.power[2][bin],
                    (each[0].power[2][bin] + each[1].power[2][bin] + each[2].power[2][bin]) / 3, 1e-12);
    }
    const std::string text = spectra_csv(spectra);
    EXPECT_EQ(text.substr(0, text.find('\n')), "frequency,all,class_0,class_1,cross_0_1,all_error,class_0_error,"
                                               "class_1_error,cross_0_1_error");
}

/// A saturated set can leave a class without points: means are over the sets that have it, by its number.
TEST(ClassAverages, AreOverSetsThatHaveTheClass)
{
    const UsedSpectra first{{0, 2}, {{{1}, {2}, {3}}, {{4}}}};
    const UsedSpectra second{{0, 1, 2}, {{{3}, {6}, {8}, {5}}, {{7}, {10}, {9}}}};
    const UsedSpectra third{{1}, {{{8}, {10}}, {}}};
    const ClassSpectra means = mean_spectra({first, second, third});
    EXPECT_EQ(means.sets, 3);
    EXPECT_EQ(means.classes, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(means.mean.power, (std::vector<std::vector<double>>{{2}, {7}, {5}, {6}}));
    EXPECT_EQ(means.mean.cross, (std::vector<std::vector<double>>{{7}, {7}, {9}}));
    EXPECT_NEAR(means.error.cross[1][0], 3, 1e-12);
    EXPECT_TRUE(std::isnan(means.error.cross[0][0])) << "of one set alone";
    const ClassSpectra apart = mean_spectra({{{0}, {{{1}, {1}}, {}}}, {{1}, {{{1}, {1}}, {}}}});
    EXPECT_TRUE(std::isnan(apart.mean.cross[0][0])) << "in no set at once";
}

/// Corner tiles are built for a torus of them; distances are proven in units of 1 / 65,536 of a tile.
TEST(ClassTiles, AreBuiltForTheirTorus)
{
    ClassSettings settings;
    settings.points = {8, 16};
    settings.relative_radius = 0.5;
    settings.colors = 2;
    settings.torus = 3;
    const double unit = 1.0 / 65536 / settings.torus;
    const ClassSet set = throw_classes(settings, 1, class_place), other = throw_classes(settings, 1, class_place, 1);
    ASSERT_TRUE(set.tiles);
    EXPECT_EQ(set.points.counts(), (std::vector<std::size_t>{72, 144}));
    EXPECT_NE(set.points.points, other.points.points);
    for (const ClassSet* each : {&set, &other}) {
        const ClassDistances least = least_distances(*each);
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                EXPECT_GE(least.at(i, j), set.kept().at(i, j) - unit) << i << ", " << j;
    }
}

TEST(ClassFiles, HoldPointsWithClasses)
{
    const TemporaryFolder folder;
    const ClassedPoints points{{2, {0.5, 0.25, 0.1, 0.2}}, {1, 0}, {false, false}};
    for (const char* name : {"a.csv", "a.ply", "a.npy"}) write_class_file(folder.path() / name, points, "words");
    EXPECT_EQ(read_whole_file(folder.path() / "a.csv"),
              "x,y,class\n0.5,0.25,1\n0.10000000000000001,0.20000000000000001,0\n");
    EXPECT_EQ(read_whole_file(folder.path() / "a.ply"),
              "ply\nformat ascii 1.0\ncomment words\nelement vertex 2\nproperty double x\nproperty double y\n"
              "property double z\nproperty uint class\nend_header\n0.5 0.25 0 1\n"
              "0.10000000000000001 0.20000000000000001 0 0\n");
    const std::string records = read_whole_file(folder.path() / "a.npy");
    EXPECT_THAT(records, testing::HasSubstr("f8'), ('class', '"));
    ASSERT_EQ(records.size() % 64, 40U); // two records of 20 bytes
    double y = 0;
    std::uint32_t own = 0;
    std::memcpy(&y, &records[records.size() - 12], 8);
    std::memcpy(&own, &records[records.size() - 24], 4);
    EXPECT_EQ(y, 0.2);
    EXPECT_EQ(own, 1U);
}

/// A name that reads as not-a-number is below and above no number, and must not come between numbers.
TEST(ClassSet, NumbersClassesInOneOrderWhateverComesFirst)
{
    std::vector<std::string> names{"-2", "0.5", "1", "1.0", "10", "1e400", "nan", "oak"};
    const std::vector<std::string> sorted{"-2", "0.5", "1", "1.0", "10", "1e400", "nan", "oak"};
    std::ranges::sort(names);
    do {
        const auto [classes, found] = number_classes(names, "a.csv");
        ASSERT_EQ(found, sorted);
        for (std::size_t i = 0; i < names.size(); ++i) ASSERT_EQ(sorted[classes[i]], names[i]);
    } while (std::ranges::next_permutation(names).found);
}

}
}
