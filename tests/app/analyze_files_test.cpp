// `poissonlab analyze` of files as others write them: what is read, and what is said of it.
#include "tests/support/command_test.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class AnalyzeFiles : public test::CommandTest
{
protected:
    AnalyzeFiles() : CommandTest("analyze") {}

    /// The series of results.json, after the command with these words.
    nlohmann::json series_of(const std::string& arguments)
    {
        const Outcome outcome = run(arguments + " --out out");
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        said_ = outcome.error + outcome.out;
        return nlohmann::json::parse(content_of(folder_.path() / "out/results.json"))["series"][0];
    }

    void write_by_python(const std::string& lines) const
    {
        folder_.write("script.py", "import h5py, numpy\n" + lines);
        const Outcome outcome = run_in_shell(folder_.path(), "/usr/bin/python3 script.py");
        ASSERT_EQ(outcome.status, 0) << outcome.error << " (package python3-h5py)";
    }

    std::string said_;
};

TEST_F(AnalyzeFiles, LeaveOutClasses)
{
    folder_.write("a.csv", "x,y,class\n0.25,0.25,0\n0.75,0.25,1\n0.25,0.75,1\n0.75,0.75,0\n");
    const auto series = series_of("a.csv");
    EXPECT_EQ(series["points"], 4);
    EXPECT_EQ(series["min_distance"]["min"], 0.5);
    EXPECT_THAT(said_, HasSubstr("a.csv: only the columns x and y are read; left out: class"));
}

/// A cubic lattice of 8 x 8 x 8 in two files: the part alone would be measured as half of it.
TEST_F(AnalyzeFiles, OfOneSnapshotAreOneSet)
{
    write_by_python(R"(
i = numpy.arange(512)
x = numpy.stack([i % 8, i // 8 % 8, i // 64], 1).astype('f4')
for k in range(2):
    f = h5py.File('s.%d.hdf5' % k, 'w')
    f['PartType0/Coordinates'] = x[256 * k:256 * k + 256]
    f['PartType1/Coordinates'] = x[:1]
    h = f.create_group('Header').attrs
    h['BoxSize'], h['NumFilesPerSnapshot'], h['NumPart_Total'] = [8.0] * 3, [2], numpy.array([512, 2, 0, 0, 0, 0], 'u4')
)");
    for (const std::string files : {"s.0.hdf5", "s.1.hdf5 s.0.hdf5", "s.1.hdf5 --in-pieces"}) {
        const auto series = series_of(files + " --particles 0");
        EXPECT_EQ(series["points"], 512) << files;
        EXPECT_EQ(series["realizations"], 1) << files;
        EXPECT_EQ(series["min_distance"]["min"], 0.125) << files;
        EXPECT_THAT(said_, HasSubstr(".hdf5: is read with all 2 files of its snapshot")) << files;
    }
    const Outcome outcome = run("s.0.hdf5 --out several");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.error,
              "poissonlab: error: s.0.hdf5: has several types of particles, PartType0 (512), PartType1 (2): "
              "one must be chosen, as by --particles 0\n");
    std::filesystem::remove(folder_.path() / "s.1.hdf5");
    EXPECT_EQ(run("s.0.hdf5 --particles 0").error,
              "poissonlab: error: s.0.hdf5: is one of 2 files of a snapshot, and s.1.hdf5 is missing\n");
}

TEST_F(AnalyzeFiles, SayWhichDomainWouldFit)
{
    folder_.write("a.csv", "id;X;Y\n1;128,5;20\n2;511,7;400,25\n3;2,5;300\n4;100;100\n");
    const Outcome outcome = run("a.csv --out out");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.error,
              "poissonlab: error: a.csv:2: 128.5: must be a number in [0, 1); the numbers go from 2.5 to "
              "511.7: --domain 0:512 or --domain \"0:512 0:410\" (a periodic box) or --region 'rectangle 0 0 512 410' "
              "would fit\n");
    EXPECT_EQ(series_of("a.csv --domain 0:512")["points"], 4);
}

TEST_F(AnalyzeFiles, OfADomainThatIsNotPeriodicMayLieOnItsSides)
{
    std::string grid;
    for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 4; ++j) grid += fmt::format("{} {}\n", i / 4.0, j / 4.0);
    folder_.write("g.txt", grid);
    const auto measured = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"analyze", "g.txt", "--domain", "0:2 0:1", "--out", "out"});
        return run_program(folder_.path(), words);
    };
    EXPECT_EQ(measured({}).status, 2);
    const Outcome outcome = measured({"--periodic", "no"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto results = nlohmann::json::parse(content_of(folder_.path() / "out/results.json"));
    EXPECT_EQ(results["series"][0]["region"]["perimeter"], 6);
}

TEST_F(AnalyzeFiles, OfAConfigHaveTypesOfParticlesToo)
{
    write_by_python(R"(
f = h5py.File('s.hdf5', 'w')
f['PartType0/Coordinates'] = numpy.random.default_rng(1).random((64, 3))
f['PartType1/Coordinates'] = numpy.zeros((2, 3))
f.create_group('Header').attrs['BoxSize'] = 1.0
)");
    const std::string config =
        "[analysis]\ndimension = 3\nspectrum = \"none\"\n[[method]]\nsampler = \"file\"\npath = \"s.hdf5\"\n";
    folder_.write("several.toml", config);
    folder_.write("gas.toml", config + "particles = 0\n");
    EXPECT_THAT(run_program(folder_.path(), {"run", "several.toml"}).error,
                HasSubstr("one must be chosen, as by particles = 0"));
    const Outcome outcome = run_program(folder_.path(), {"run", "gas.toml", "--out", "gas"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(nlohmann::json::parse(content_of(folder_.path() / "gas/results.json"))["series"][0]["points"], 64);
}

}
}
