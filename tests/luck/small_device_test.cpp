// Devices that have less than PoCL: little memory, small work-groups, no double precision, nothing to divide.
#include "base/files/whole_file.hpp"
#include "tests/luck/bad_luck.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

/// Methods with kernels, at sizes that take no time, and their parameters.
using Methods = std::map<std::string, std::string>;

const Methods in_plane{
    {"dart-throwing", "relative_radius = 0.6"},
    {"relaxation-dart-throwing", ""},
    {"voronoi-darts", "relative_radius = 0.6"},
    {"sector-darts", ""},
    {"lloyd", "iterations = 2\nrepulsion = true\nuntil_relative_radius = 0.5"},
    {"sample-elimination", ""},
    {"farthest-point", "iterations = 1"},
    {"gaussian-blue-noise", "iterations = 2"},
    {"equal-areas", "iterations = 1"},
};
const Methods in_space{{"dart-throwing", "relative_radius = 0.6"}, {"lloyd", "iterations = 1"}};
const Methods by_tiles{
    {"corner-tiles", "colors = 1\npoints_per_tile = 16\nlloyd_iterations = 2"},
    {"averaged-tiles", "points_per_tile = 16\niterations = 1"},
    {"penrose", ""},
};

class SmallDevice : public BadLuck
{
protected:
    /// Runs all methods in one config.
    Outcome run_all(const std::string& out, const std::string& environment, const Methods& methods,
                    int dimension = 2) const
    {
        std::string text =
            "[analysis]\npoints = 256\nrealizations = 1\ndimension = " + std::to_string(dimension) + "\n";
        for (const auto& [method, parameters] : methods)
            text += "[[method]]\nsampler = \"" + method + "\"\n" + parameters + "\n";
        folder_.write("all.toml", text);
        return run(out, environment, "all.toml");
    }

    /// Expects that a device with few resources, or with the given ones, makes what PoCL makes.
    void expect_the_same(const Methods& methods, int dimension = 2,
                         const std::string& resources =
                             "SMALL_DEVICE_LOCAL=16384 SMALL_DEVICE_ALLOCATION=268435456 SMALL_DEVICE_GROUP=64 "
                             "SMALL_DEVICE_UNITS=1 SMALL_DEVICE_DIVIDES=0") const
    {
        const Outcome whole = run_all("whole", "", methods, dimension);
        ASSERT_EQ(whole.status, 0) << whole.error;
        ::setenv("POISSONLAB_CACHE", path("other cache").c_str(), 1); // for tile sets
        const Outcome outcome = run_all("small", small_device(resources), methods, dimension);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(lasting_files(path("small")), lasting_files(path("whole")));
    }

    nlohmann::json device(const std::string& environment) const
    {
        const Outcome outcome = run_program(folder_.path(), {"devices", "--json"}, environment);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return nlohmann::json::parse(outcome.out).at("devices").at(0);
    }
};

TEST_F(SmallDevice, GivesTheSameSetsInThePlane) { expect_the_same(in_plane); }
TEST_F(SmallDevice, GivesTheSameSetsInSpace) { expect_the_same(in_space, 3); }
TEST_F(SmallDevice, GivesTheSameTiles) { expect_the_same(by_tiles); }

TEST_F(SmallDevice, WithoutDoublePrecisionRelaxesTheSameSets)
{
    expect_the_same({{"lloyd", in_plane.at("lloyd")}}, 2, "SMALL_DEVICE_DOUBLES=0");
}

/// The list of `devices` holds: these methods run, and all others say why they do not.
TEST_F(SmallDevice, WithoutDoublePrecisionMakesWhatItCan)
{
    const std::string single = small_device("SMALL_DEVICE_DOUBLES=0");
    const auto listed = device(single).at("methods").get<std::set<std::string>>();
    EXPECT_THAT(listed, IsSupersetOf({"dart-throwing", "relaxation-dart-throwing", "lloyd"}));
    EXPECT_EQ(device(single).at("methods_only_in_plane"), nlohmann::json{"lloyd"});
    EXPECT_THAT(device("").at("methods").get<std::set<std::string>>(), IsSupersetOf({"dart-throwing", "lloyd"}));

    const Outcome outcome = run_all("out", single, in_plane);
    EXPECT_EQ(outcome.status, 3);
    const auto results = nlohmann::json::parse(read_whole_file(path("out") / "results.json"));
    std::set<std::string> made;
    for (const auto& series : results.at("series")) made.insert(series.at("sampler").get<std::string>());
    std::string why;
    for (const auto& missing : results.at("missing")) why += missing.get<std::string>() + "\n";
    for (const auto& [method, parameters] : in_plane) {
        EXPECT_EQ(made.contains(method), listed.contains(method)) << method;
        if (!listed.contains(method)) {
            EXPECT_THAT(why, HasSubstr(": " + method + " needs double precision, which "));
        }
    }
}

TEST_F(SmallDevice, WithoutDoublePrecisionIsToldInOneLine)
{
    const Outcome outcome = run_all("out", small_device("SMALL_DEVICE_DOUBLES=0"), {{"lloyd", "iterations = 1"}}, 3);
    expect_one_line(outcome, 3, "lloyd in 3D needs double precision, which ");
    EXPECT_THAT(outcome.error, HasSubstr("the reference engine needs none"));
    EXPECT_FALSE(std::filesystem::exists(path("out") / "results.json"));
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
    const std::string none = small_device("SMALL_DEVICE_UNITS=0");
    expect_one_line(run("out", none), 3, "the driver reports no compute units");
    EXPECT_EQ(device(none).at("unusable"), "the driver reports no compute units");
    EXPECT_TRUE(device(none).at("methods").empty());
    expect_one_line(run("out", small_device("SMALL_DEVICE_GROUP=16")), 3, "at most 16 work-items");
}

}
}
