// Kind "classes": what settings mean, what is measured and written, and what is refused.
#include "host/distribution/classes/class_points.hpp"

#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/distribution/classes/class_files.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
    EXPECT_DOUBLE_EQ(set.request.distances.at(1, 1), min_distance_for(0.62, 60, 2));
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

}
}
