// `poissonlab points lloyd` and `points gaussian-blue-noise`: the methods' points in the methods' order, from any
// slabs, in memory that does not grow with what the device would take for the whole set.
#include "base/points/point_file.hpp"
#include "host/sampling/baselines.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/settings/sampler_registry.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <sstream>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// The first realization that the method makes as a whole.
PointSet made_as_a_whole(const SamplerSpec& spec, const Parameters& parameters, std::size_t points, int dimension,
                         Engine engine = Engine::opencl)
{
    Device device = Device::open();
    return spec.create(parameters, {points, dimension, 3}, engine, [&]() -> Device& { return device; })->sample(0);
}

Parameters with_values(const SamplerSpec& spec, const std::map<std::string, ParameterValue>& values)
{
    Parameters parameters(spec.parameters);
    for (const auto& [key, value] : values) parameters.set(key, value);
    return parameters;
}

ParameterValue start_of(const std::string& sampler, const std::map<std::string, ParameterValue>& values = {})
{
    const SamplerSpec* spec = find_sampler(sampler);
    return std::make_shared<const SamplerChoice>(SamplerChoice{spec, with_values(*spec, values)});
}

class PointsRelaxation : public test::CommandTest
{
protected:
    explicit PointsRelaxation(const std::string& command) : CommandTest(command) {}

    void expect_points(const std::string& arguments, const std::string& file, const PointSet& expected) const
    {
        const Outcome outcome =
            run_program(folder_.path(), test::words_of(command_words(arguments) + " --out " + file));
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.out + outcome.error, "");
        EXPECT_TRUE(read_points(folder_.path() / file).at(0) == expected) << arguments;
    }

    virtual std::string command_words(const std::string& arguments) const = 0;
};

class PointsLloydCommand : public PointsRelaxation
{
protected:
    PointsLloydCommand() : PointsRelaxation("points lloyd") {}
    std::string command_words(const std::string& arguments) const override
    {
        return "points lloyd --seed 3 --quiet " + arguments;
    }
    const SamplerSpec lloyd_ = lloyd_sampler();
};

TEST_F(PointsLloydCommand, SaysWhereThePointsAreAndHowMany)
{
    const Outcome outcome =
        run_program(folder_.path(), test::words_of("points lloyd --points 500 --iterations 2 --out a.txt"));
    EXPECT_THAT(outcome.error,
                testing::MatchesRegex("poissonlab: note: a.txt: 500 points of relative radius 0\\.[0-9]+, "
                                      "made in .*s\n"));
}

/// --memory 0.001 divides the torus into several slabs.
TEST_F(PointsLloydCommand, WritesTheMethodsPoints)
{
    const PointSet plane = made_as_a_whole(lloyd_, with_values(lloyd_, {{"iterations", std::int64_t{4}}}), 20'000, 2);
    expect_points("--points 20000 --iterations 4", "one.npy", plane);
    expect_points("--points 20000 --iterations 4 --memory 0.001", "many.h5", plane);
    expect_points("--points 3000 --iterations 2 --dimension 3 --memory 0.001", "space.txt",
                  made_as_a_whole(lloyd_, with_values(lloyd_, {{"iterations", std::int64_t{2}}}), 3000, 3));
}

TEST_F(PointsLloydCommand, EndsAndKeepsAsTheMethodDoes)
{
    const auto until = with_values(lloyd_, {{"iterations", std::int64_t{40}}, {"until_relative_radius", 0.3}});
    expect_points("--points 500 --iterations 40 --until-relative-radius 0.3", "until.txt",
                  made_as_a_whole(lloyd_, until, 500, 2));
    const auto best = with_values(
        lloyd_, {{"iterations", std::int64_t{30}}, {"keep", std::string("best")}, {"start", start_of("jittered")}});
    expect_points("--points 900 --iterations 30 --keep best --start jittered --memory 0.001", "best.txt",
                  made_as_a_whole(lloyd_, best, 900, 2));
}

/// Files have as many points as they have; those of a corner of the torus need the whole of it around.
TEST_F(PointsLloydCommand, StartsFromFiles)
{
    PointSet corner = made_as_a_whole(random_sampler(), {}, 2000, 2);
    for (double& c : corner.coordinates) c *= 0.05;
    write_points(folder_.path() / "corner.npy", corner);
    const LloydResult expected = LloydRelaxation(Device::open()).relax(corner, Domain{}, {.iterations = 3});
    folder_.write("run.sh", quoted(program_file()) +
                                " points lloyd --seed 3 --quiet --iterations 3 --memory 0.001 --start "
                                "'{ sampler = \"file\", path = \"corner.npy\" }' --out moved.npy");
    const Outcome outcome = run_in_shell(folder_.path(), "sh run.sh");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_TRUE(read_points(folder_.path() / "moved.npy").at(0) == expected.points);
}

/// A file is planned as random points are, by its number.
TEST_F(PointsLloydCommand, PlansStartsFromFiles)
{
    write_points(folder_.path() / "start.npy", made_as_a_whole(random_sampler(), {}, 20'000, 2));
    const auto slabs = [&](const std::string& start) {
        folder_.write("run.sh", quoted(program_file()) + " points lloyd --seed 3 --quiet --json --iterations 1 " +
                                    "--memory 0.001 " + start + " --out moved.npy");
        const Outcome outcome = run_in_shell(folder_.path(), "sh run.sh");
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return nlohmann::json::parse(outcome.out).at("slabs").get<int>();
    };
    const int of_random_points = slabs("--points 20000");
    EXPECT_GT(of_random_points, 1);
    EXPECT_EQ(slabs("--start '{ sampler = \"file\", path = \"start.npy\" }'"), of_random_points);
}

TEST_F(PointsLloydCommand, HasAPlainTwin)
{
    expect_points(
        "--points 300 --iterations 3 --engine reference", "plain.txt",
        made_as_a_whole(lloyd_, with_values(lloyd_, {{"iterations", std::int64_t{3}}}), 300, 2, Engine::reference));
    const std::string json = printed("--points 300 --iterations 3 --seed 3 --json --quiet --out a.txt");
    EXPECT_THAT(json, HasSubstr("\"iteration\": 3,"));
    EXPECT_THAT(
        content_of(folder_.path() / "a.txt"),
        HasSubstr("points lloyd --points 300 --iterations 3 --seed 3 --out FILE # iterate 3, relative radius 0."));
}

/// The system counts what the process has had; the device's memory is the process's.
TEST_F(PointsLloydCommand, TakesTheMemoryThatItPlans)
{
    const auto megabytes = [&](const std::string& points) {
        folder_.write("run.py",
                      "import json, resource, subprocess\n"
                      "said = subprocess.run(['" +
                          program_file() + "', 'points', 'lloyd', '--points', '" + points +
                          "', '--iterations', '1', '--quiet', '--json', '--memory', '0.02', '--out', 'a.npy'], "
                          "stdout=subprocess.PIPE, check=True).stdout\n"
                          "print(json.loads(said)['planned_bytes'] / 1e6, "
                          "resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024 / 1e6)\n");
        const Outcome outcome = run_in_shell(folder_.path(), "/usr/bin/python3 run.py");
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        std::istringstream numbers(outcome.out);
        std::array<double, 2> planned_and_taken{};
        numbers >> planned_and_taken[0] >> planned_and_taken[1];
        return planned_and_taken;
    };
    const auto few = megabytes("200000"), many = megabytes("2000000");
    EXPECT_LE(many[1], many[0]);
    // 40 bytes a point, where one slab would take some 150.
    EXPECT_NEAR(many[1] - few[1], 72, 25);
}

class PointsGaussianCommand : public PointsRelaxation
{
protected:
    PointsGaussianCommand() : PointsRelaxation("points gaussian-blue-noise") {}
    std::string command_words(const std::string& arguments) const override
    {
        return "points gaussian-blue-noise --seed 3 --quiet " + arguments;
    }
    const SamplerSpec gaussian_ = gaussian_blue_noise_sampler();
};

TEST_F(PointsGaussianCommand, WritesTheMethodsPoints)
{
    const std::map<std::string, ParameterValue> five{{"iterations", std::int64_t{5}}, {"sigma", 0.8}};
    expect_points("--points 20000 --iterations 5 --sigma 0.8 --memory 0.001", "plane.npy",
                  made_as_a_whole(gaussian_, with_values(gaussian_, five), 20'000, 2));
    expect_points("--points 4000 --iterations 5 --sigma 0.8 --dimension 3", "space.h5",
                  made_as_a_whole(gaussian_, with_values(gaussian_, five), 4000, 3));
}

TEST_F(PointsGaussianCommand, StartsFromFiles)
{
    const PointSet start = made_as_a_whole(random_sampler(), {}, 2000, 2);
    write_points(folder_.path() / "start.npy", start);
    folder_.write("run.sh", quoted(program_file()) +
                                " points gaussian-blue-noise --seed 3 --quiet --iterations 2 --sigma 0.8 --start "
                                "'{ sampler = \"file\", path = \"start.npy\" }' --out moved.npy");
    const Outcome outcome = run_in_shell(folder_.path(), "sh run.sh");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const std::map<std::string, ParameterValue> two{{"iterations", std::int64_t{2}}, {"sigma", 0.8}};
    EXPECT_TRUE(read_points(folder_.path() / "moved.npy").at(0) ==
                made_as_a_whole(gaussian_, with_values(gaussian_, two), 2000, 2));
}

/// 4,001 is no multiple of four: the last corner of each level lacks some parts.
TEST_F(PointsGaussianCommand, SplitsThePointsOfLevels)
{
    const std::map<std::string, ParameterValue> levels{{"iterations", std::int64_t{3}}, {"levels", std::int64_t{2}}};
    expect_points("--points 4001 --iterations 3 --levels 2 --memory 0.001", "levels.txt",
                  made_as_a_whole(gaussian_, with_values(gaussian_, levels), 4001, 2));
    expect_points("--points 4001 --iterations 3 --levels 2 --engine reference", "plain.txt",
                  made_as_a_whole(gaussian_, with_values(gaussian_, levels), 4001, 2));
}

}
}
