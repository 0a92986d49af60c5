// Every kernel file, with the constants that the host gives it, is taken by Clang for graphics cards that the tests
// have not got: as SPIR, as PTX of NVIDIA and as code of AMD. PoCL depends on the same compiler. All extensions of
// OpenCL are off but those that the file's needs name: kernels need nothing that the table does not say.
#include "host/device/kernel_program.hpp"
#include "tests/kernels/kernel_programs.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Compiles a file below the source folder. Warnings are errors.
std::string errors_of(const std::string& file, const std::string& options, const std::string& target,
                      const KernelNeeds& needs = {.double_precision = true})
{
    const std::string extensions =
        std::string("-Xclang -cl-ext=-all") + (needs.double_precision ? ",+cl_khr_fp64 " : " ");
    const std::string command = "clang-15 -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -fsyntax-only -Wall "
                                "-Wno-unused-function -Werror -nogpulib -I . -target ";
    const Outcome outcome =
        run_in_shell(source_folder(), command + target + " " + extensions + options + " " + quoted(file));
    return outcome.status == 0 ? "" : options + "\n" + outcome.error;
}

class OfflineCompiler : public testing::TestWithParam<const char*>
{
};

TEST_P(OfflineCompiler, TakesEveryKernel)
{
    for (const KernelFile& file : kernel_files())
        for (const KernelProgram& program : programs_of(file))
            EXPECT_THAT(errors_of("kernels/" + program.file, program.options, GetParam(), program.needs), IsEmpty())
                << program.file;
}

TEST_P(OfflineCompiler, TakesHeadersForOtherPrograms)
{
    for (const char* file : {"kernels/common/tiles/tiling.clh", "runtime/poisson_tiles_gpu.h"})
        EXPECT_THAT(errors_of(file, "", GetParam()), IsEmpty());
}

/// Else devices without it would be refused for nothing.
TEST_P(OfflineCompiler, FindsThatDoublePrecisionIsNeeded)
{
    for (const KernelFile& file : kernel_files()) {
        if (!file.needs.double_precision) continue;
        EXPECT_THAT(errors_of("kernels/" + file.name, programs_of(file).front().options, GetParam(), {}),
                    HasSubstr("'double' requires cl_khr_fp64"))
            << file.name;
    }
}

/// Mesa's drivers of graphics cards begin with SPIR-V as this translator makes it (Debian: llvm-spirv-15), and the
/// rules of SPIR-V are not ours. Its only device that is tested, llvmpipe, has no doubles: this is as far as such files
/// go without a card.
TEST(SpirV, IsValidForEveryFile)
{
    if (run_in_shell(".", "command -v llvm-spirv-15 spirv-val").status != 0)
        GTEST_SKIP() << "llvm-spirv-15 or spirv-tools is not installed";
    const TemporaryFolder folder;
    const std::string code = quoted((folder.path() / "kernels.bc").string());
    const std::string words = quoted((folder.path() / "kernels.spv").string());
    for (const KernelFile& file : kernel_files()) {
        const KernelProgram program = programs_of(file).front();
        const Outcome outcome = run_in_shell(
            source_folder(), "clang-15 -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -Xclang "
                             "-disable-llvm-passes -emit-llvm -c -w -I . -target spir64-unknown-unknown -o " +
                                 code + " " + program.options + " kernels/" + program.file +
                                 " && llvm-spirv-15 --spirv-max-version=1.1 " + code + " -o " + words +
                                 " && spirv-val --target-env spv1.1 " + words);
        EXPECT_EQ(outcome.status, 0) << program.file << ": " << outcome.out << outcome.error;
    }
}

/// A card's assembler says what it sets aside. Clang does not optimise before: that takes two thirds of the time, and
/// leaves local memory as it is or takes some of it away.
TEST(KernelNeeds, LocalMemoryIsThatOfCompiledKernels)
{
    const std::string command =
        "clang-15 -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -O1 -Xclang -disable-llvm-passes -S -w -nogpulib "
        "-I . -target amdgcn-amd-amdhsa -mcpu=gfx900 -o - ";
    for (const KernelFile& file : kernel_files()) {
        if (content_of(source_folder() + "/kernels/" + file.name).find("    local ") == std::string::npos) continue;
        std::uint64_t largest = 0;
        for (const KernelProgram& program : programs_of(file)) {
            const Outcome outcome =
                run_in_shell(source_folder(), command + program.options + " kernels/" + program.file);
            const std::string key = "amdhsa_group_segment_fixed_size ";
            for (auto at = outcome.out.find(key); at != std::string::npos; at = outcome.out.find(key, at + 1))
                largest = std::max(largest, std::uint64_t{std::stoul(outcome.out.substr(at + key.size()))});
            if (file.name == "dart_throwing.cl") break; // its local memory is an argument
        }
        EXPECT_LE(largest, file.needs.local_bytes) << file.name;
    }
}

/// The compiler must not take this: a kernel that includes one of ours, and has a mistake.
TEST_P(OfflineCompiler, FindsMistakes)
{
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "mistaken.cl").string();
    std::ofstream(file) << "#include \"kernels/dart_throwing.cl\"\nkernel void wrong(global uint* x) { x = cell; }\n";
    EXPECT_THAT(errors_of(file, "-D DIMENSION=2 -D REACH=2 -D LARGE_DISKS=0", GetParam()),
                HasSubstr("undeclared identifier 'cell'"));
    EXPECT_THAT(errors_of("kernels/dart_throwing.cl", "", GetParam()), HasSubstr("'DIMENSION'"));
}

INSTANTIATE_TEST_SUITE_P(For, OfflineCompiler, testing::Values("spir64-unknown-unknown"));
INSTANTIATE_TEST_SUITE_P(Nightly, OfflineCompiler, testing::Values("nvptx64-nvidia-nvcl", "amdgcn-amd-amdhsa"));

/// Returns the compiler's words about padding at the end of records in a C++ source below the source folder.
std::string padded_records(const std::string& text)
{
    const TemporaryFolder folder;
    folder.write("records.cpp", text);
    const std::string file = quoted((folder.path() / "records.cpp").string());
    return run_in_shell(source_folder(),
                        "g++ -std=c++20 -fsyntax-only -I . -Wpadded " + file + " 2>&1 | grep 'struct size'")
        .out;
}

/// Mesa refuses arguments that end in padding.
TEST(KernelFiles, TakeNoRecordsThatEndInPadding)
{
    EXPECT_THAT(padded_records("struct Padded { long a; int b; };\n"), HasSubstr("records.cpp:1"));
    std::string contracts;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() + "/kernels/common"))
        if (entry.path().extension() == ".h")
            contracts += "#include \"" + entry.path().lexically_relative(source_folder()).string() + "\"\n";
    EXPECT_EQ(padded_records(contracts), "");
}

TEST(KernelFiles, ListEveryFile)
{
    std::vector<std::string> listed, there;
    for (const KernelFile& file : kernel_files()) listed.push_back(file.name);
    const std::filesystem::path folder = std::filesystem::path(source_folder()) / "kernels";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".cl") there.push_back(entry.path().lexically_relative(folder).string());
    EXPECT_THAT(there, testing::UnorderedElementsAreArray(listed));
}

/// Programs that are not listed are refused: the test above does not know of them.
TEST(KernelFiles, AreBuiltAsListedOnly)
{
    EXPECT_EQ(
        kernel_program("relaxation_dart_throwing.cl", {{"DIMENSION", 2}, {"COVER_BITS", 3}, {"REGION", 0}}).options,
        "-D DIMENSION=2 -D COVER_BITS=3 -D REGION=0");
    EXPECT_THROW(kernel_program("relaxation_dart_throwing.cl", {{"DIMENSION", 2}, {"COVER_BITS", 4}, {"REGION", 0}}),
                 std::logic_error);
    EXPECT_THROW(kernel_program("relaxation_dart_throwing.cl", {{"DIMENSION", 2}}), std::logic_error);
    EXPECT_THROW(kernel_program("repulsion.cl", {{"DIMENSIONS", 2}}), std::logic_error);
    EXPECT_THROW(kernel_program("repulsion.clh", {{"DIMENSION", 2}}), std::logic_error);
}

}
}
