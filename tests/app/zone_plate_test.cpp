// The sampling test in an experiment: what is stored, and that it is always the same.
#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "base/images/square_image.hpp"
#include "base/points/point_file.hpp"
#include "experiment/measuring/zone_plate_analysis.hpp"
#include "results/curve_tables.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

TEST(ZonePlateAnalysis, KeepsTheFirstPictureAndAllErrors)
{
    std::mt19937_64 random(1);
    const auto first = test::random_points(40 * 40, 2, random);
    const auto second = test::random_points(41 * 41, 2, random); // as saturated sets differ
    ZonePlateAnalysis analysis;
    analysis.add(first);
    analysis.add(second);
    EXPECT_EQ(analysis.first_image().pixels, zone_plate_image(first).pixels);
    const ZonePlateResult result = analysis.result();
    EXPECT_EQ(result.size, 40);
    EXPECT_THAT(result.rms_error.each, testing::ElementsAre(ZonePlateError().add(zone_plate_image(first)).whole,
                                                            ZonePlateError().add(zone_plate_image(second)).whole));
    EXPECT_THAT(result.resolved_rms_error->each,
                testing::ElementsAre(ZonePlateError().add(zone_plate_image(first)).resolved,
                                     ZonePlateError().add(zone_plate_image(second)).resolved));
    EXPECT_GT(analysis.seconds(), 0);
}

TEST(ZonePlateAnalysis, CurveIsACsvOfExactNumbers)
{
    ZonePlateAnalysis analysis;
    const PointSet point{2, {0.5, 0.5}};
    analysis.add(point); // one pixel, 24 sqrt 2 = 33.94 from the origin
    EXPECT_EQ(zone_plate_csv(analysis.curve()),
              fmt::format("distance,frequency,rms_error,pixels\n33.75,{},{},1\n", plate_frequency(33.75, 1),
                          analysis.result().rms_error.mean));
}

class ZonePlateRun : public testing::Test
{
protected:
    Outcome run(const std::vector<std::string>& arguments = {"run", "plate.toml"}) const
    {
        return run_program(folder_.path(), arguments);
    }

    TemporaryFolder folder_;
    fs::path config_ = folder_.write("plate.toml", "[analysis]\npoints = 4096\nrealizations = 3\n"
                                                   "zone_plate = true\n"
                                                   "[[method]]\nsampler = \"random\"\n"
                                                   "[[method]]\nsampler = \"jittered\"\n"
                                                   "[[method]]\nsampler = \"regular\"\n");
    fs::path out_ = folder_.path() / "out/plate";
};

TEST_F(ZonePlateRun, WritesEverythingThatTheDocumentationLists)
{
    const Outcome outcome = run();
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    ASSERT_EQ(run({"report", "out/plate", "--print"}).status, 0);
    const auto json = nlohmann::json::parse(content_of(out_ / "results.json"));
    for (const auto& series : json["series"]) {
        const auto folder = out_ / series["name"].get<std::string>();
        for (const char* file :
             {"zone-plate.exr", "zone-plate.csv", "zone-plate.png", "zone-plate-error.svg", "zone-plate-error.png"})
            EXPECT_TRUE(fs::exists(folder / file)) << file;
        const auto& plate = series["zone_plate"];
        EXPECT_EQ(plate["size"], 64);
        EXPECT_EQ(plate["rms_error"]["each"].size(), series["realizations"].get<std::size_t>());

        EXPECT_GT(plate["rms_error"]["min"], 0);
        EXPECT_GT(plate["resolved_rms_error"]["min"], 0);
        EXPECT_LT(plate["resolved_rms_error"]["max"], plate["rms_error"]["max"]);

        const auto image = read_square_image(out_ / plate["file"].get<std::string>());
        const auto points = read_points(folder / "realization-000.dat").front();
        const auto expected = zone_plate_image(points);
        ASSERT_EQ(image.pixels.size(), expected.pixels.size());
        for (std::size_t p = 0; p < image.pixels.size(); ++p)
            ASSERT_EQ(image.pixels[p], static_cast<float>(expected.pixels[p]));
    }
    for (const char* file : {"zone-plate-error-all.svg", "zone-plate-error-all.png", "zone-plate-reference.png"})
        EXPECT_TRUE(fs::exists(out_ / file)) << file;
}

TEST_F(ZonePlateRun, IsTheSameOnAnyNumberOfThreads)
{
    ASSERT_EQ(run({"run", "plate.toml", "--threads", "1", "--out", "one"}).status, 0);
    ASSERT_EQ(run({"run", "plate.toml", "--threads", "4", "--out", "four"}).status, 0);
    const auto one = files_below(folder_.path() / "one");
    const auto four = files_below(folder_.path() / "four");
    int compared = 0;
    for (const auto& [name, content] : one)
        if (name.find("zone-plate") != std::string::npos) {
            EXPECT_EQ(content, four.at(name)) << name;
            ++compared;
        }
    EXPECT_EQ(compared, 3 * 5 + 2);
}

TEST_F(ZonePlateRun, IsLeftOutWhereItIsNotAskedFor)
{
    ASSERT_EQ(run({"run", "plate.toml", "--set", "analysis.zone_plate=false"}).status, 0);
    for (const auto& [name, content] : files_below(out_)) {
        EXPECT_EQ(name.find("zone-plate"), std::string::npos) << name;
        if (name.ends_with(".html")) {
            EXPECT_EQ(content.find("Zone plate"), std::string::npos);
        }
    }
}

TEST_F(ZonePlateRun, OfVolumesIsRefused)
{
    const Outcome outcome = run({"run", "plate.toml", "--set", "analysis.dimension=3"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, testing::HasSubstr("plate.toml:4: zone_plate = true: needs dimension = 2"));
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1);
}

}
}
