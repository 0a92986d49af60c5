// `poissonlab run`, from the config to the report, in a pipe.
#include "tests/app/lasting_results.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

class Run : public testing::Test
{
protected:
    Outcome run(const std::vector<std::string>& arguments = {"run", "tiny.toml"},
                const std::string& environment = "") const
    {
        return run_program(folder_.path(), arguments, environment);
    }

    TemporaryFolder folder_;
    fs::path config_ = folder_.write("tiny.toml", "title = \"Tiny\"\n[analysis]\npoints = 64\nrealizations = 2\n"
                                                  "[[method]]\nsampler = \"random\"\n"
                                                  "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.60\n");
    fs::path out_ = folder_.path() / "out/tiny";
};

TEST_F(Run, WritesEverythingThatTheDocumentationLists)
{
    const Outcome outcome = run();
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    for (const char* file : {"index.html", "results.json", "random/realization-000.dat", "random/realization-001.dat",
                             "random/spectrum.exr", "random/spectrum.png", "random/radial.csv",
                             "dart-throwing-rho-0.60/realization-000.dat", "dart-throwing-rho-0.60/radial.csv"})
        EXPECT_TRUE(fs::exists(out_ / file)) << file;
    for (const auto& entry : fs::directory_iterator(out_))
        EXPECT_TRUE(entry.path().filename() == ".units" || !entry.path().filename().string().starts_with("."))
            << entry.path();

    const auto json = nlohmann::json::parse(content_of(out_ / "results.json"));
    EXPECT_EQ(json["command"], "poissonlab run tiny.toml");
    EXPECT_EQ(json["config"], content_of(config_));
    for (const auto& series : json["series"]) {
        EXPECT_EQ(series["timing"]["sample_seconds"].size(), 5U);
        for (const auto& file : series["point_files"]) EXPECT_TRUE(fs::exists(out_ / file.get<std::string>()));
    }
    EXPECT_NEAR(json["series"][1]["relative_radius"]["min"].get<double>(), 0.6, 0.05);
    EXPECT_GE(json["series"][1]["relative_radius"]["min"].get<double>(), 0.6 - 1e-6);
}

/// A run says once what was left out of a file, however many series have the file.
TEST_F(Run, SaysWhatWasLeftOutOfFiles)
{
    folder_.write("flat.txt", "0.1 0.2 0\n0.3 0.7 0\n0.8 0.4 0\n");
    folder_.write("flat.toml", "[[method]]\nsampler = \"file\"\npath = \"flat.txt\"\n"
                               "[[method]]\nsampler = \"file\"\npath = \"flat.tx*\"\nlabel = \"Again\"\n");
    const Outcome outcome = run({"run", "flat.toml"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const std::string sentence = "all points have the same third coordinate: they are taken as points of the plane";
    const std::size_t at = outcome.out.find(sentence);
    EXPECT_NE(at, std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find(sentence, at + 1), std::string::npos) << outcome.out;
}

TEST_F(Run, SetsOfDifferentSizesAreReportedAsSuch)
{
    folder_.write("sat.toml", "[analysis]\npoints = 300\nrealizations = 6\n"
                              "[[method]]\nsampler = \"dart-throwing\"\nstop = \"saturation\"\n");
    const Outcome outcome = run({"run", "sat.toml"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const fs::path out = folder_.path() / "out/sat";
    const auto series = nlohmann::json::parse(content_of(out / "results.json"))["series"][0];
    const auto sizes = series["points_each"].get<std::vector<std::size_t>>();
    ASSERT_EQ(sizes.size(), 6U);
    const auto [fewest, most] = std::ranges::minmax_element(sizes);
    ASSERT_NE(*fewest, *most);
    EXPECT_THAT(content_of(out / "index.html"),
                testing::HasSubstr(std::to_string(*fewest) + " to " + std::to_string(*most)));
}

TEST_F(Run, InAPipeSaysOneLineASeriesAndThePath)
{
    const std::string out = run().out;
    EXPECT_EQ(std::ranges::count(out, '\n'), 3) << out;
    EXPECT_EQ(out.find_first_of("\r\033"), std::string::npos);
    EXPECT_THAT(out, testing::StartsWith("Random: 2 realizations of 64 points, relative radius "));
    EXPECT_THAT(out,
                testing::HasSubstr("\nDart throwing, rho = 0.60: 2 realizations of 64 points, relative radius 0.6"));
    EXPECT_THAT(out, testing::EndsWith("\nout/tiny/index.html\n"));
    EXPECT_EQ(run({"run", "tiny.toml", "--quiet"}).out, "out/tiny/index.html\n");
}

TEST_F(Run, TwiceGivesTheSameBytesForAnyNumberOfThreadsAndEitherEngine)
{
    ASSERT_EQ(run().status, 0);
    const auto first = lasting_results(out_);
    ASSERT_EQ(run().status, 0);
    EXPECT_EQ(lasting_results(out_), first);

    ASSERT_EQ(run({"run", "tiny.toml", "--threads", "1", "--out", "one"}).status, 0);
    ASSERT_EQ(run({"run", "tiny.toml", "--set", "engine=reference", "--out", "reference"}).status, 0);
    for (const char* out : {"one", "reference"}) {
        for (const auto& [name, content] : files_below(folder_.path() / out)) {
            if (!name.ends_with(".dat") && !name.ends_with(".csv")) continue;
            EXPECT_EQ(content, first.at(name)) << out << name;
        }
    }
}

TEST_F(Run, ALocaleWithDecimalCommasChangesNothing)
{
    // Systems without the locale would run in "C" and show nothing: make it here.
    const std::string locale = (folder_.path() / "de_DE.UTF-8").string();
    const std::string make = "localedef -i de_DE -f UTF-8 " + quoted(locale) + " >/dev/null 2>&1";
    if (std::system(make.c_str()) != 0) GTEST_SKIP() << "no localedef";
    ASSERT_EQ(run({"run", "tiny.toml"}, "LC_ALL=C").status, 0); // by the same file: pictures name what drew them
    const auto expected = lasting_results(out_);
    const Outcome outcome =
        run({"run", "tiny.toml"}, "LOCPATH=" + quoted(folder_.path().string()) + " LC_ALL=de_DE.UTF-8");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(lasting_results(out_), expected);
}

TEST_F(Run, WhereASeriesFailsTheReportHasTheOthers)
{
    // A radius that most sets of this size reach and some do not: found out while running.
    const Outcome outcome =
        run({"run", "tiny.toml", "--set", "method.1.relative_radius=0.79", "--set", "analysis.realizations=40"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, testing::HasSubstr("relative_radius = 0.79"));
    EXPECT_THAT(outcome.error, testing::HasSubstr("1 of 2 could not be made: Dart throwing"));
    EXPECT_THAT(outcome.out, testing::HasSubstr("Random: 40 realizations"));
    EXPECT_THAT(outcome.out, testing::EndsWith("out/tiny/index.html\n"));
    EXPECT_THAT(content_of(out_ / "index.html"), testing::HasSubstr("<b>Missing here.</b> Dart throwing"));
    const auto results = nlohmann::json::parse(content_of(out_ / "results.json"));
    EXPECT_EQ(results["series"].size(), 1U);
}

TEST_F(Run, WhereNothingCanBeMadeThePreviousResultStays)
{
    ASSERT_EQ(run().status, 0);
    const auto before = files_below(out_);
    folder_.write("one/tiny.toml", "[analysis]\npoints = 64\nrealizations = 40\n"
                                   "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.79\n");
    const Outcome outcome = run({"run", "one/tiny.toml", "--out", "out/tiny"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(files_below(out_), before);
}

TEST_F(Run, InterruptedSaysHowToGoOn)
{
    const std::string command = "cd " + quoted(folder_.path().string()) + " && " + quoted(program_file()) +
                                " run tiny.toml --set analysis.realizations=10000 --set analysis.points=1024"
                                " >log 2>&1 & pid=$!; sleep 1; kill -TERM $pid; wait $pid";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_THAT(
        content_of(folder_.path() / "log"),
        testing::EndsWith("poissonlab: interrupted; finished work is kept in out/tiny/.units: the same command goes "
                          "on from there (poissonlab run tiny.toml --set analysis.realizations=10000 --set "
                          "analysis.points=1024)\n"));
    EXPECT_TRUE(!fs::exists(out_) || files_below(out_).empty()) << "results appear all at once";
}

TEST_F(Run, ReportCanBeBuiltAgain)
{
    ASSERT_EQ(run().status, 0);
    fs::remove(out_ / "index.html");
    const Outcome outcome = run({"report", "out/tiny", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.out, "out/tiny/index.html\n");
    EXPECT_TRUE(fs::exists(out_ / "index.html"));
}

}
}
