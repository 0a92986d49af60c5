// Devices that have less than PoCL: little memory, small work-groups, no double precision, nothing to divide.
#include "base/files/whole_file.hpp"
#include "tests/luck/bad_luck.hpp"

#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// Each method with kernels, at a size that takes no time, by its table.
const std::map<std::string, std::string> methods{
    {"dart-throwing", "relative_radius = 0.6"},
    {"relaxation-dart-throwing", ""},
    {"voronoi-darts", "relative_radius = 0.6"},
    {"sector-darts", ""},
    {"lloyd", "iterations = 2\nrepulsion = true\nuntil_relative_radius = 0.5"},
    {"sample-elimination", ""},
    {"farthest-points", "iterations = 1"},
    {"gaussian-blue-noise", "iterations = 2"},
    {"equal-areas", "iterations = 1"},
    {"corner-tiles", "colors = 1\npoints_per_tile = 16\nlloyd_iterations = 2"},
    {"edge-tiles", "colors = 1\npoints_per_tile = 16\nlloyd_iterations = 2"},
    {"template-tiles", "tiles = 1\npoints_per_tile = 16\nlloyd_iterations = 2"},
    {"averaged-tiles", "points_per_tile = 16\niterations = 1"},
    {"penrose", ""},
    {"polyominoes", ""},
};

/// Methods that have kernels for space, too.
const std::vector<std::string> spatial{"dart-throwing", "relaxation-dart-throwing", "lloyd", "sample-elimination",
                                       "gaussian-blue-noise"};

std::string table_of(const std::string& method)
{
    return "[[method]]\nsampler = \"" + method + "\"\n" + methods.at(method) + "\n";
}

class SmallDevice : public BadLuck
{
protected:
    SmallDevice()
    {
        std::string plane, space;
        for (const auto& [method, parameters] : methods) plane += table_of(method);
        for (const std::string& method : spatial) space += table_of(method);
        write_config("plane.toml", plane);
        write_config("space.toml", space);
        folder_.write("space.toml", "dimension = 3\n" + content_of(path("space.toml")));
    }

    nlohmann::json devices(const std::string& environment) const
    {
        const Outcome outcome = run_program(folder_.path(), {"devices", "--json"}, environment);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return nlohmann::json::parse(outcome.out).at("devices").at(0);
    }
};

TEST_F(SmallDevice, GivesTheSameSets)
{
    const std::string small = small_device("SMALL_DEVICE_LOCAL=16384 SMALL_DEVICE_ALLOCATION=268435456 "
                                           "SMALL_DEVICE_GROUP=64 SMALL_DEVICE_UNITS=1 SMALL_DEVICE_DIVIDES=0");
    for (const std::string config : {"plane", "space"}) {
        SCOPED_TRACE(config);
        const Outcome whole = run(config, "", config + ".toml");
        ASSERT_EQ(whole.status, 0) << whole.error;
        ::setenv("POISSONLAB_CACHE", path("other cache").c_str(), 1); // for tile sets
        const Outcome outcome = run(config + "-small", small, config + ".toml");
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(lasting_files(path(config + "-small")), lasting_files(path(config)));
    }
}

/// What `devices` says of it holds: these methods run, and all others are told why they do not, before work begins.
TEST_F(SmallDevice, WithoutDoublePrecisionRunsWhatItSays)
{
    const std::string single = small_device("SMALL_DEVICE_DOUBLES=0");
    const auto runs = devices(single).at("methods").get<std::vector<std::string>>();
    EXPECT_THAT(runs, IsSupersetOf({"dart-throwing", "relaxation-dart-throwing", "penrose"}));
    for (const auto& [method, parameters] : methods) {
        SCOPED_TRACE(method);
        write_config("one.toml", table_of(method));
        const Outcome outcome = run("out-" + method, single, "one.toml");
        if (std::ranges::find(runs, method) != runs.end()) {
            EXPECT_EQ(outcome.status, 0) << outcome.error;
        } else {
            expect_one_line(outcome, 3, method + " needs double precision, which ");
            EXPECT_THAT(outcome.error, HasSubstr("the reference engine needs none"));
            EXPECT_FALSE(std::filesystem::exists(path("out-" + method) / "results.json"));
        }
    }
    EXPECT_THAT(devices("").at("methods").get<std::vector<std::string>>(), IsSupersetOf({"lloyd", "corner-tiles"}));
}

TEST_F(SmallDevice, WithoutDoublePrecisionKeepsWhatItMakes)
{
    write_config("both.toml", table_of("dart-throwing") + table_of("lloyd"));
    const Outcome outcome = run("out", small_device("SMALL_DEVICE_DOUBLES=0"), "both.toml");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_THAT(outcome.error, HasSubstr("lloyd needs double precision"));
    EXPECT_THAT(read_whole_file(path("out") / "results.json"), HasSubstr("lloyd needs double precision"));
    EXPECT_THAT(read_whole_file(path("out") / "results.json"), HasSubstr("dart-throwing"));
}

/// Many drivers lack the call that divides a device, and say that there is no way to divide it.
TEST_F(SmallDevice, ThatCannotBeDividedIsTakenWhole)
{
    const Outcome outcome =
        run_program(folder_.path(), {"run", "tiny.toml", "--out", "out", "--quiet", "--threads", "1"},
                    small_device("SMALL_DEVICE_DIVIDES=0"));
    EXPECT_EQ(outcome.status, 0) << outcome.error;
}

TEST_F(SmallDevice, WithoutComputeUnitsIsNotUsed)
{
    expect_one_line(run("out", small_device("SMALL_DEVICE_UNITS=0")), 3, "the driver reports no compute units");
    const nlohmann::json device = devices(small_device("SMALL_DEVICE_UNITS=0"));
    EXPECT_EQ(device.at("unusable"), "the driver reports no compute units");
    EXPECT_TRUE(device.at("methods").empty());
    expect_one_line(run("out", small_device("SMALL_DEVICE_GROUP=16")), 3, "at most 16 work-items");
}

}
}
