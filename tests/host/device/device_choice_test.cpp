// Which device a number or a name means, on machines that are made up.
#include "host/device/device.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<std::pair<std::string, std::string>> machine{
    {"NVIDIA H200", "NVIDIA CUDA"},
    {"NVIDIA H200 NVL", "NVIDIA CUDA"},
    {"pthread-EPYC 7763", "Portable Computing Language"},
    {"Intel UHD 770", "Intel OpenCL"},
};

std::vector<DeviceInfo> devices_of(const std::vector<std::pair<std::string, std::string>>& names)
{
    std::vector<DeviceInfo> devices;
    for (const auto& [name, platform] : names) {
        DeviceInfo info;
        info.name = name;
        info.platform = platform;
        info.has_double_precision = true;
        info.local_memory_bytes = 32 << 10;
        devices.push_back(info);
    }
    return devices;
}

std::string refusal(const std::vector<DeviceInfo>& devices, const std::string& selector)
{
    return message_of<DeviceError>([&] { choose_device(devices, selector); });
}

TEST(DeviceChoice, ByNumberNameAndUniquePart)
{
    const auto devices = devices_of(machine);
    EXPECT_EQ(choose_device(devices, "3"), 3u);
    EXPECT_EQ(choose_device(devices, "nvidia h200"), 0u) << "a whole name, though it is a part of another";
    EXPECT_EQ(choose_device(devices, "NVL"), 1u);
    EXPECT_EQ(choose_device(devices, "portable"), 2u) << "the platform";
    EXPECT_EQ(choose_device(devices, "epyc"), 2u);
}

TEST(DeviceChoice, ByTheEnvironmentWhereNoneIsNamed)
{
    const auto devices = devices_of(machine);
    ::setenv("POISSONLAB_DEVICE", "UHD", 1);
    EXPECT_EQ(choose_device(devices, ""), 3u);
    EXPECT_EQ(choose_device(devices, "epyc"), 2u);
    ::setenv("POISSONLAB_DEVICE", "Arc", 1);
    EXPECT_THAT(refusal(devices, ""), HasSubstr("no OpenCL device matches \"Arc\""));
    ::unsetenv("POISSONLAB_DEVICE");
    EXPECT_EQ(choose_device(devices, ""), 2u);
}

TEST(DeviceChoice, PoclByDefaultElseTheFirstUsable)
{
    auto devices = devices_of(machine);
    EXPECT_EQ(choose_device(devices, ""), 2u);
    devices[2].unusable = "no compiler";
    EXPECT_EQ(choose_device(devices, ""), 0u);
    devices[0].unusable = "no compiler";
    EXPECT_EQ(choose_device(devices, ""), 1u);
}

TEST(DeviceChoice, TheFirstThatRunsWhatIsAskedByDefault)
{
    const KernelNeeds doubles{.double_precision = true};
    auto devices = devices_of(machine);
    devices[0].has_double_precision = devices[2].has_double_precision = false;
    EXPECT_EQ(choose_device(devices, "", {}), 2u) << "PoCL runs it";
    EXPECT_EQ(choose_device(devices, "", doubles), 1u);
    EXPECT_EQ(choose_device(devices, "0", doubles), 0u) << "who names a device gets it";
    devices[1].unusable = "no compiler";
    devices[3].has_double_precision = false;
    EXPECT_EQ(choose_device(devices, "", doubles), 2u) << "parts of the work may be done there";
}

TEST(DeviceChoice, RefusesNumbersOutOfRange)
{
    // 770 and 7763 are parts of names, but digits alone are a number.
    for (const std::string number : {"4", "770", "99999999999999999999999"}) {
        EXPECT_THAT(refusal(devices_of(machine), number), AllOf(HasSubstr("no OpenCL device " + number + ";"),
                                                                HasSubstr("3: Intel UHD 770"), Not(HasSubstr("\n"))));
    }
}

TEST(DeviceChoice, RefusesNamesOfSeveral)
{
    EXPECT_THAT(refusal(devices_of(machine), "cuda"),
                AllOf(HasSubstr("\"cuda\" matches several"), HasSubstr("0: NVIDIA H200, 1: NVIDIA H200 NVL"),
                      Not(HasSubstr("Intel")), Not(HasSubstr("\n"))));
}

TEST(DeviceChoice, TakesAnyOfSeveralAlike)
{
    const auto devices = devices_of({machine[2], machine[0], machine[0]});
    EXPECT_EQ(choose_device(devices, "cuda"), 1u);
    EXPECT_EQ(choose_device(devices, "2"), 2u);
}

TEST(DeviceChoice, RefusesWhereThereIsNoneOrNoSuch)
{
    EXPECT_THAT(refusal({}, ""), HasSubstr("no OpenCL device found"));
    EXPECT_THAT(refusal({}, "0"), HasSubstr("no OpenCL device found"));
    EXPECT_THAT(refusal(devices_of(machine), "radeon"), AllOf(HasSubstr("\"radeon\""), HasSubstr("0: NVIDIA H200")));
}

}
}
