// The files that commands write: standard output, devices, links, and names that say no format.
#include "base/programs/shell_words.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>
#include <span>

#include <sys/stat.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class OutputFiles : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = std::make_unique<TemporaryFolder>();
        std::string picture = "P2 64 64 255\n";
        for (int i = 0; i < 64 * 64; ++i) picture += std::to_string(i / 16) + "\n";
        folder_->write("grey.pgm", picture);
        ASSERT_EQ(
            shell("tiles build corner --colors 2 --points 8 --relative-radius 0.4 --lloyd 1 --quiet --out a.ptiles")
                .status,
            0);
    }
    static void TearDownTestSuite() { folder_.reset(); }

    /// `poissonlab ARGUMENTS` as a shell takes it.
    static Outcome shell(const std::string& arguments) { return run_program_line(folder_->path(), arguments); }

    static fs::path path(const std::string& name) { return folder_->path() / name; }

    static inline std::unique_ptr<TemporaryFolder> folder_;
};

constexpr auto darts = "distribute darts --region 'rectangle 0 0 9 9' --min-distance 1 ";
constexpr auto stipples = "distribute stipple --image grey.pgm --points 20 ";

/// Standard output gets the bytes that a file would get, and nothing else: what the program says goes to standard
/// error.
TEST_F(OutputFiles, CanBeStandardOutput)
{
    const std::vector<std::pair<std::string, std::string>> commands{
        {darts, ".txt"},
        {darts, ".npy"},
        {darts, ".svg"},
        {stipples, ".png"},
        {stipples, ".txt"},
        {"tiles build corner --colors 2 --points 8 --relative-radius 0.4 --lloyd 1 ", ".json"},
        {"tiles build corner --colors 2 --points 8 --relative-radius 0.4 --lloyd 1 ", ".ptiles"},
        {"tiles points a.ptiles --torus 3 ", ".txt"},
        {"tiles points a.ptiles --torus 3 ", ".h5"},
        {"tiles page a.ptiles ", ".html"},
        {"points dart-throwing --points 100 --relative-radius 0.5 ", ".txt"},
        {"packing corner --colors 2 ", ".svg"},
        {"isohedral draw 1 ", ".svg"},
        {"distribute dither-mask --size 16 ", ".npy"},
        {"aperiodic convert ammann --construction rotation ", ".txt"}};
    for (const auto& [command, ending] : commands) {
        SCOPED_TRACE(command + ending);
        ASSERT_EQ(shell(command + "--out file" + ending).status, 0);
        const std::string expected = content_of(path("file" + ending));
        ASSERT_FALSE(expected.empty());
        const Outcome outcome = shell(command + "--out -" + ending);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        // The comment of a file does not name it.
        EXPECT_EQ(outcome.out, expected);
    }
    EXPECT_THAT(shell(std::string(stipples) + "--out -.svg").error, HasSubstr("20 dots"));
}

TEST_F(OutputFiles, OfADashAreTextOrTheFirstFormat)
{
    for (const auto& [command, ending] : std::vector<std::pair<std::string, std::string>>{
             {darts, ".txt"}, {stipples, ".txt"}, {"isohedral draw 1 ", ".svg"}, {"tiles page a.ptiles ", ".html"}})
        EXPECT_EQ(shell(command + "--out -").out, shell(command + "--out -" + ending).out) << command;
    EXPECT_FALSE(fs::exists(path("-")));
    EXPECT_FALSE(fs::exists(path("-.svg")));
}

/// A file that is there before stays, and JSON does not get into the points.
TEST_F(OutputFiles, OfStandardOutputAreAppended)
{
    const std::string program = quoted(program_file()) + " ";
    const Outcome outcome =
        run_in_shell(folder_->path(), "{ echo before; " + program + darts + "--out /dev/stdout --json; } > both.txt");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    const Outcome alone = shell(std::string(darts) + "--out -");
    EXPECT_EQ(content_of(path("both.txt")), "before\n" + alone.out);
    const std::size_t begin = outcome.error.find("{\n");
    ASSERT_NE(begin, std::string::npos);
    EXPECT_TRUE(nlohmann::json::parse(outcome.error.substr(begin)).contains("points"));
}

TEST_F(OutputFiles, OfStandardOutputAreOne)
{
    for (const char* outs : {"--out - --out -.svg", "--out - --out -", "--out - --out /dev/stdout"}) {
        const Outcome outcome = shell(std::string(darts) + outs);
        EXPECT_EQ(outcome.status, 2) << outs;
        EXPECT_THAT(outcome.error, HasSubstr("standard output takes one file")) << outs;
        EXPECT_THAT(outcome.out, IsEmpty());
    }
    for (const auto& [arguments, words] : std::vector<std::pair<std::string, std::string>>{
             {"distribute mri-mask --shape 16 16 --acceleration 2 --out -.cfl", "-.cfl: has a second file beside it"},
             {"texture map grey.pgm --method hexagons --frames 2 --out -.png",
              "standard output takes one frame, not 2"}})
        EXPECT_THAT(shell(arguments).error, HasSubstr(words));
}

TEST_F(OutputFiles, CanBeDevicesAndPipes)
{
    for (const std::string& command :
         {std::string(darts), std::string("tiles build corner --colors 2 --points 8 --relative-radius 0.4 --lloyd 1 "),
          std::string("points lloyd --points 50 --iterations 1 "), std::string("tiles points a.ptiles --torus 2 ")}) {
        const Outcome outcome = shell(command + "--quiet --out /dev/null");
        EXPECT_EQ(outcome.status, 0) << command << outcome.error;
        EXPECT_TRUE(fs::is_character_file("/dev/null"));
    }
    const std::string program = quoted(program_file()) + " ";
    for (const std::string name : {"pipe.npy", "pipe.png", "pipe.txt"}) {
        ASSERT_EQ(::mkfifo(path(name).c_str(), 0600), 0);
        const Outcome outcome = run_in_shell(folder_->path(), "cat " + name + " > copy & " + program + darts +
                                                                  "--quiet --out " + name + " && wait");
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_TRUE(fs::is_fifo(path(name)));
        ASSERT_EQ(shell(std::string(darts) + "--quiet --out whole-" + name).status, 0);
        EXPECT_EQ(content_of(path("copy")), content_of(path("whole-" + name))) << name;
    }
}

TEST_F(OutputFiles, AreWrittenThroughLinks)
{
    fs::create_directory(path("elsewhere"));
    for (const std::string name : {"a.npy", "b.svg", "c.png", "d.h5"}) {
        folder_->write("elsewhere/" + name, "old");
        fs::create_symlink("elsewhere/" + name, path("link-" + name));
        ASSERT_EQ(shell(std::string(darts) + "--quiet --out link-" + name).status, 0);
        EXPECT_TRUE(fs::is_symlink(path("link-" + name)));
        ASSERT_EQ(shell(std::string(darts) + "--quiet --out plain-" + name).status, 0);
        EXPECT_EQ(content_of(path("elsewhere/" + name)), content_of(path("plain-" + name))) << name;
    }
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(path("elsewhere"))) ++files;
    EXPECT_EQ(files, 4U) << "something temporary was left";
    fs::create_symlink("none/a.npy", path("astray.npy"));
    EXPECT_THAT(shell(std::string(darts) + "--out astray.npy").error,
                HasSubstr("distribute darts: --out astray.npy: there is no folder none"));
}

/// Every option that names a file to write refuses endings that it does not know, in the same words, before it works.
TEST_F(OutputFiles, WithUnknownEndingsAreRefused)
{
    const std::vector<std::string> commands{darts,
                                            "distribute points --region 'rectangle 0 0 9 9' --points 9 ",
                                            stipples,
                                            "distribute hatch --image grey.pgm --points 20 ",
                                            "distribute warp --density x+1 --points 9 ",
                                            "distribute rank --density x+1 --points 9 ",
                                            "distribute icons --u x --v y --points 9 ",
                                            "distribute instances forest ",
                                            "distribute classes --points 5 5 ",
                                            "distribute surface none.obj --points 9 ",
                                            "distribute mri-mask --shape 16 16 --acceleration 2 ",
                                            "distribute dither-mask --size 16 ",
                                            "points dart-throwing --points 9 --relative-radius 0.5 ",
                                            "points lloyd --points 9 --iterations 1 ",
                                            "points gaussian-blue-noise --points 200 ",
                                            "tiles build corner --colors 2 --points 9 --relative-radius 0.5 ",
                                            "tiles points a.ptiles --torus 2 ",
                                            "tiles page a.ptiles ",
                                            "tiles picture a.ptiles --torus 2 ",
                                            "packing corner --colors 2 ",
                                            "isohedral draw 1 ",
                                            "aperiodic convert ammann --construction rotation ",
                                            "aperiodic tile ammann --window 0 0 2 2 ",
                                            "aperiodic verify ammann --width 2 ",
                                            "texture endless hexagons --exemplar grey.pgm ",
                                            "texture tile none --window 0 0 2 2 ",
                                            "texture map grey.pgm --method hexagons "};
    folder_->write("none.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::vector<std::string> endings{".PNG", ".xyz", ".json", ".json5", ".wkt", ".dwg", ".gltf"};
    for (const std::string& command : commands)
        for (const std::string& ending : std::span(endings).first(command == darts ? endings.size() : 2)) {
            SCOPED_TRACE(command + ending);
            const std::string name = "t" + ending;
            const Outcome outcome = shell(command + "--out " + name);
            EXPECT_EQ(outcome.status, 2);
            EXPECT_THAT(outcome.error, HasSubstr(": --out " + name + ": must end in ."));
            EXPECT_FALSE(fs::exists(path(name)));
        }
    for (const std::string& arguments :
         {std::string("distribute darts --region 'rectangle 0 0 9 9' --min-distance 1+0.1*x --out a.txt --distances "
                      "t.xyz"),
          std::string("distribute classes --points 5 5 --out a.csv --spectra t.xyz"),
          std::string("distribute warp --density x+2 --environment --points 9 --out a.txt "
                      "--lights t.xyz"),
          std::string("packing corner --colors 2 --puzzle t.xyz")})
        EXPECT_THAT(shell(arguments).error, HasSubstr(" t.xyz: must end in .")) << arguments;
}

/// Folders of pages of others stay as they are, whatever writes there.
TEST_F(OutputFiles, OfFoldersOfOthersAreRefused)
{
    folder_->write("points.txt", "0.1 0.1\n0.6 0.1\n0.1 0.6\n0.6 0.6\n");
    folder_->write("c.toml", "[analysis]\npoints = 16\nrealizations = 2\nspectrum_size = 16\n[[method]]\nsampler = "
                             "\"random\"\n");
    ASSERT_EQ(shell("run c.toml --quiet --out ours").status, 0);
    const std::string page = "<html><body>My thesis</body></html>";
    for (const std::string name : {"index.html", "compare.html", "claims.html"})
        for (const std::string command : {"analyze points.txt", "run c.toml", "report ours"}) {
            SCOPED_TRACE(command + " " + name);
            folder_->write("mine/" + name, page);
            const Outcome outcome = shell(command + " --quiet --out mine");
            EXPECT_EQ(outcome.status, 2);
            EXPECT_EQ(outcome.error, "poissonlab: error: --out mine: has " +
                                         std::string(name[0] == 'i' ? "an " : "a ") + name +
                                         " that poissonlab did not write; choose another folder\n");
            EXPECT_EQ(content_of(path("mine/" + name)), page);
            fs::remove_all(path("mine"));
        }
    folder_->write("mine/diff.html", page);
    EXPECT_THAT(shell("diff ours ours --out mine").error, HasSubstr("has a diff.html that poissonlab did not write"));
    EXPECT_EQ(content_of(path("mine/diff.html")), page);
    // The program writes files anew that it wrote itself.
    EXPECT_EQ(shell("run c.toml --quiet --out ours").status, 0);
    EXPECT_EQ(shell("report ours --quiet").status, 0);
    EXPECT_EQ(shell("diff ours ours --out difference").status, 0);
    EXPECT_EQ(shell("diff ours ours --out difference").status, 0);
}

/// The comment of a file of points is the command that makes the same bytes again, but for --out.
TEST(OutputFileComments, HasTheCommandThatMakesItAgain)
{
    const TemporaryFolder folder;
    const std::string tiles = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
    for (const std::string line :
         {"distribute darts --region 'disk 0 0 9' --min-distance 1 --obstacles 'POINT (1 1)' --boundary disks",
          "distribute points --region 'rectangle 0 0 9 4' --method lloyd --points 40 --iterations 3 --buffer 0.5",
          "distribute classes --points 5 20 --seed 4", "distribute warp --density 'x*x' --points 50 --method random",
          "distribute rank --density '1-x*x' --points 50", "distribute stipple --image 0.3 --dot 90 --by warping",
          "points lloyd --points 100 --iterations 2", "tiles points TILES --window -1 2 3 2 --density '0.2+0.1*x'",
          "tiles points TILES --region 'disk 0 0 9' --points 70 --seed 3"}) {
        const std::string command = std::regex_replace(line, std::regex("TILES"), tiles);
        const Outcome first = run_program_line(folder.path(), command + " --quiet --out a.ply");
        ASSERT_EQ(first.status, 0) << first.error;
        const std::string made = content_of(folder.path() / "a.ply");
        std::smatch found;
        ASSERT_TRUE(std::regex_search(made, found, std::regex("comment poissonlab ([^\n]*) --out FILE # "))) << made;
        ASSERT_EQ(run_program_line(folder.path(), found[1].str() + " --quiet --out b.ply").status, 0) << found[1];
        EXPECT_EQ(content_of(folder.path() / "b.ply"), made) << found[1];
    }
}

TEST(OutputFileComments, QuoteNamesOfFiles)
{
    const TemporaryFolder folder;
    const std::string tiles = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
    for (const std::string name : {"-a", "two words", "it's \"one\"", "$HOME; #", "-it's a \\"}) {
        folder.write(name + ".wkt", "POLYGON ((0 0, 9 0, 9 5, 0 0))");
        std::filesystem::copy_file(tiles, folder.path() / (name + ".ptiles"));
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{"distribute", "darts", "--region", name + ".wkt", "--min-distance", "1"},
              {"tiles", "points", "--torus", "1", "--", name + ".ptiles"}}) {
            const auto made_by = [&](std::vector<std::string> command, const std::string& out) {
                command.insert(command.begin() + 2, {"--quiet", "--out", out});
                EXPECT_EQ(run_program(folder.path(), command).status, 0) << name;
                return content_of(folder.path() / out);
            };
            const std::string made = made_by(words, "a.ply");
            std::smatch found;
            ASSERT_TRUE(std::regex_search(made, found, std::regex("comment poissonlab ([^\n]*) --out FILE # ")))
                << made;
            const auto again = split_shell_words(found[1]);
            ASSERT_TRUE(again) << found[1];
            EXPECT_EQ(made_by(*again, "b.ply"), made) << found[1];
        }
    }
}

/// A command that does not fit into a line is left out: a part of it might end within quotes, and could not be run.
TEST(OutputFileComments, LeaveOutLongCommands)
{
    const TemporaryFolder folder;
    std::string polygon;
    for (int i = 0; i < 300; ++i)
        polygon += fmt::format("{}{:.6f} {:.6f}", i > 0 ? ", " : "", 9 * std::cos(i * 0.02), 9 * std::sin(i * 0.02));
    const auto made_by = [&](std::vector<std::string> command, const std::string& out) {
        command.insert(command.end(), {"--seed", "3", "--quiet", "--out", out});
        EXPECT_EQ(run_program(folder.path(), command).status, 0);
        return content_of(folder.path() / out);
    };
    const std::vector<std::string> darts{"distribute",     "darts", "--region", "POLYGON ((" + polygon + ", 9 0))",
                                         "--min-distance", "1"};
    const std::string sentence = " with words that a comment cannot hold, --seed 3: ";
    const std::string made = made_by(darts, "a.ply");
    EXPECT_THAT(made, HasSubstr("comment poissonlab distribute darts" + sentence)) << made;
    EXPECT_EQ(made.substr(0, made.find("end_header")).find('\''), std::string::npos) << made;
    EXPECT_THAT(made_by(darts, "a.dxf"), StartsWith("999\npoissonlab distribute darts" + sentence));
    // Names with line breaks would end the comment.
    std::filesystem::copy_file(source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles",
                               folder.path() / "a\nb.ptiles");
    EXPECT_THAT(made_by({"tiles", "points", "a\nb.ptiles", "--torus", "1"}, "b.ply"),
                HasSubstr("comment poissonlab tiles points" + sentence));
}

}
}
