// Every kernel file is compiled by the driver of the device at hand, down to the code of each kernel: PoCL, and Mesa's
// rusticl, which goes by SPIR-V and NIR as drivers of graphics cards do (on_other_device.sh).
//
// A driver without double precision stops in its front end at files that need it, and cannot say more: calls with
// doubles are ambiguous to it. That these files are right otherwise, offline_compiler_test.cpp says.
#include "host/device/device.hpp"
#include "host/device/device_needs.hpp"
#include "host/device/kernel_source.hpp"
#include "tests/kernels/kernel_programs.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>

namespace poissonlab {
namespace {

std::vector<std::string> kernels_in(const std::string& text)
{
    static const std::regex kernel(R"(\nkernel void (\w+)\()");
    std::vector<std::string> names;
    for (std::sregex_iterator found(text.begin(), text.end(), kernel), end; found != end; ++found)
        names.push_back((*found)[1]);
    return names;
}

class DriverCompiler : public testing::TestWithParam<std::string>
{
protected:
    const KernelFile& file() const { return *std::ranges::find(kernel_files(), GetParam(), &KernelFile::name); }

    void compile(const KernelProgram& program)
    {
        const std::string text = kernel_source("kernels/" + program.file);
        const std::vector<std::string> names = kernels_in(text);
        ASSERT_FALSE(names.empty()) << program.file;
        const auto build = [&] {
            for (const std::string& name : names) device_.kernel_from_text(text, program.file, name, program.options);
        };
        if (lacking(program.needs, device_.info()).empty()) {
            EXPECT_NO_THROW(build()) << program.file << " " << program.options;
        } else {
            EXPECT_THAT(message_of<DeviceError>(build), testing::HasSubstr("double")) << program.file;
        }
    }

    Device device_ = Device::open();
};

TEST_P(DriverCompiler, TakesAProgramOfEachFile) { compile(programs_of(file()).front()); }

class EveryProgram : public DriverCompiler
{
};

TEST_P(EveryProgram, IsTaken)
{
    for (const KernelProgram& program : programs_of(file())) compile(program);
}

std::vector<std::string> names_of_files()
{
    std::vector<std::string> names;
    for (const KernelFile& file : kernel_files()) names.push_back(file.name);
    return names;
}

/// "textures_texture_map" for "textures/texture_map.cl".
std::string name_of_case(const testing::TestParamInfo<std::string>& info)
{
    std::string name = info.param.substr(0, info.param.find('.'));
    std::ranges::replace(name, '/', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(For, DriverCompiler, testing::ValuesIn(names_of_files()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Nightly, EveryProgram, testing::ValuesIn(names_of_files()), name_of_case);

}
}
