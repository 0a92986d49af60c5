// OpenCL that is not there, fails, vanishes, or has too little memory.
#include "base/files/whole_file.hpp"
#include "tests/luck/bad_luck.hpp"

namespace poissonlab {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int not_available = -2; // CL_DEVICE_NOT_AVAILABLE

class DeviceLuck : public BadLuck
{
protected:
    std::string gone(long after, const std::string& what = "opencl") const
    {
        return bad_luck("BAD_LUCK=" + what + " BAD_LUCK_AFTER=" + std::to_string(after) +
                        " BAD_LUCK_ERROR=" + std::to_string(not_available));
    }
};

/// Whatever call is the first to fail: the call and the error are named, nothing is left behind, and with the device
/// back the run goes on to its end.
TEST_F(DeviceLuck, VanishesDuringARun)
{
    write_config("tiny.toml", "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.6\n"
                              "[[method]]\nsampler = \"lloyd\"\niterations = 2\n");
    const long all = calls({"run", "tiny.toml", "--out", "whole", "--quiet"}, "BAD_LUCK=opencl");
    ASSERT_GT(all, 500);
    constexpr int moments = 5;
    for (int i = 0; i < moments; ++i) {
        const long after = (all - 1) * i / (moments - 1);
        SCOPED_TRACE("after " + std::to_string(after) + " of " + std::to_string(all) + " calls");
        const std::string out = "out-" + std::to_string(i);
        const Outcome outcome = run(out, gone(after));
        expect_one_line(outcome, 3, "failed with CL_DEVICE_NOT_AVAILABLE");
        EXPECT_THAT(outcome.error, ContainsRegex("cl[A-Z][A-Za-z]+ failed"));
        EXPECT_THAT(left_over(path(out)), IsEmpty());
        // A series that was done before is there, and the other is said to be missing.
        if (std::filesystem::exists(path(out) / "results.json")) {
            EXPECT_THAT(read_whole_file(path(out) / "results.json"), ContainsRegex("\"missing\": \\["));
        }
        EXPECT_EQ(run(out).status, 0);
        EXPECT_EQ(lasting_files(path(out)), lasting_files(path("whole")));
    }
}

/// Each kind of call is the first to fail, once at its first use.
TEST_F(DeviceLuck, IsNamedByTheCall)
{
    for (const std::string call :
         {"clCreateCommandQueue", "clCreateBuffer", "clBuildProgram", "clEnqueueNDRangeKernel"}) {
        SCOPED_TRACE(call);
        expect_one_line(run("out", gone(0, call)), 3, call + " failed with CL_DEVICE_NOT_AVAILABLE");
    }
}

/// The second of two series fails at its last call of a kind, as drivers do that allocate late or build late: the first
/// is kept and shown.
TEST_F(DeviceLuck, FailsInTheSecondSeriesAndKeepsTheFirst)
{
    write_config("tiny.toml", "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.6\n"
                              "[[method]]\nsampler = \"lloyd\"\niterations = 2\n");
    const std::vector<std::pair<std::string, std::pair<int, std::string>>> failures{
        {"clCreateBuffer", {-4, "CL_MEM_OBJECT_ALLOCATION_FAILURE"}},
        {"clEnqueueNDRangeKernel", {-4, "CL_MEM_OBJECT_ALLOCATION_FAILURE"}},
        {"clEnqueueReadBuffer", {-5, "CL_OUT_OF_RESOURCES"}},
        {"clBuildProgram", {-11, "CL_BUILD_PROGRAM_FAILURE"}},
    };
    for (const auto& [call, error] : failures) {
        SCOPED_TRACE(call);
        const long all = calls({"run", "tiny.toml", "--out", "whole-" + call, "--quiet"}, "BAD_LUCK=" + call);
        const std::string out = "out-" + call;
        const std::string fails = "BAD_LUCK=" + call + " BAD_LUCK_AFTER=" + std::to_string(all - 1) +
                                  " BAD_LUCK_ERROR=" + std::to_string(error.first);
        expect_one_line(run(out, bad_luck(fails)), 3, call + " failed with " + error.second);
        const std::string results = content_of(path(out) / "results.json");
        EXPECT_THAT(results, HasSubstr("\"sampler\": \"dart-throwing\""));
        EXPECT_THAT(results, ContainsRegex("\"missing\": \\["));
        EXPECT_THAT(left_over(path(out)), IsEmpty());
    }
}

TEST_F(DeviceLuck, VanishesWhileTilesAreMade)
{
    const std::vector<std::string> build{
        "tiles",   "build", "corner", "--colors", "1",       "--points",          "16",
        "--lloyd", "2",     "--out",  "set",      "--quiet", "--relative-radius", "0.5"};
    const std::vector<std::string> points{"tiles", "points", "set", "--window", "0", "0", "5", "5", "--out", "points"};
    for (const auto& command : {build, points}) {
        const long all = calls(command, "BAD_LUCK=opencl");
        const std::string earlier = content_of(path(command[1] == "build" ? "set" : "points"));
        SCOPED_TRACE(command[1]);
        expect_one_line(run_program(folder_.path(), command, gone(all - 1)), 3, "CL_DEVICE_NOT_AVAILABLE");
        EXPECT_EQ(content_of(path(command[1] == "build" ? "set" : "points")), earlier);
        EXPECT_THAT(left_over(folder_.path()), IsEmpty());
    }
}

TEST_F(DeviceLuck, DoesNotBuildAKernel)
{
    const Outcome outcome = run("out", bad_luck("BAD_LUCK=clBuildProgram BAD_LUCK_ERROR=-11"));
    expect_one_line(outcome, 3, "building kernels/dart_throwing.cl (-D DIMENSION=2");
    EXPECT_THAT(outcome.error, HasSubstr("clBuildProgram failed with CL_BUILD_PROGRAM_FAILURE"));
}

/// PoCL looks for a linker in PATH, and would end the program where there is none and kernels are new.
TEST_F(DeviceLuck, HasNoLinker)
{
    const std::string no_kernels = "POCL_CACHE_DIR=" + quoted(path("kernels").string());
    expect_one_line(run("out", no_kernels + " PATH=/proc/none"), 3, "PoCL needs the linker ld");
    const Outcome outcome = run("out", no_kernels + " env -u PATH");
    EXPECT_EQ(outcome.status, 0) << "programs are looked for in /usr/bin; " << outcome.error;
}

TEST_F(DeviceLuck, IsNotThere)
{
    std::filesystem::create_directories(path("no drivers"));
    const std::string none = "OCL_ICD_VENDORS=" + quoted(path("no drivers").string() + "/");
    expect_one_line(run("out", none), 3, "no OpenCL device found");
    EXPECT_FALSE(std::filesystem::exists(path("out")));
    expect_one_line(run_program(folder_.path(), {"devices"}, none), 3, "no OpenCL device found");

    write_config("random.toml", "[[method]]\nsampler = \"random\"\n");
    const Outcome outcome = run("out", none, "random.toml");
    EXPECT_EQ(outcome.status, 0) << "needs no device; " << outcome.error;
}

TEST_F(DeviceLuck, IsNotTheOneThatIsMeant)
{
    for (const std::string name : {"99", "no such device"}) {
        const Outcome outcome =
            run_program(folder_.path(), {"run", "tiny.toml", "--out", "out", "--quiet", "--device", name});
        expect_one_line(outcome, 3, name);
        EXPECT_THAT(outcome.error, HasSubstr("there are: 0: "));
        EXPECT_FALSE(std::filesystem::exists(path("out")));
    }
}

/// PoCL can be told to have a gibibyte only.
TEST_F(DeviceLuck, HasTooLittleMemory)
{
    write_config("large.toml", "[[method]]\nsampler = \"random\"\npoints = 100\n[[method]]\nsampler = \"lloyd\"\n"
                               "points = 60000000\niterations = 1\n");
    const Outcome outcome = run("out", "POCL_MEMORY_LIMIT=1", "large.toml");
    expect_one_line(outcome, 2, "large.toml:9: Lloyd relaxation");
    EXPECT_THAT(outcome.error, HasSubstr("has 1.0 GiB, "));
    EXPECT_THAT(outcome.error, ContainsRegex("up to 1?[0-9]{7} points would fit"));
    EXPECT_FALSE(std::filesystem::exists(path("out"))) << "refused before any work";
}

}
}
