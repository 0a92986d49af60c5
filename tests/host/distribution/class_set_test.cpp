// Kind "class-set": which measurements are left out.
#include "host/distribution/classes/class_set.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

/// Returns points of two classes in a square with sides of `side` in the middle of the torus.
ClassSetPoints cluster(std::size_t count, double side)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> coordinate(0.5 - side / 2, 0.5 + side / 2);
    ClassSetPoints set;
    set.names = {"a", "b"};
    for (std::size_t i = 0; i < count; ++i) {
        set.points.coordinates.insert(set.points.coordinates.end(), {coordinate(random), coordinate(random)});
        set.classes.push_back(static_cast<std::uint8_t>(i % 2));
    }
    return set;
}

/// All points of the cluster are within reach of each other: 6e5 pairs, which 999 labellings compare 6e8 times.
TEST(ClassSet, LeavesLabellingsOutWherePointsLieInClusters)
{
    constexpr std::size_t points = 1100;
    ClassSetSettings settings;
    settings.labellings = 999;
    const ClassSetMeasures clustered = measure_class_set(cluster(points, 0.001), settings, nullptr);
    EXPECT_EQ(clustered.all.pairs, points * (points - 1) / 2);
    EXPECT_EQ(clustered.labellings, 0u);
    EXPECT_TRUE(clustered.marks.low.empty());
    EXPECT_EQ(clustered.marks.values.size(), clustered.all.steps.count);
    EXPECT_EQ(measure_class_set(cluster(points, 1), settings, nullptr).labellings, 999u);
}

}
}
