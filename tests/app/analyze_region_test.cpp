// `poissonlab analyze --region`: sets in a region of the plane, made elsewhere, and the same by a config.
#include "base/points/point_file.hpp"
#include "results/curve_tables.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <random>
#include <tuple>

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

/// Methods of a config in regions: realization 0 is the set of `distribute points`, in its units.
TEST(AnalyzeRegion, MethodsOfAConfigLieInRegions)
{
    const TemporaryFolder folder;
    folder.write("c.toml", "seed = 5\n[analysis]\nregion = \"disk 100 200 50\"\nenvelope = 0\npoints = 60\n"
                           "realizations = 33\n[[method]]\nsampler = \"sample-elimination\"\n"
                           "[[method]]\nsampler = \"dart-throwing\"\nmin_distance = 9\n"
                           "[[method]]\nsampler = \"random\"\nregion = \"rectangle 0 0 30 4\"\n");
    const Outcome outcome = run_program(folder.path(), {"run", "c.toml", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const fs::path out = folder.path() / "out/c";
    for (const auto& [method, series, more] :
         {std::tuple{"elimination", "sample-elimination", std::vector<std::string>{"--points", "60"}},
          {"darts", "dart-throwing-d-9", {"--min-distance", "9"}}}) {
        std::vector<std::string> words{"distribute", "points", "--region", "disk 100 200 50", "--method", method,
                                       "--seed",     "5",      "--out",    "same.npy",        "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        ASSERT_EQ(run_program(folder.path(), words).status, 0);
        EXPECT_EQ(read_points(out / series / "realization-000.dat", any_coordinates),
                  read_points(folder.path() / "same.npy", any_coordinates));
    }
    const auto run = nlohmann::json::parse(content_of(out / "results.json"));
    EXPECT_EQ(run["series"][0]["points"], 60);
    EXPECT_GE(run["series"][1]["min_distance"]["min"].get<double>() *
                  run["series"][1]["region"]["unit_length"].get<double>(),
              9 * (1 - 1e-9));
    EXPECT_EQ(run["series"][2]["region"]["name"], "rectangle 0 0 30 4");
    EXPECT_THAT(content_of(out / "index.html"), testing::HasSubstr("points in regions in 2D"));
    EXPECT_TRUE(fs::exists(out / "random/points.svg"));
    EXPECT_THAT(content_of(out / "sample-elimination/index.html"),
                testing::Not(testing::HasSubstr("the power is proportional to the frequency to the power of")));
    // A stored series is found again, with the same results.
    const std::string before = content_of(out / "results.json");
    ASSERT_EQ(run_program(folder.path(), {"run", "c.toml", "--quiet"}).status, 0);
    EXPECT_EQ(content_of(out / "results.json"), before);
    EXPECT_EQ(run_program(folder.path(), {"export", "out/c", "--out", "exported"}).status, 0);
}

std::string random_lines(int count)
{
    std::mt19937 random(7);
    std::string text;
    for (int i = 0; i < count; ++i) {
        const double x = static_cast<double>(random()) * 0x1p-32, y = static_cast<double>(random()) * 0x1p-32;
        text += fmt::format("{},{}\n", x, y);
    }
    return text;
}

/// One set by eight tapers is as good as eight sets, everywhere: a power spectrum estimate, whose anisotropy is that of
/// eight periodograms. Eight part no pair of equal frequency in a square.
TEST(AnalyzeRegion, CountsAPeriodogramForEachTaper)
{
    const TemporaryFolder folder;
    folder.write("points.csv", random_lines(4000));
    const Outcome outcome =
        run_program(folder.path(), {"analyze", "points.csv", "--region", "rectangle 0 0 1 1", "--set",
                                    "analysis.tapers=8", "--set", "analysis.envelope=0", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const fs::path out = folder.path() / "out/points";
    const auto series = nlohmann::json::parse(content_of(out / "results.json"))["series"][0];
    EXPECT_EQ(series["spectrum"]["kind"], "power spectrum estimate");
    EXPECT_NEAR(series["radial"]["background_anisotropy_db"].get<double>(), -10 * std::log10(8.0), 1e-6);
    EXPECT_THAT(content_of(out / "points/index.html"), testing::HasSubstr("dB for K\u00a0=\u00a08;"));

    double sum = 0, rings = 0, samples = 0;
    for (const RadialBin& ring : read_radial_table(out / "points/radial.csv"))
        if (ring.frequency >= 20 && ring.frequency <= 60) {
            sum += std::pow(10, ring.anisotropy_db / 10);
            ++rings;
            samples += static_cast<double>(ring.samples) / 2; // f and -f have one power
        }
    // Means of eight exponential variates have the squared deviation 1/8, whose estimate from n of them has the
    // relative one (2 + 6/8) / n. Frequencies that are three apart along each axis are independent, nearly: n is a
    // ninth.
    EXPECT_NEAR(8 * sum / rings, 1, 5 * std::sqrt(2.75 / (samples / 9)));
}

}
}
