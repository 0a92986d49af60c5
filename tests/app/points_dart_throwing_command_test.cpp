// `poissonlab points dart-throwing`: the method's points in the method's order, from any blocks and any number of
// processes.
#include "base/geometry/relative_radius.hpp"
#include "base/points/point_file.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "tests/support/command_test.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class PointsDartThrowingCommand : public test::CommandTest
{
protected:
    PointsDartThrowingCommand() : CommandTest("points dart-throwing") {}

    /// The set that the method makes in memory.
    static PointSet expected(int dimension, std::size_t points, std::optional<double> relative_radius)
    {
        DartThrowingRequest request;
        request.dimension = dimension;
        request.min_distance =
            min_distance_for(relative_radius.value_or(saturation_relative_radius(dimension)), points, dimension);
        if (relative_radius) request.points = points;
        request.stream = stream_key(3, Purpose::dart_throwing, 0);
        return DartThrower(Device::open()).throw_darts(request);
    }

    void expect_points(const std::string& arguments, const std::string& file, const PointSet& expected_set) const
    {
        const Outcome outcome = run(arguments + " --seed 3 --quiet --out " + file);
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.out + outcome.error, "");
        EXPECT_EQ(read_points(folder_.path() / file).at(0), expected_set) << arguments;
    }

    /// Expects these files and no others: no parts are left behind.
    void expect_files(const std::vector<std::string>& names) const
    {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
            found.push_back(entry.path().filename().string());
        EXPECT_THAT(found, testing::UnorderedElementsAreArray(names));
    }
};

/// --memory 0.003 divides the torus into dozens of blocks.
TEST_F(PointsDartThrowingCommand, WritesTheMethodsPoints)
{
    const PointSet many = expected(2, 60'000, 0.75);
    expect_points("--points 60000 --relative-radius 0.75 --memory 0.003", "many.npy", many);
    expect_points("--points 60000 --relative-radius 0.75", "one.h5", many);
    // Far from saturation, few batches suffice.
    expect_points("--points 30000 --relative-radius 0.5 --memory 0.003", "few.npy", expected(2, 30'000, 0.5));
    expect_points("--points 8000 --dimension 3 --memory 0.05", "space.txt", expected(3, 8000, std::nullopt));
    expect_files({"many.npy", "one.h5", "few.npy", "space.txt"});
}

TEST_F(PointsDartThrowingCommand, SaysWhatItMade)
{
    const Outcome outcome = run("--min-distance 0.02 --out a.txt --json --quiet --engine reference");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("\"min_distance\": 0.02"));
    EXPECT_THAT(content_of(folder_.path() / "a.txt"), HasSubstr("between which no further one fits"));
}

/// The last line says how many points there are, on standard error; what goes to standard output is the points alone.
TEST_F(PointsDartThrowingCommand, SaysWhereThePointsAreAndHowMany)
{
    const Outcome saturated = run("--points 3000 --seed 3 --out a.txt");
    const std::size_t count = read_points(folder_.path() / "a.txt").at(0).size();
    ASSERT_NE(count, 3000U);
    EXPECT_THAT(saturated.error, testing::MatchesRegex(fmt::format(
                                     "poissonlab: note: a.txt: {} points at least 0\\.0[0-9]+ apart, between "
                                     "which no further one fits \\(3000 were asked for; without "
                                     "--relative-radius, chance decides how many fit\\), made in .*s\n",
                                     count)));
    const Outcome exact = run("--points 3000 --relative-radius 0.5 --seed 3 --out a.txt");
    EXPECT_THAT(exact.error,
                testing::MatchesRegex("poissonlab: note: a.txt: 3000 points at least 0\\.0[0-9]+ apart, made in "
                                      ".*s\n"));
    EXPECT_EQ(run("--points 3000 --seed 3 --out -").error, "");
}

/// Saturation comes by chance: it is found when all blocks are there.
TEST_F(PointsDartThrowingCommand, LeavesNothingBehindWhereThePointsDoNotFit)
{
    const Outcome outcome = run("--points 4000 --relative-radius 0.776 --seed 3 --out a.npy --quiet");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, HasSubstr("of 4000 points: no further one fits; a --relative-radius of about 0.7"));
    expect_files({});
}

}
}
