// Disks that fill up at any moment, or cannot be written to at all.
#include "tests/luck/bad_luck.hpp"

#include <unistd.h>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class DiskLuck : public BadLuck
{
protected:
    /// Settings with which everything below a folder or file fails after so many calls.
    std::string full(const std::string& name, long after) const
    {
        return "BAD_LUCK=disk BAD_LUCK_FOLDER=" + quoted(path(name).string()) +
               " BAD_LUCK_AFTER=" + std::to_string(after);
    }

    long calls_below(const std::string& name, const std::vector<std::string>& arguments) const
    {
        return calls(arguments, "BAD_LUCK=disk BAD_LUCK_FOLDER=" + quoted(path(name).string()));
    }

    std::string absolute(const std::string& name) const { return path(name).string(); }
};

/// The disk is full at any stage of a run and its report. Then one line says which file could not be written, and no
/// file is half-written. Results of before are there still, whole, until there are new ones, and a second run ends as
/// if nothing had been.
TEST_F(DiskLuck, FillsUpDuringARun)
{
    const long all = calls_below("whole", {"run", "tiny.toml", "--out", absolute("whole"), "--quiet"});
    ASSERT_GT(all, 100);
    write_config("earlier.toml", "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.6\n", 2);
    ASSERT_EQ(run(absolute("out"), "", "earlier.toml").status, 0);
    const auto earlier = lasting_files(path("out"));
    const std::string earlier_results = content_of(path("out") / "results.json");

    constexpr int moments = 6;
    for (int i = 0; i < moments; ++i) {
        const long after = all * i * i / (moments * moments); // most of the calls are the report's
        SCOPED_TRACE("after " + std::to_string(after) + " calls");
        const Outcome outcome = run(absolute("out"), bad_luck(full("out", after)));
        expect_one_line(outcome, 1, "No space left on device");
        EXPECT_THAT(outcome.error, HasSubstr(absolute("out")));
        EXPECT_THAT(left_over(path("out")), IsEmpty());
        if (content_of(path("out") / "results.json") == earlier_results) {
            EXPECT_EQ(lasting_files(path("out")), earlier);
        }
    }
    ASSERT_EQ(run(absolute("out")).status, 0);
    EXPECT_EQ(lasting_files(path("out")), lasting_files(path("whole")));
}

TEST_F(DiskLuck, FillsUpWhileTilesAreWritten)
{
    const std::vector<std::string> build{"tiles",   "build", "corner",  "--colors",          "1",   "--points", "16",
                                         "--lloyd", "2",     "--quiet", "--relative-radius", "0.5", "--out"};
    auto to = [](std::vector<std::string> command, const std::string& file) {
        command.push_back(file);
        return command;
    };
    ASSERT_EQ(run_program(folder_.path(), to(build, absolute("set.ptiles"))).status, 0);
    const std::vector<std::string> points{"tiles", "points", "set.ptiles", "--window", "0", "0", "50", "50", "--out"};
    for (const auto& command : {build, points}) {
        std::filesystem::create_directories(path("new"));
        const std::string file = absolute("new/file");
        const long all = calls_below("new", to(command, file));
        const std::string earlier = content_of(file);
        ASSERT_FALSE(earlier.empty());
        for (const long after : {0L, all - 1}) {
            SCOPED_TRACE(command[1] + " after " + std::to_string(after));
            const Outcome outcome = run_program(folder_.path(), to(command, file), bad_luck(full("new", after)));
            expect_one_line(outcome, 1, file + ": cannot be written: No space left on device");
            EXPECT_THAT(left_over(path("new")), IsEmpty());
            EXPECT_EQ(content_of(file), earlier);
        }
    }
}

/// HDF5 makes these files.
TEST_F(DiskLuck, FillsUpWhileParticlesAreWritten)
{
    ASSERT_EQ(run_program(folder_.path(), {"tiles", "build", "sphere", "--colors", "1", "--points", "16", "--lloyd",
                                           "2", "--quiet", "--relative-radius", "0.4", "--out", absolute("set.ptiles")})
                  .status,
              0);
    for (const std::string name : {"glass.hdf5", "glass.h5part", "points.h5"}) {
        std::filesystem::create_directories(path("new"));
        const std::string file = absolute("new/" + name);
        const std::vector<std::string> command{"tiles", "points", "set.ptiles", "--torus", "30", "--out", file};
        const long all = calls_below("new", command);
        ASSERT_GT(all, 3);
        const std::string earlier = content_of(file);
        ASSERT_FALSE(earlier.empty());
        const Outcome before = run_program(folder_.path(), command, bad_luck(full("new", 0)));
        expect_one_line(before, 2, file + ": 432000 points take 0.01");
        for (const long after : {1L, all / 2, all - 1}) {
            SCOPED_TRACE(name + " after " + std::to_string(after));
            const Outcome outcome = run_program(folder_.path(), command, bad_luck(full("new", after)));
            expect_one_line(outcome, 1, file + ": cannot be written: No space left on device");
            EXPECT_THAT(left_over(path("new")), IsEmpty());
            EXPECT_EQ(content_of(file), earlier);
        }
    }
}

/// The program finds that the disk has no place before it builds a set of any size.
TEST_F(DiskLuck, HasNoPlaceForTiles)
{
    std::filesystem::create_directories(path("folder"));
    const auto build_to = [&](const std::string& file) {
        return run_program(folder_.path(),
                           {"tiles", "build", "corner", "--colors", "6", "--points", "4096", "--out", file});
    };
    expect_one_line(build_to("folder"), 2, "--out folder: is a folder");
    expect_one_line(build_to("none/file"), 2, "--out none/file: there is no folder none");
    if (::geteuid() == 0) return; // who may write everywhere
    std::filesystem::permissions(path("folder"),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    expect_one_line(build_to("folder/file"), 1, "--out folder/file: cannot be written: Permission denied");
}

TEST_F(DiskLuck, IsReadOnly)
{
    constexpr int read_only = 30; // EROFS
    const Outcome outcome =
        run(absolute("out"), bad_luck(full("out", 0) + " BAD_LUCK_ERROR=" + std::to_string(read_only)));
    expect_one_line(outcome, 1, "cannot create the folder " + absolute("out"));
    EXPECT_THAT(outcome.error, HasSubstr(": Read-only file system"));
    expect_one_line(run("/proc/out"), 1, "/proc/out");
}

/// A cache is no reason to fail: neither that of tile sets nor that of compiled kernels.
TEST_F(DiskLuck, OfTheCachesIsFull)
{
    write_config("tiles.toml", "[[method]]\nsampler = \"corner-tiles\"\ncolors = 1\npoints_per_tile = 16\n"
                               "relative_radius = 0.5\nlloyd_iterations = 2\n");
    std::filesystem::create_directories(path("cache"));
    const std::string caches =
        "POCL_CACHE_DIR=" + quoted(absolute("cache/kernels")) + " TMPDIR=" + quoted(absolute(""));
    const Outcome outcome = run("out", bad_luck(full("cache", 0) + " " + caches), "tiles.toml");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(folder_.names(), ::testing::Contains(::testing::StartsWith("poissonlab-kernels-")));
}

/// PoCL would end the program where it cannot store a kernel.
TEST_F(DiskLuck, LeavesNoFolderForKernels)
{
    std::filesystem::create_directories(path("disk/tmp"));
    const std::string caches =
        "POCL_CACHE_DIR=" + quoted(absolute("disk/kernels")) + " TMPDIR=" + quoted(absolute("disk/tmp"));
    const std::string full_disk = "BAD_LUCK=statvfs BAD_LUCK_FOLDER=" + quoted(absolute("disk"));
    const Outcome outcome = run("out", bad_luck(full_disk + " " + caches));
    expect_one_line(outcome, 3, "PoCL needs a folder for compiled kernels with 64.0 MiB free");
    EXPECT_THAT(outcome.error, HasSubstr(absolute("disk/kernels")));
    EXPECT_THAT(outcome.error, HasSubstr("POCL_CACHE_DIR"));
}

}
}
