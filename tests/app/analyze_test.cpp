// `poissonlab analyze`: sets made elsewhere.
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

TEST(Analyze, ATextFileIsReportedLikeASetMadeHere)
{
    const TemporaryFolder folder;
    folder.write("grid.txt", "# four points\n0.25 0.25\n0.75 0.25\n0.25 0.75\n0.75 0.75\n");
    const Outcome outcome = run_program(folder.path(), {"analyze", "grid.txt", "--out", "mine", "--label", "My grid"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, testing::EndsWith("\nmine/index.html\n"));
    for (const char* file : {"index.html", "results.json", "My-grid/realization-000.dat", "My-grid/spectrum.exr",
                             "My-grid/spectrum.png", "My-grid/radial.csv"})
        EXPECT_TRUE(fs::exists(folder.path() / "mine" / file)) << file;

    const auto json = nlohmann::json::parse(content_of(folder.path() / "mine/results.json"));
    const auto& series = json["series"][0];
    EXPECT_EQ(json["command"], "poissonlab analyze grid.txt --out mine --label 'My grid'");
    EXPECT_EQ(json["config"], "");
    EXPECT_EQ(series["label"], "My grid");
    EXPECT_EQ(series["points"], 4);
    EXPECT_EQ(series["min_distance"]["min"], 0.5);
    EXPECT_EQ(series["spectrum"]["kind"], "periodogram");
    EXPECT_TRUE(series["timing"]["sample_seconds"].empty());
}

TEST(Analyze, GivesWhatRunGave)
{
    const TemporaryFolder folder;
    folder.write("c.toml", "[analysis]\npoints = 64\nrealizations = 3\n[[method]]\nsampler = \"jittered\"\n");
    ASSERT_EQ(run_program(folder.path(), {"run", "c.toml", "--out", "made"}).status, 0);
    const std::string made = (folder.path() / "made/jittered/realization-00").string();
    const Outcome outcome =
        run_program(folder.path(), {"analyze", made + "0.dat", made + "1.dat", made + "2.dat", "--out", "read"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(content_of(folder.path() / "read/realization-000/radial.csv"),
              content_of(folder.path() / "made/jittered/radial.csv"));
}

TEST(Analyze, TakesKeysOfTheAnalysis)
{
    const TemporaryFolder folder;
    folder.write("grid.txt", "0.25 0.25\n0.75 0.25\n0.25 0.75\n0.75 0.75\n");
    const Outcome outcome =
        run_program(folder.path(), {"analyze", "grid.txt", "--set", "analysis.zone_plate=true", "--set",
                                    "analysis.tiles=2", "--set", "analysis.spectrum_size=48"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto json = nlohmann::json::parse(content_of(folder.path() / "out/grid/results.json"));
    const auto& series = json["series"][0];
    EXPECT_EQ(json["overrides"].size(), 3);
    EXPECT_EQ(series["spectrum"]["size"], 48);
    EXPECT_TRUE(fs::exists(folder.path() / "out/grid/grid/zone-plate.exr"));
    EXPECT_EQ(series["measures"]["lattice_peaks"]["tiles"], 2);
    EXPECT_TRUE(fs::exists(folder.path() / "out/grid/grid/pair-correlation.csv"));
    EXPECT_EQ(series["measures"]["integration"].size(), 5);
}

TEST(Analyze, OtherKeysMeanNothing)
{
    const TemporaryFolder folder;
    folder.write("grid.txt", "0.25 0.25\n0.75 0.25\n");
    const auto error_of = [&](const std::string& set) {
        const Outcome outcome = run_program(folder.path(), {"analyze", "grid.txt", "--set", set});
        EXPECT_EQ(outcome.status, 2) << set;
        return outcome.error;
    };
    EXPECT_THAT(error_of("seed=2"), testing::HasSubstr("unknown key"));
    EXPECT_THAT(error_of("analysis.points=2"), testing::HasSubstr("unknown key"));
    EXPECT_THAT(error_of("analysis=2"), testing::HasSubstr("--set analysis.KEY=VALUE"));
    EXPECT_THAT(error_of("method.0.label=a"), testing::HasSubstr("[[method]]"));
    EXPECT_THAT(error_of("analysis.volume=true"), testing::HasSubstr("needs dimension = 3"));
    EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

TEST(Analyze, UnequalSizesAreAnError)
{
    const TemporaryFolder folder;
    folder.write("a.txt", "0.1 0.2\n0.3 0.4\n");
    folder.write("b.txt", "0.1 0.2\n");
    const Outcome outcome = run_program(folder.path(), {"analyze", "a.txt", "b.txt", "--out", "mine"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.error, "poissonlab: error: b.txt: has 1 points where a.txt has 2: "
                             "realizations must have the same number of points; analyze sets of several "
                             "methods one at a time, or as [[method]] tables of a config\n");
    EXPECT_FALSE(fs::exists(folder.path() / "mine"));
}

TEST(Analyze, BrokenFilesNameTheLine)
{
    const TemporaryFolder folder;
    folder.write("a.txt", "0.1 0.2\n0.3 1.4\n");
    const Outcome outcome = run_program(folder.path(), {"analyze", "a.txt"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, testing::StartsWith("poissonlab: error: a.txt:2"));
    EXPECT_EQ(run_program(folder.path(), {"analyze", "no.txt"}).status, 2);
    EXPECT_EQ(run_program(folder.path(), {"analyze", "."}).status, 2);
}

/// Numbers of a file that is read in pieces: those of the same file in memory.
TEST(Analyze, InPiecesIsTheSame)
{
    const TemporaryFolder folder;
    ASSERT_EQ(run_program(folder.path(), {"points", "dart-throwing", "--points", "4000", "--out", "set.h5"}).status, 0);
    ASSERT_EQ(run_program(folder.path(), {"analyze", "set.h5", "--out", "memory"}).status, 0);
    const Outcome outcome = run_program(folder.path(), {"analyze", "set.h5", "--out", "new/pieces", "--in-pieces"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto series = [&](const std::string& out) {
        return nlohmann::json::parse(content_of(folder.path() / out / "results.json"))["series"][0];
    };
    const auto memory = series("memory"), pieces = series("new/pieces");
    for (const char* exact : {"points", "min_distance", "relative_radius", "covered_fraction"})
        EXPECT_EQ(pieces[exact], memory[exact]) << exact;
    for (const auto& [name, value] : memory["measures"].items()) {
        if (!value.is_object() || !value.contains("value") || !value["value"].is_number()) continue;
        ASSERT_TRUE(pieces["measures"].contains(name)) << name;
        EXPECT_NEAR(pieces["measures"][name]["value"].get<double>(), value["value"].get<double>(),
                    1e-9 * (1 + std::abs(value["value"].get<double>())))
            << name;
    }
    for (const char* table : {"set/pair-correlation.csv", "set/number-variance.csv"})
        EXPECT_EQ(content_of(folder.path() / "new/pieces" / table), content_of(folder.path() / "memory" / table));
    EXPECT_TRUE(pieces["point_files"].empty());
    for (const auto& entry : fs::directory_iterator(folder.path() / "new"))
        EXPECT_EQ(entry.path().filename(), "pieces"); // nothing is left of the strips
    EXPECT_EQ(run_program(folder.path(), {"report", "new/pieces"}).status, 0);
    const Outcome plate = run_program(
        folder.path(), {"analyze", "set.h5", "--in-pieces", "--set", "analysis.zone_plate=true", "--out", "plate"});
    EXPECT_EQ(plate.status, 2);
    EXPECT_THAT(plate.error, testing::HasSubstr("analysis.zone_plate = true: sets that are read in pieces have none"));
}

}
}
