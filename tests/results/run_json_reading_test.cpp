// results.json, whole and damaged: every complaint names the file and the member.
#include "results/run.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "reports/site/report.hpp"
#include "tests/reports/support/synthetic_results.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <functional>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;

/// The message of the InputError that a report on that folder ends with.
std::string error_of(const fs::path& folder)
{
    const std::string message = message_of([&] { write_report({folder}, folder); });
    EXPECT_FALSE(fs::exists(folder / "index.html"));
    return message;
}

/// The message that a report ends with after a change to results.json.
std::string error_after(const std::function<void(nlohmann::json&)>& damage)
{
    const TemporaryFolder folder;
    auto json = test::write_synthetic_results(folder.path());
    damage(json);
    test::write_results_json(folder.path(), json);
    return error_of(folder.path());
}

TEST(StoredResults, ReadsWhatWasWritten)
{
    const TemporaryFolder folder;
    test::write_synthetic_results(folder.path());
    const auto run = read_run(folder.path());
    EXPECT_EQ(run.title, "Grids <script>alert(1)</script> & co");
    EXPECT_EQ(run.seed, "18446744073709551615");
    EXPECT_EQ(run.machine.text("device"), "Test <device>");
    EXPECT_EQ(run.machine.text("platform"), "");
    ASSERT_EQ(run.series.size(), 3);
    EXPECT_EQ(run.series[0].points, 256);
    EXPECT_TRUE(run.series[0].is_estimate);
    EXPECT_FALSE(run.series[2].is_estimate);
    EXPECT_TRUE(run.series[2].deterministic);
    EXPECT_NEAR(run.series[2].min_distance->mean, 1.0 / 16, 1e-12);
    EXPECT_EQ(run.series[1].sample_seconds.size(), 2);
}

TEST(StoredResults, SamplersAmongTheParametersAreReadable)
{
    const TemporaryFolder folder;
    auto json = test::write_synthetic_results(folder.path());
    json["series"][0]["parameters"] = nlohmann::json::parse(
        R"({"a": {"sampler": "relax", "repulsion": true, "start": {"sampler": "random"}}, "b": {"c": 1}})");
    test::write_results_json(folder.path(), json);
    EXPECT_EQ(read_run(folder.path()).series[0].parameters,
              (NamedTexts{{"a", "relax (repulsion = true, start = random)"}, {"b", "{\"c\":1}"}}));
}

TEST(StoredResults, OnePointHasNoDistance)
{
    const TemporaryFolder folder;
    auto json = test::write_synthetic_results(folder.path());
    for (const auto* name : {"min_distance", "relative_radius", "covered_fraction"}) json["series"][0][name] = nullptr;
    test::write_results_json(folder.path(), json);
    EXPECT_FALSE(read_run(folder.path()).series[0].min_distance);
    write_report({folder.path()}, folder.path());
    EXPECT_THAT(read_whole_file(folder.path() / "index.html"), HasSubstr("<td data-key=\"relative_radius\">–</td>"));
}

TEST(StoredResults, FoldersWithoutResults)
{
    const TemporaryFolder folder;
    const std::string name = folder.path().string();
    EXPECT_EQ(error_of(folder.path()), name + ": has no results.json: must be a folder that `run` or `analyze` wrote");
    EXPECT_EQ(error_of(folder.path() / "gone"), name + "/gone: no such folder");
}

TEST(StoredResults, DamagedJson)
{
    const TemporaryFolder folder;
    test::write_synthetic_results(folder.path());
    const auto text = read_whole_file(folder.path() / "results.json");
    folder.write("results.json", text.substr(0, text.size() / 2));
    EXPECT_THAT(error_of(folder.path()), MatchesRegex(".*results.json:[0-9]+: is not JSON: .*"));
    folder.write("results.json", "[]");
    EXPECT_THAT(error_of(folder.path()), HasSubstr("results.json: must be an object"));
}

TEST(StoredResults, ForeignJson)
{
    EXPECT_THAT(error_after([](auto& json) { json["format"] = "other"; }),
                HasSubstr("results.json: format = \"other\": "));
    EXPECT_THAT(error_after([](auto& json) { json["format_version"] = 2; }),
                HasSubstr("results.json: format_version = 2: "));
}

TEST(StoredResults, MissingAndWrongMembers)
{
    EXPECT_THAT(error_after([](auto& json) { json.erase("title"); }), HasSubstr("results.json: title: is missing"));
    EXPECT_THAT(error_after([](auto& json) { json["series"].clear(); }), HasSubstr("results.json: series: "));
    EXPECT_THAT(error_after([](auto& json) { json["series"][1]["points"] = "many"; }),
                HasSubstr("results.json: series[1].points = \"many\": must be an integer of at least 1"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][1]["realizations"] = 4294967297; }),
                HasSubstr("series[1].realizations = 4294967297: must be an integer of at least 1 and at most "
                          "2147483647"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][1]["points"] = 18446744073709551615U; }),
                HasSubstr("series[1].points = 18446744073709551615: must be an integer of at least 1"));
    EXPECT_THAT(error_after([](auto& json) {
                    json["series"][1]["points_each"] = {7, -1};
                }),
                HasSubstr("series[1].points_each: must be a list of integers of at least 0"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][1]["points_each"] = {7}; }),
                HasSubstr("results.json: series[1].points_each: must have a size for each realization"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][2]["relative_radius"].erase("mean"); }),
                HasSubstr("results.json: series[2].relative_radius.mean: is missing"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][0]["timing"]["sample_seconds"] = {"x"}; }),
                HasSubstr("results.json: series[0].timing.sample_seconds: must be a list of numbers"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][2]["spectrum"]["kind"] = "power spectrum estimate"; }),
                HasSubstr("results.json: series[2].spectrum.kind = "));
    EXPECT_THAT(error_after([](auto& json) { json["series"][1]["name"] = "random"; }),
                HasSubstr("series[1].name = \"random\": is used twice"));
}

TEST(StoredResults, NothingOutsideTheFolderIsTouched)
{
    EXPECT_THAT(error_after([](auto& json) { json["series"][0]["name"] = "../elsewhere"; }),
                HasSubstr("results.json: series[0].name = \"../elsewhere\": must be the name of a folder"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][0]["radial"]["file"] = "../../etc/passwd"; }),
                HasSubstr("results.json: series[0].radial.file = \"../../etc/passwd\": must be a file inside"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][0]["point_files"][0] = "/etc/passwd"; }),
                HasSubstr("results.json: series[0].point_files: \"/etc/passwd\" must be a file inside"));
}

TEST(StoredResults, MissingFiles)
{
    for (const auto* name : {"spectrum.exr", "radial.csv", "realization-001.dat"}) {
        const TemporaryFolder folder;
        test::write_synthetic_results(folder.path());
        fs::remove(folder.path() / "jittered" / name);
        EXPECT_THAT(error_of(folder.path()),
                    AllOf(HasSubstr("series[1]"), HasSubstr(std::string("jittered/") + name + " is missing")));
    }
}

TEST(StoredResults, FilesThatAreNotWhatTheResultsSay)
{
    const TemporaryFolder folder;
    test::write_synthetic_results(folder.path());
    const auto rewrite = [&](const std::string& name, const std::string& text) {
        const auto before = read_whole_file(folder.path() / name);
        folder.write(name, text);
        const auto message = error_of(folder.path());
        folder.write(name, before);
        return message;
    };
    EXPECT_THAT(rewrite("random/realization-000.dat", "0.5 0.5\n"),
                HasSubstr("random/realization-000.dat: must hold 256 points"));
    EXPECT_THAT(rewrite("random/spectrum.exr", "not an image"), HasSubstr("random/spectrum.exr"));
    EXPECT_THAT(rewrite("random/radial.csv", "a,b\n"), HasSubstr("random/radial.csv:1: must be the header"));
    EXPECT_THAT(error_after([](auto& json) { json["series"][0]["spectrum"]["size"] = 128; }),
                HasSubstr("random/spectrum.exr: must be an image of 128 x 128"));
}

}
}
