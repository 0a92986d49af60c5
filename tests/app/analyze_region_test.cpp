// `poissonlab analyze --region`: sets in a region of the plane, made elsewhere, and the same by a config.
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

TEST(AnalyzeRegion, WritesCurvesAndAReport)
{
    const TemporaryFolder folder;
    folder.write("park.geojson", R"({"type": "Polygon", "crs": {"type": "name", "properties": {"name": "EPSG:25832"}},
        "coordinates": [[[0, 0], [60, 4], [64, 40], [40, 30], [8, 44], [0, 0]], [[20, 14], [18, 24], [30, 20], [20, 14]]]})");
    ASSERT_EQ(run_program(folder.path(), {"distribute", "darts", "--region", "park.geojson", "--min-distance", "4",
                                          "--out", "trees.csv", "--quiet"})
                  .status,
              0);
    const Outcome outcome = run_program(
        folder.path(), {"analyze", "trees.csv", "--region", "park.geojson", "--set", "analysis.envelope=2", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const fs::path out = folder.path() / "out/trees";
    for (const char* file : {"index.html", "trees/region.csv", "trees/region.json", "trees/pair-correlation.csv",
                             "trees/points.svg", "trees/region-l.svg", "trees/region-nearest.svg",
                             "trees/region-empty-space.svg", "trees/region-j.svg", "trees/region-pair-correlation.svg"})
        EXPECT_TRUE(fs::exists(out / file)) << file;
    for (const char* file : {"trees/cells.svg", "trees/autocorrelation.png", "trees/number-variance.csv"})
        EXPECT_FALSE(fs::exists(out / file)) << file;
    const auto series = nlohmann::json::parse(content_of(out / "results.json"))["series"][0];
    EXPECT_EQ(series["region"]["name"], "park.geojson");
    EXPECT_EQ(series["region"]["envelope"], 2);
    const double unit = series["region"]["unit_length"];
    EXPECT_GE(series["min_distance"]["min"].get<double>() * unit, 4);
    EXPECT_LT(series["min_distance"]["min"].get<double>() * unit, 4.1);
    EXPECT_THAT(content_of(out / "trees/index.html"), testing::HasSubstr("in park.geojson, a region of area"));

    folder.write("c.toml", "[analysis]\nregion = \"park.geojson\"\nenvelope = 2\n"
                           "[[method]]\nsampler = \"file\"\npath = \"trees.csv\"\n");
    const Outcome same = run_program(folder.path(), {"run", "c.toml", "--quiet"});
    ASSERT_EQ(same.status, 0) << same.error;
    std::string found;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "out/c"))
        if (entry.path().filename() == "region.csv") found = content_of(entry.path());
    EXPECT_EQ(found, content_of(out / "trees/region.csv"));
}

}
}
