// Devices that are made up lack some of what kernels need.
#include "host/device/device_needs.hpp"

#include "host/device/device.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

const KernelNeeds doubles{.double_precision = true};

DeviceInfo device_with(const std::string& name, bool has_double_precision, std::uint64_t local_memory_bytes)
{
    DeviceInfo device;
    device.name = name;
    device.has_double_precision = has_double_precision;
    device.local_memory_bytes = local_memory_bytes;
    return device;
}

TEST(DeviceNeeds, AreMetOrNamed)
{
    const DeviceInfo device = device_with("small", false, 16 << 10);
    EXPECT_EQ(lacking({}, device), "");
    EXPECT_EQ(lacking(doubles, device), "double precision");
    EXPECT_EQ(lacking({.local_bytes = 16 << 10}, device), "");
    EXPECT_EQ(lacking({.local_bytes = 17 << 10}, device), "17.0 KiB of local memory");
    EXPECT_TRUE(can_run({}, device));
    EXPECT_FALSE(can_run(doubles, device));
}

TEST(DeviceNeeds, OfADeviceThatCannotBeUsedAreNotMet)
{
    DeviceInfo device = device_with("broken", true, 1 << 20);
    device.unusable = "the driver reports no compute units";
    EXPECT_FALSE(can_run({}, device));
}

TEST(DeviceNeeds, AreThoseOfAllFilesTogether)
{
    EXPECT_FALSE(needs_of({"dart_throwing.cl", "darts_in_order.cl"}).double_precision);
    EXPECT_TRUE(needs_of({"dart_throwing.cl", "power_cells.cl"}).double_precision);
    EXPECT_EQ(needs_of({"tile_darts.cl"}), all_kernel_needs());
    EXPECT_THROW(needs_of({"voronoi_1d.cl"}), std::logic_error);
}

TEST(DeviceNeeds, AreSaidWithADeviceThatMeetsThem)
{
    const DeviceInfo card = device_with("Arc A770", false, 64 << 10);
    const DeviceInfo processor = device_with("pthread-EPYC", true, 512 << 10);
    EXPECT_STREQ(lack_error("lloyd", doubles, card, {card, processor}).what(),
                 "lloyd needs double precision, which Arc A770 has not; --device 1 (pthread-EPYC) has it");
    EXPECT_STREQ(lack_error("lloyd", doubles, card, {card}).what(),
                 "lloyd needs double precision, which Arc A770 has not; no OpenCL device here has it, and the "
                 "reference engine needs none");
}

/// Before the compiler is asked: the message is one line.
TEST(DeviceNeeds, AreAskedBeforeAKernelIsBuilt)
{
    Device device = Device::open();
    KernelProgram program = kernel_program("voronoi_2d.cl", {{"DOUBLES", 1}});
    program.needs.local_bytes = std::uint64_t{1} << 40;
    try {
        device.kernel(program, "find_centroids");
        FAIL();
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("Lloyd relaxation needs 1.0 TiB of local memory, which "));
    }
}

}
}
