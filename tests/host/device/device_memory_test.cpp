// Memory of devices: sums, comparisons, and what an open device counts.
#include "host/device/device_memory.hpp"

#include "host/device/device.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

constexpr std::uint64_t mebi = 1 << 20;

TEST(DeviceMemory, AddsBuffersAndTakesTheLargerOfTurns)
{
    DeviceMemory a;
    a.add(100).add(80);
    EXPECT_EQ(a, (DeviceMemory{100, 180}));
    const DeviceMemory b{150, 160};
    EXPECT_EQ(a + b, (DeviceMemory{150, 340}));
    EXPECT_EQ(either(a, b), (DeviceMemory{150, 180}));
}

TEST(DeviceMemory, FitsUpToTheLastByte)
{
    DeviceInfo device;
    device.global_memory_bytes = 1000;
    device.max_allocation_bytes = 250;
    EXPECT_TRUE(fits({250, 1000}, device));
    EXPECT_FALSE(fits({251, 1000}, device));
    EXPECT_FALSE(fits({250, 1001}, device));
}

TEST(DeviceMemory, SaysWhatIsNeededAndWhatThereIs)
{
    DeviceInfo device;
    device.name = "Small GPU";
    device.global_memory_bytes = 512 * mebi;
    device.max_allocation_bytes = 128 * mebi;
    check_fits("set.ptiles", {mebi, mebi}, device);
    EXPECT_EQ(
        message_of([&] {
            check_fits("set.ptiles", {1536 * mebi, 3072 * mebi}, device);
        }),
        "set.ptiles: needs 3.0 GiB of device memory, 1.5 GiB of it in one piece; Small GPU has 512.0 MiB, 128.0 MiB "
        "in one piece");
}

TEST(DeviceMemory, IsShownInUnitsOfItsSize)
{
    EXPECT_EQ(bytes_text(1023), "1023 bytes");
    EXPECT_EQ(bytes_text(1024), "1.0 KiB");
    EXPECT_EQ(bytes_text(mebi - 1), "1.0 MiB") << "not 1024.0 KiB";
    EXPECT_EQ(bytes_text(UINT64_MAX), "16.0 EiB");
}

TEST(DeviceMemory, IsCountedByTheDevice)
{
    Device device = Device::open();
    const std::uint64_t before = device.memory().total;
    device.watch_memory();
    {
        const auto a = device.buffer<std::uint32_t>(100);
        {
            const auto b = device.buffer<double>(1000);
            const auto same = b;
            EXPECT_EQ(device.memory(), (DeviceMemory{8000, before + 8400}));
        }
        EXPECT_EQ(device.memory().total, before + 400);
    }
    EXPECT_EQ(device.memory().total, before);
    EXPECT_EQ(device.peak_memory(), (DeviceMemory{8000, before + 8400}));
}

TEST(DeviceMemory, OfAReplacedBufferIsFreeBeforeTheNewOneIs)
{
    Device device = Device::open();
    auto buffer = device.buffer<std::uint8_t>(1000);
    const std::uint64_t before = device.memory().total - 1000;
    device.watch_memory();
    reserve(device, buffer, 2000);
    EXPECT_EQ(device.peak_memory().total, before + 2000);
    reserve(device, buffer, 1500);
    EXPECT_EQ(buffer.size(), 2000u);
}

TEST(DeviceMemory, OfEveryDeviceIsKnown)
{
    for (const DeviceInfo& device : list_devices()) {
        EXPECT_GT(device.max_allocation_bytes, 0u);
        EXPECT_LE(device.max_allocation_bytes, device.global_memory_bytes);
    }
}

}
}
