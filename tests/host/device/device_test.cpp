// The device layer: what it lists, what it opens, and what it says when something fails.
#include "host/device/device.hpp"

#include "host/device/device_needs.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

#include <numeric>

namespace poissonlab {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Device, ListsAtLeastOne)
{
    const auto devices = list_devices();
    ASSERT_FALSE(devices.empty());
    EXPECT_GT(devices[0].compute_units, 0u);
    EXPECT_FALSE(devices[0].name.empty());
}

TEST(Device, OpensPoclByDefault) { EXPECT_EQ(Device::open().info().platform, "Portable Computing Language"); }

TEST(Device, OpensByNumberAndByPartOfAName)
{
    const std::string name = list_devices()[0].name;
    EXPECT_EQ(Device::open("0").info().name, name);
    EXPECT_EQ(Device::open("PTHREAD").info().name, name);
}

TEST(Device, RestrictsThreads) { EXPECT_EQ(Device::open({}, 1).info().compute_units, 1u); }

TEST(Device, SaysWhichDevicesThereAre)
{
    EXPECT_THAT(message_of<DeviceError>([] { Device::open("no such device"); }),
                AllOf(HasSubstr("\"no such device\""), HasSubstr("0: "), Not(HasSubstr("\n"))));
}

TEST(Device, CopiesBuffersBackAndForth)
{
    Device device = Device::open();
    auto buffer = device.buffer<std::uint32_t>(1000);
    std::vector<std::uint32_t> values(1000);
    std::iota(values.begin(), values.end(), 7u);
    buffer.write(values);
    EXPECT_EQ(buffer.read(0, 1000), values);
    EXPECT_EQ(buffer.read(990, 10), std::vector<std::uint32_t>(values.begin() + 990, values.end()));
    buffer.write(std::vector<std::uint32_t>(10, 0), 20);
    EXPECT_EQ(buffer.read(19, 12), (std::vector<std::uint32_t>{26, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 37}));
}

TEST(Device, PadsTheRangeToWholeGroups)
{
    Device device = Device::open();
    auto kernel =
        device.kernel_from_text("kernel void count(global uint* total) { atomic_inc(total); }", "count.cl", "count");
    auto total = device.buffer<std::uint32_t>(1);
    total.write(std::vector<std::uint32_t>(1, 0));
    kernel.run(65, 64, total);
    EXPECT_EQ(total.read(0, 1).at(0), 128u);
    kernel.run(0, 64, total);
    EXPECT_EQ(total.read(0, 1).at(0), 128u);
}

/// A driver that ends them early is one that the laboratory knows.
TEST(Device, RunsLoopsToTheirEnd)
{
    Device device = Device::open();
    auto kernel = device.kernel_from_text("kernel void count(uint end, global uint* n) { while (n[0] < end) ++n[0]; }",
                                          "count.cl", "count");
    auto counted = device.buffer<std::uint32_t>(1);
    counted.write(std::vector<std::uint32_t>(1, 0));
    kernel.run(1, 1, std::uint32_t{100'000}, counted);
    EXPECT_EQ(counted.read(0, 1).at(0), ends_loops_early(device.info().name) ? 65'535U : 100'000U);
}

TEST(Device, IsNotUsedWhereItEndsLoopsEarly)
{
    EXPECT_TRUE(ends_loops_early("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_FALSE(ends_loops_early("AMD Radeon RX 6600 (navi23, LLVM 15.0.6)"));
    ::unsetenv("POISSONLAB_SHORT_LOOPS");
    EXPECT_THAT(why_loops_are_unreliable("llvmpipe (LLVM 15.0.6, 256 bits)"), HasSubstr("after 65,535 iterations"));
    EXPECT_EQ(why_loops_are_unreliable("pthread-EPYC"), "");
}

TEST(Device, ShowsTheLogOfAKernelThatDoesNotBuild)
{
    Device device = Device::open();
    EXPECT_THAT(message_of<DeviceError>(
                    [&] { device.kernel_from_text("kernel void broken() { this is not C; }", "broken.cl", "broken"); }),
                AllOf(HasSubstr("broken.cl"), HasSubstr("clBuildProgram"), HasSubstr("CL_BUILD_PROGRAM_FAILURE"),
                      HasSubstr("error:")));
}

TEST(Device, NamesAKernelThatIsNotThere)
{
    Device device = Device::open();
    EXPECT_THAT(message_of<DeviceError>([&] { device.kernel_from_text("kernel void here() {}", "here.cl", "gone"); }),
                AllOf(HasSubstr("gone"), HasSubstr("clCreateKernel"), HasSubstr("CL_INVALID_KERNEL_NAME")));
}

TEST(Device, NamesTheKernelOfAFailedLaunch)
{
    Device device = Device::open();
    auto kernel = device.kernel_from_text("kernel void fill(global uint* x) { x[0] = 1; }", "fill.cl", "fill");
    auto x = device.buffer<std::uint32_t>(1);
    const std::size_t too_large = device.info().max_work_group_size * 2;
    EXPECT_THAT(message_of<DeviceError>([&] { kernel.run(1, too_large, x); }),
                AllOf(HasSubstr("fill"), HasSubstr("clEnqueueNDRangeKernel"), HasSubstr("CL_INVALID_WORK_GROUP_SIZE")));
}

TEST(Device, SaysHowMuchMemoryCouldNotBeHad)
{
    Device device = Device::open();
    EXPECT_THAT(message_of<DeviceError>([&] { device.buffer<std::uint32_t>(std::size_t{1} << 45); }),
                AllOf(HasSubstr("140737488355328 bytes"), HasSubstr("CL_INVALID_BUFFER_SIZE")));
}

}
}
