// Small files of points by hand, one for each way in which programs write them. All files of a folder hold the same
// three points.
#include "base/points/point_file.hpp"
#include "tests/support/places.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

void expect_points(const std::string& folder, const PointSet& right)
{
    for (const auto& file : fs::directory_iterator(fs::path(source_folder()) / "tests/base/points/files" / folder)) {
        const auto sets = read_points(file.path(), PointReading{});
        ASSERT_EQ(sets.size(), 1u) << file.path();
        EXPECT_EQ(sets.front(), right) << file.path();
    }
}

TEST(PointCorpus, HoldsThreePointsOfThePlane) { expect_points("plane", {2, {0.5, 0.25, 0.125, 0.75, 0.625, 0.0625}}); }

TEST(PointCorpus, HoldsThreePointsOfSpace)
{
    expect_points("space", {3, {0.5, 0.25, 0.375, 0.125, 0.75, 0.875, 0.625, 0.0625, 0.9375}});
}

}
}
