#include "experiment/series/imported_points.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(ImportedPoints, FilesAndTheirRealizationsInOrder)
{
    const TemporaryFolder folder;
    const auto a = folder.write("a.dat", "0.1 0.2\n0.3 0.4\n#\n0.5 0.6\n0.7 0.8\n");
    const auto b = folder.write("b.dat", "0.25 0.5\n0.75 0.5\n");
    const Experiment experiment = import_points({b, a}, "");
    ASSERT_EQ(experiment.series.size(), 1U);
    const SeriesTask& series = experiment.series[0];
    EXPECT_EQ(series.label, "b");
    EXPECT_EQ(series.name, "b");
    EXPECT_EQ(series.realizations, 3U);
    EXPECT_FALSE(experiment.seed);
    const auto sampler = series.create();
    EXPECT_EQ(sampler->sample(0).coordinates[0], 0.25);
    EXPECT_EQ(sampler->sample(1).coordinates[0], 0.1);
    EXPECT_EQ(sampler->sample(2).coordinates[0], 0.5);
}

TEST(ImportedPoints, LabelsAreSafeAsFolders)
{
    const TemporaryFolder folder;
    const auto a = folder.write("a.dat", "0.1 0.2\n");
    EXPECT_EQ(import_points({a}, "My method, ρ = 0.7").series[0].name, "My-method-0.7");
    EXPECT_EQ(import_points({a}, "index.html").series[0].name, "points-index.html");
    EXPECT_EQ(import_points({a}, "..").series[0].name, "series");
}

TEST(ImportedPoints, UnequalSizesNameBothPlaces)
{
    const TemporaryFolder folder;
    const std::string a = folder.write("a.dat", "0.1 0.2\n0.3 0.4\n");
    const std::string b = folder.write("b.dat", "0.1 0.2\n0.3 0.4\n#\n0.5 0.6\n");
    EXPECT_EQ(message_of([&] {
                  import_points({a, b}, "");
              }),
              b + ": realization 2: has 1 points where " + a +
                  " has 2: realizations must have the same number of points; analyze sets of several methods "
                  "one at a time, or as [[method]] tables of a config");
}

TEST(ImportedPoints, AllSetsHaveTheDimensionOfTheFirst)
{
    const TemporaryFolder folder;
    const std::string a = folder.write("a.dat", "0.1 0.2 0.3\n");
    const std::string b = folder.write("b.dat", "0.1 0.2\n");
    EXPECT_EQ(import_points({a}, "").dimension, 3);
    EXPECT_EQ(message_of([&] { import_points({a, b}, ""); }), b + ": has 2D points where " + a + " has 3D ones");
}

TEST(ImportedPoints, FoldersAreNoFiles)
{
    const TemporaryFolder folder;
    EXPECT_EQ(message_of([&] { import_points({folder.path()}, ""); }),
              folder.path().string() + ": is a folder; files of points are needed");
}

}
}
