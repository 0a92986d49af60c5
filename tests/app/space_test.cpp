// Three dimensions, from the config to the report and back.
#include "analysis/spectra/spectrum_file.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <sstream>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Space : public testing::Test
{
protected:
    Outcome run(const std::vector<std::string>& arguments) const { return run_program(folder_.path(), arguments); }

    nlohmann::json results(const std::string& out) const
    {
        return nlohmann::json::parse(content_of(folder_.path() / out / "results.json"));
    }

    TemporaryFolder folder_;
};

TEST_F(Space, IsSampledAnalysedAndReported)
{
    folder_.write("space.toml", "[analysis]\npoints = 343\nrealizations = 2\ndimension = 3\n"
                                "[[method]]\nsampler = \"regular\"\n"
                                "[[method]]\nsampler = \"random\"\n"
                                "[[method]]\nsampler = \"jittered\"\n"
                                "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.7\n");
    const Outcome outcome = run({"run", "space.toml", "--out", "out"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto json = results("out");
    EXPECT_EQ(json["dimension"], 3);
    for (const auto& series : json["series"]) {
        EXPECT_EQ(series["points"], 343);
        EXPECT_EQ(series["spectrum"]["size"], 64); // 2 / (0.75 rmax) = 33.2
        const auto planes = read_spectrum_planes(folder_.path() / "out" / series["spectrum"]["file"]);
        ASSERT_EQ(planes.size(), shown_planes(64).size());
        EXPECT_FLOAT_EQ(static_cast<float>(planes[2].at(0, 0)), 343.0F) << "DC is N";
    }

    // The cubic lattice of 7^3 points: closed forms.
    const auto& regular = json["series"][0];
    EXPECT_NEAR(regular["min_distance"]["mean"].get<double>(), 1.0 / 7, 1e-9);
    EXPECT_NEAR(regular["relative_radius"]["mean"].get<double>(), std::pow(2.0, -1.0 / 6), 1e-8);
    EXPECT_NEAR(regular["covered_fraction"]["mean"].get<double>(), std::acos(-1.0) / 6, 1e-8);
    // The first shell of the lattice with power: 6 of the frequencies with 6.5 < |f| < 7.5 have power N.
    std::istringstream radial(content_of(folder_.path() / "out/regular/radial.csv"));
    std::string line;
    for (int i = 0; i < 8; ++i) std::getline(radial, line);
    double power = 0;
    double anisotropy = 0;
    double samples = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "7,%lf,%lf,%lf", &power, &anisotropy, &samples), 3) << line;
    EXPECT_NEAR(power * samples, 6 * 343, 1e-4);

    EXPECT_GE(json["series"][3]["relative_radius"]["min"].get<double>(), 0.7 - 1e-6);

    for (const char* picture : {"cube", "slices", "close-ups"})
        EXPECT_TRUE(fs::exists(folder_.path() / "out/random" / (std::string("spectrum-") + picture + ".png")))
            << picture;
    EXPECT_FALSE(fs::exists(folder_.path() / "out/random/spectrum-volume.exr")) << "only where it is asked for";

    // Coordinates in threes, and the right words.
    std::istringstream points(content_of(folder_.path() / "out/random/realization-001.dat"));
    std::getline(points, line); // comment
    std::getline(points, line);
    std::istringstream words(line);
    EXPECT_EQ(std::distance(std::istream_iterator<double>(words), {}), 3);
    EXPECT_THAT(content_of(folder_.path() / "out/index.html"), HasSubstr("on the unit torus in 3D"));
    const std::string page = content_of(folder_.path() / "out/random/index.html");
    EXPECT_THAT(page, HasSubstr("mean of the spectrum over spherical shells"));
    EXPECT_THAT(page, HasSubstr("What balls around the points cover"));
    EXPECT_THAT(page, HasSubstr("a slab of the cube, z below 0.16, seen along z"));
    EXPECT_THAT(page, HasSubstr("64 × 64 × 64 frequencies: the planes through frequency 0, from −32 to 31"));
}

TEST_F(Space, GivesTheSameBytesForAnyNumberOfThreadsAndEitherEngine)
{
    const std::string lines = "[analysis]\npoints = 100\nrealizations = 2\ndimension = 3\n"
                              "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.6\n";
    folder_.write("c.toml", lines);
    ASSERT_EQ(run({"run", "c.toml", "--out", "a"}).status, 0);
    ASSERT_EQ(run({"run", "c.toml", "--out", "b", "--threads", "1", "--set", "engine=reference"}).status, 0);
    const auto first = files_below(folder_.path() / "a");
    for (const auto& [name, content] : files_below(folder_.path() / "b")) {
        if (name.ends_with(".json") || name.ends_with(".html") || name.ends_with(".exr")) continue;
        if (name == "site/pictures.txt") continue; // of the spectra as they are stored, with the engine
        EXPECT_EQ(content == first.at(name), true) << name;
    }
}

TEST_F(Space, FilesAreAnalysedLikeSetsMadeHere)
{
    folder_.write("c.toml", "[analysis]\npoints = 64\nrealizations = 2\ndimension = 3\n"
                            "[[method]]\nsampler = \"jittered\"\n");
    ASSERT_EQ(run({"run", "c.toml", "--out", "made"}).status, 0);
    const Outcome outcome =
        run({"analyze", "made/jittered/realization-000.dat", "made/jittered/realization-001.dat", "--out", "read"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(results("read")["dimension"], 3);
    EXPECT_EQ(content_of(folder_.path() / "read/realization-000/radial.csv"),
              content_of(folder_.path() / "made/jittered/radial.csv"));

    fs::remove(folder_.path() / "read/index.html");
    ASSERT_EQ(run({"report", "read"}).status, 0);
    EXPECT_TRUE(fs::exists(folder_.path() / "read/index.html"));

    // A config reads these files as a series of an experiment, beside another method.
    folder_.write("f.toml", "[analysis]\ndimension = 3\n[[method]]\nsampler = \"file\"\n"
                            "path = \"made/jittered/*.dat\"\n");
    ASSERT_EQ(run({"run", "f.toml", "--out", "files"}).status, 0);
    EXPECT_EQ(results("files")["series"][0]["realizations"], 2);
    EXPECT_THAT(run({"run", "f.toml", "--set", "analysis.dimension=2"}).error,
                HasSubstr("holds 3D points; the experiment has dimension = 2"));
}

TEST_F(Space, AndPlaneCanShareAReport)
{
    folder_.write("c.toml", "[analysis]\npoints = 64\nrealizations = 1\n[[method]]\nsampler = \"random\"\n");
    ASSERT_EQ(run({"run", "c.toml", "--out", "plane"}).status, 0);
    ASSERT_EQ(run({"run", "c.toml", "--out", "space", "--set", "analysis.dimension=3"}).status, 0);
    const Outcome outcome = run({"report", "plane", "space", "--out", "both"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const std::string page = content_of(folder_.path() / "both/index.html");
    EXPECT_THAT(page, HasSubstr("2 series of 64 points on the unit torus in 2D and 3D"));
    EXPECT_THAT(content_of(folder_.path() / "both/compare.html"),
                HasSubstr("in cycles per mean spacing of the points"));
}

TEST_F(Space, StoresTheVolumeOnRequest)
{
    folder_.write("space.toml", "[analysis]\npoints = 27\nrealizations = 1\ndimension = 3\nvolume = true\n"
                                "spectrum_size = 12\n[[method]]\nsampler = \"random\"\n");
    const Outcome outcome = run({"run", "space.toml", "--out", "out"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto file = results("out")["series"][0]["spectrum"]["volume_file"].get<std::string>();
    EXPECT_GT(fs::file_size(folder_.path() / "out" / file), 12 * 12 * 12 * sizeof(float));
    EXPECT_THAT(content_of(folder_.path() / "out/random/index.html"), HasSubstr(">volume exr<"));
}

}
}
