// Names with blanks, letters of any alphabet, quotes, and bytes that are no text at all.
#include "tests/luck/bad_luck.hpp"

namespace poissonlab {
namespace {

class NamesLuck : public BadLuck
{
};

class PathLuck : public BadLuck, public ::testing::WithParamInterface<std::string>
{
};

/// Paths of the current folder, the config, the output, the cache, point files and tile sets.
TEST_P(PathLuck, IsNoMatter)
{
    const std::string word = GetParam();
    const auto here = path(word);
    std::filesystem::create_directories(here);
    write_config(word + "/" + word + ".toml",
                 "[[method]]\nsampler = \"corner-tiles\"\ncolors = 1\npoints_per_tile = 16\n"
                 "relative_radius = 0.5\nlloyd_iterations = 2\n"
                 "[[method]]\nsampler = \"file\"\npath = '* 0.dat'\n");
    folder_.write(word + "/" + word + " 0.dat", "0.1 0.2\n0.5 0.7\n");
    const std::string environment = "POISSONLAB_CACHE=" + quoted((here / "cache").string());
    const auto succeeds = [&](const std::vector<std::string>& arguments) {
        const Outcome outcome = run_program(here, arguments, environment);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return outcome;
    };
    EXPECT_EQ(succeeds({"run", word + ".toml", "--quiet"}).out, "out/" + word + "/index.html\n");
    EXPECT_FALSE(std::filesystem::is_empty(here / "cache"));
    succeeds({"tiles", "build", "corner", "--colors", "1", "--points", "16", "--lloyd", "2", "--relative-radius", "0.5",
              "--quiet", "--out", word + ".ptiles"});
    succeeds({"tiles", "points", word + ".ptiles", "--window", "0", "0", "2", "2", "--out", word + ".dat"});
    succeeds({"analyze", word + ".dat", "--quiet", "--out", word + ".out"});

    const Outcome missing = run_program(here, {"run", word + "-missing.toml"});
    expect_one_line(missing, 2, "-missing.toml: cannot be read"); // bytes that are no text are escaped
}

/// Whatever is wrong with a file or an argument is said in one line.
TEST_F(NamesLuck, WithNewlinesAreOneLine)
{
    expect_one_line(run("/proc/a\nb"), 1, "/proc/a\\nb");
    expect_one_line(run_program(folder_.path(), {"run", "tiny.toml", "--device", "a\nb"}), 3, "matches \"a\\nb\"");
    expect_one_line(run_program(folder_.path(), {"run", "tiny.toml", "--no\nsuch"}), 2, "see poissonlab run --help");
    expect_one_line(
        run_program(folder_.path(), {"tiles", "points", "no\nset", "--window", "0", "0", "1", "1", "--out", "x"}), 2,
        "no\\nset: cannot be read");
}

INSTANTIATE_TEST_SUITE_P(OfLetters, PathLuck,
                         ::testing::Values("Gr\xc3\xbc\xc3\x9f"
                                           "e, \xe4\xb8\xad\xe6\x96\x87 \xd8\xb9 $HOME \"`x`\""));
INSTANTIATE_TEST_SUITE_P(OfBytes, PathLuck, ::testing::Values("latin \xe4\xf6\xfc"));

}
}
